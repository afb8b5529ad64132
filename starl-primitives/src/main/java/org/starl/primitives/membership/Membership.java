package org.starl.primitives.membership;

import java.util.SortedSet;
import java.util.function.Consumer;
import org.starl.id.ProcessId;
import org.starl.platform.Waits;

/** The participants, as this robot has learned them. Strand only. */
public interface Membership {

  /**
   * This robot's participant. It changes only by a new registration, and may be in no view yet.
   */
  ProcessId me();

  /** The latest view that this robot has learned, or {@link View#NONE}. */
  View view();

  /**
   * Whether {@link #me} is in {@link #view} and has not begun to leave. Only then may it request the
   * others' consent: they may forget a leaving participant at any moment.
   */
  boolean mayRequest();

  /**
   * Takes part again, if the others have given this robot up, and waits for it, inside a call of the
   * app.
   *
   * @param timeoutMs how long at most, above 0
   * @param then goes on; it gets {@link #mayRequest}
   */
  default void register(Waits<?> call, long timeoutMs, Consumer<Boolean> then) {
    then.accept(mayRequest());
  }

  /**
   * Calls {@code listener} on the strand after each change of {@link #view}, {@link #me} or {@link
   * #mayRequest}, in the same strand piece as the change.
   */
  void onChange(Runnable listener);

  /**
   * Makes {@code member} the user of these views, which is asked before this robot leaves. There is
   * one: a confinement tells the sections of one user only.
   *
   * @throws IllegalStateException if there is one already
   */
  void join(Member member);

  /**
   * Asks other robots for the latest view. For a user that waits for a silent participant, which may
   * have left.
   */
  void refresh();

  /** Whether participants can be given up, so that {@link #propose} has an effect. */
  boolean confines();

  /** Works for a view with {@code confinement}, until there is one or it is void. */
  void propose(Confinement confinement);

  /**
   * {@code id} of this robot holds nothing and will never request anything again: it may be removed.
   * If it is {@link #me}, this robot is no longer registered.
   */
  void markIdle(ProcessId id);

  /**
   * Declares that this robot's participants of earlier program starts are dead, and that its body is in
   * no section but these. A later call replaces this one.
   */
  void standsIn(SortedSet<String> sections);

  /** The user of the views. */
  @FunctionalInterface
  interface Member {

    /**
     * This robot is about to leave: cancels what it waits for, and requests nothing from now on.
     *
     * @throws IllegalStateException if it holds something, which other robots would no longer know
     */
    void prepareToLeave();
  }

  /** A closed group: always {@code view}. */
  static Membership closed(ProcessId me, View view) {
    return new ClosedGroup(me, view);
  }
}
