package org.starl.primitives.barrier;

import java.util.Collections;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.id.ProcessId;

/** What a robot has been told of the generation in which it arrived last. */
public sealed interface BarrierOutcome {

  /** Nothing yet: never arrived, or waiting. */
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
            + "': expected null, or generation: and passed, failed[..], excluded or"
            + " unknown");
  }

  /** Whether the latest wait is over. */
  boolean isTold();

  /** Nobody has told anything. */
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
   * The generation is over without some of its members, who are none of the next one.
   *
   * @param missing who is left out: silent, or not there by the deadline; one of them may have
   *     arrived too late to be counted
   */
  record Failed(long generation, SortedSet<ProcessId> missing) implements BarrierOutcome {
    public Failed {
      missing = Collections.unmodifiableSortedSet(new TreeSet<>(missing));
    }

    @Override
    public boolean isTold() {
      return true;
    }

    /** {@code 3:failed[bot1#1, bot2#1]}. */
    @Override
    public String toString() {
      return generation + ":failed" + missing;
    }
  }

  /**
   * The others have gone on without this robot: it is no member any more, and comes back only into
   * another barrier, such as one among those who are registered then.
   *
   * @param generation the one that left it out; 0 if it never was a member
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
   * No decision within two deadlines: no majority in reach. The arrival stands; to arrive again is to
   * wait on for the same generation.
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
