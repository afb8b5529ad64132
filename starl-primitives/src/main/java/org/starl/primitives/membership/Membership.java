package org.starl.primitives.membership;

import org.starl.ProcessId;

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
   * Asks others for the latest view: for one who waits for the answer of a participant that stays
   * silent, and may have left.
   */
  default void refresh() {
    // A closed group has no later view.
  }

  /** A closed group: {@code view} for ever. */
  static Membership closed(ProcessId me, View view) {
    return new Membership() {
      @Override
      public ProcessId me() {
        return me;
      }

      @Override
      public View view() {
        return view;
      }

      @Override
      public boolean mayRequest() {
        return view.contains(me);
      }

      @Override
      public void onChange(Runnable listener) {
        // A closed group never changes.
      }
    };
  }
}
