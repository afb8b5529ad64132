package org.starl.primitives.registration;

import org.starl.id.Participants;

/**
 * The paper's pair {@code <rList, ts>} (section 4.3): the agreed list and its time stamp, or null
 * if there is none.
 */
public sealed interface RList {

  /** The paper's null. */
  RList UNKNOWN = new Unknown();

  /** Whether there is a list: the paper's "rList is not null". */
  boolean isAgreed();

  /**
   * A list that contains this robot.
   *
   * @param ts the number of the view; equal numbers mean equal lists
   */
  record Agreed(Participants list, long ts) implements RList {
    @Override
    public boolean isAgreed() {
      return true;
    }

    /** {@code 3:[bot0, bot2]}: time stamp, then list. */
    @Override
    public String toString() {
      return ts + ":" + list;
    }
  }

  /** No list, or a newer one may be coming. */
  record Unknown() implements RList {
    @Override
    public boolean isAgreed() {
      return false;
    }

    @Override
    public String toString() {
      return "null";
    }
  }
}
