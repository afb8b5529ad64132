package org.starl.primitives.registration;

import static org.starl.shape.Shapes.LONG;
import static org.starl.shape.Shapes.part;

import org.starl.id.Participants;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * The paper's pair {@code <rList, ts>} (section 4.3): the agreed list and its time stamp, or null
 * if there is none.
 */
public sealed interface RList {

  /** The shape of its values. */
  Shape<RList> SHAPE =
      Shapes.oneOf(
          RList.class,
          Shapes.of(
              Agreed.class,
              part("list", Shapes.PARTICIPANTS, Agreed::list),
              part("ts", LONG, Agreed::ts),
              Agreed::new),
          Shapes.of(Unknown.class, Unknown::new));

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
