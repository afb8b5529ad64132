package org.starl.primitives.barrier;

import java.util.Collections;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.id.ProcessId;

/** The outcome of the generation in which a robot arrived last, as the robot was told. */
public sealed interface BarrierOutcome {

  /** None yet: the robot never arrived, or waits. */
  BarrierOutcome NONE_YET = new NoneYet();

  /**
   * Reads what {@code toString} wrote.
   *
   * @throws IllegalArgumentException if {@code text} is no outcome
   */
  static BarrierOutcome parse(String text) {
    if (text.equals("null")) {
      return NONE_YET;
    }
    int colon = text.indexOf(':');
    if (colon > 0) {
      long generation = Long.parseLong(text.substring(0, colon));
      String what = text.substring(colon + 1);
      if (what.equals("passed")) {
        return new Passed(generation);
      }
      if (what.equals("excluded")) {
        return new Excluded(generation);
      }
      if (what.equals("unknown")) {
        return new Unknown(generation);
      }
      if (what.startsWith("failed[") && what.endsWith("]")) {
        SortedSet<ProcessId> missing = new TreeSet<>();
        for (String id : what.substring("failed[".length(), what.length() - 1).split(", ", -1)) {
          missing.add(ProcessId.parse(id));
        }
        return new Failed(generation, missing);
      }
    }
    throw new IllegalArgumentException(
        "outcome '"
            + text
            + "': expected null, or a generation and a colon, then passed, failed[..], excluded"
            + " or unknown");
  }

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

    /** {@code 3:failed[bot1#1, bot2#1]}. */
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
}
