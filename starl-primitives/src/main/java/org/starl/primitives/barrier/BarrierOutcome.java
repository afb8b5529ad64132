package org.starl.primitives.barrier;

import static org.starl.shape.Shapes.PROCESS;
import static org.starl.shape.Shapes.part;

import java.util.Collections;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/** The outcome of the generation in which a robot arrived last, as the robot was told. */
public sealed interface BarrierOutcome {

  /** None yet: the robot never arrived, or waits. */
  BarrierOutcome NONE_YET = new NoneYet();

  /** Its shape. */
  Shape<BarrierOutcome> SHAPE = shape();

  /** Whether the latest wait is over. */
  boolean isTold();

  /** No outcome yet. */
  record NoneYet() implements BarrierOutcome {
    @Override
    public boolean isTold() {
      return false;
    }

    @Override
    public String toString() {
      return "null";
    }
  }

  /** All members of the generation arrived. */
  record Passed(long generation) implements BarrierOutcome {
    @Override
    public boolean isTold() {
      return true;
    }

    /** {@code 3:passed}. */
    @Override
    public String toString() {
      return generation + ":passed";
    }
  }

  /**
   * The generation ended without some of its members. They are no members of later generations.
   *
   * @param missing the excluded members: silent, or absent at the deadline; one of them may have
   *     arrived too late to count
   */
  record Failed(long generation, SortedSet<ProcessId> missing) implements BarrierOutcome {
    @Override
    public boolean isTold() {
      return true;
    }

    public Failed {
      missing = Collections.unmodifiableSortedSet(new TreeSet<>(missing));
    }

    /** {@code 3:failed[bot1, bot2]}. */
    @Override
    public String toString() {
      return generation + ":failed" + missing;
    }
  }

  /**
   * The others went on without this robot: it is no longer a member. It can take part in another
   * barrier, such as one among the robots registered then.
   *
   * @param generation the one that excluded it; 0 if it was never a member
   */
  record Excluded(long generation) implements BarrierOutcome {
    @Override
    public boolean isTold() {
      return true;
    }

    /** {@code 3:excluded}. */
    @Override
    public String toString() {
      return generation + ":excluded";
    }
  }

  /**
   * No decision within two deadlines, since no majority was in reach. The arrival still counts; to
   * arrive again means to go on waiting for the same generation.
   */
  record Unknown(long generation) implements BarrierOutcome {
    @Override
    public boolean isTold() {
      return true;
    }

    /** {@code 3:unknown}. */
    @Override
    public String toString() {
      return generation + ":unknown";
    }
  }

  private static Shape<BarrierOutcome> shape() {
    Shape<Long> generation = Shapes.atLeast(1, "generation");
    return Shapes.oneOf(
        BarrierOutcome.class,
        Shapes.of(NoneYet.class, NoneYet::new),
        Shapes.of(Passed.class, part("generation", generation, Passed::generation), Passed::new),
        Shapes.of(
            Failed.class,
            part("generation", generation, Failed::generation),
            part("missing", Shapes.set(PROCESS, 0xFFFF), Failed::missing),
            Failed::new),
        Shapes.of(
            Excluded.class,
            part("generation", Shapes.atLeast(0, "generation"), Excluded::generation),
            Excluded::new),
        Shapes.of(
            Unknown.class, part("generation", generation, Unknown::generation), Unknown::new));
  }
}
