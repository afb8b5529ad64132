package org.starl.primitives.membership;

import java.util.SortedSet;
import org.starl.id.ProcessId;

/** Who takes part, as this robot has learned it. Strand only. */
public interface Membership {

  /**
   * This robot's participant; changes only through a new registration, and may stand in no view yet.
   */
  ProcessId me();

  /** The latest view that this robot has learned, or {@link View#NONE}. */
  View view();

  /**
   * Whether {@link #me} stands in {@link #view} and has not begun to leave. Only then may it begin
   * what needs the others' consent: who has asked to leave may be forgotten by them at any moment.
   */
  boolean mayRequest();

  /**
   * Calls {@code listener} on the strand after each change of {@link #view}, {@link #me} or {@link
   * #mayRequest}, in the same piece of the strand as the change.
   */
  void onChange(Runnable listener);

  /**
   * Makes {@code member} the one who acts by these views and is asked before this robot leaves. There
   * is one: what a confined participant may hold is known of one member's sections only.
   *
   * @throws IllegalStateException if there is one already
   */
  void join(Member member);

  /**
   * Asks others for the latest view: for one who waits for the answer of a participant that stays
   * silent, and may have left.
   */
  void refresh();

  /** Whether participants can be given up: whether {@link #propose} leads to anything. */
  boolean confines();

  /** Works for a view in which {@code confinement} is done, until there is one or it is void. */
  void propose(Confinement confinement);

  /**
   * {@code id}, one of this robot's, will never request anything again, holds nothing, and may be
   * dropped. If it is {@link #me}, this robot is not registered from now on.
   */
  void isIdleForEver(ProcessId id);

  /**
   * The own word of this robot on its participants of earlier starts of its program: they are dead,
   * and its body is in no other section than these. A later word takes the place of this one.
   */
  void standsIn(SortedSet<String> sections);

  /** Who acts by the views. */
  @FunctionalInterface
  interface Member {

    /**
     * This robot is about to leave: gives up what it waits for, and requests nothing from now on.
     *
     * @throws IllegalStateException if it holds something, which nobody would know of any more
     */
    void leaves();
  }

  /** A closed group: {@code view} for ever. */
  static Membership closed(ProcessId me, View view) {
    return new ClosedGroup(me, view);
  }
}
