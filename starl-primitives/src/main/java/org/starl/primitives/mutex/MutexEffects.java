package org.starl.primitives.mutex;

import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;

/** The effects of a {@link MutexProtocol}, called within its steps; must not call back. */
interface MutexEffects {

  void send(MutexMessage message);

  /** A request begins; it needs the consent of {@code known}. */
  void requested(long num, long ts, SortedSet<String> want, SortedSet<ProcessId> known);

  /** The participants whose consent a request needs, or would need now, have changed. */
  void known(long num, SortedSet<ProcessId> known);

  /** Request {@code num} of {@code to} is granted for the first time. */
  void granted(ProcessId to, long num);

  void entered(long num, SortedSet<String> held);

  void released(long num, SortedSet<String> given, SortedSet<String> left);

  /** The request ended without access; number 0 if it never began. */
  void failed(long num, MutexFailure why);

  void learned(View view);

  /** Fences {@code suspect}, which may still hold {@code open}. */
  void fenced(ProcessId suspect, SortedSet<String> open);

  /** Asks for a view with {@code confinement}. */
  void propose(Confinement confinement);

  /** Asks for the latest view. */
  void refresh();

  /** This participant is fenced or removed, and holds no section any more. */
  void markIdle();
}
