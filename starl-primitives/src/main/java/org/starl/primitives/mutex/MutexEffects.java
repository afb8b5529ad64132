package org.starl.primitives.mutex;

import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;

/** Takes messages and outcomes, inside the call that brings them about; must not call back. */
interface MutexEffects {

  void send(MutexMessage message);

  /** A request begins, and {@code known} is whom it needs. */
  void requested(long num, long ts, SortedSet<String> want, SortedSet<ProcessId> known);

  /** Whom the current request needs, or would need if it began now, has changed to this. */
  void known(long num, SortedSet<ProcessId> known);

  /** Request {@code num} of {@code to} is granted for the first time. */
  void granted(ProcessId to, long num);

  void entered(long num, SortedSet<String> held);

  void released(long num, SortedSet<String> given, SortedSet<String> left);

  /** The request ended without access; number 0 if it did not even begin. */
  void failed(long num, MutexFailure why);

  void learned(View view);

  /** Nothing more is granted to {@code suspect}, which may still hold {@code open}. */
  void fenced(ProcessId suspect, SortedSet<String> open);

  /** Asks for a view in which {@code confinement} is done. */
  void propose(Confinement confinement);

  /** Asks for the latest view. */
  void refresh();

  /** Others have given this participant up, and it holds nothing any more. */
  void markIdle();
}
