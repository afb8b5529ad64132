package org.starl.primitives.mutex;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;

/** The effects of a {@link MutexProtocol}, called within its steps; must not call back. */
interface MutexEffects {

  void send(MutexMessage message);

  /**
   * A request begins, or is made anew; it needs the consent of {@code known}.
   *
   * @param want what it holds or waits for
   * @param sequence what it waits for, in order; empty for a set, which is granted at once
   * @param resumes whether it takes all of it over from the robot's earlier processes
   */
  void requested(
      long num,
      long ts,
      SortedSet<String> want,
      List<String> sequence,
      boolean resumes,
      SortedSet<ProcessId> known);

  /** The participants whose consent a request needs, or would need now, have changed. */
  void known(long num, SortedSet<ProcessId> known);

  /** It consents to {@code part} of request {@code num} of {@code to}, or to all of it if empty. */
  void granted(ProcessId to, long num, SortedSet<String> part);

  /** It now holds {@code held}: all of a set, or more of a sequence than before. */
  void entered(long num, SortedSet<String> held);

  /** It has released {@code given} and holds {@code left}. */
  void released(long num, SortedSet<String> given, SortedSet<String> left);

  /** The request waits no longer, without access to the rest; number 0 if it never began. */
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
