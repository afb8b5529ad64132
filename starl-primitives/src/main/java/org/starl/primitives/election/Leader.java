package org.starl.primitives.election;

import org.starl.id.ProcessId;

/** The paper's {@code Leader} (section 4.4): an identity, null, or fail. */
public sealed interface Leader {

  /** The paper's null: no election yet, or one is in progress. */
  Leader NONE = new None();

  /** The paper's fail: the election in progress has met its deadline. */
  Leader FAIL = new Fail();

  /**
   * Reads what {@code toString} wrote.
   *
   * @throws IllegalArgumentException if {@code text} is no leader
   */
  static Leader parse(String text) {
    int colon = text.indexOf(':');
    if (colon > 0) {
      long term = Long.parseLong(text.substring(0, colon));
      return new Name(ProcessId.parse(text.substring(colon + 1)), term);
    }
    return switch (text) {
      case "null" -> NONE;
      case "fail" -> FAIL;
      default ->
          throw new IllegalArgumentException(
              "leader '" + text + "': expected null, fail or term:robot#incarnation");
    };
  }

  /** Whether a leader is known. */
  boolean isElected();

  /**
   * The elected leader.
   *
   * @param id one incarnation of one robot; a restarted robot has another id
   * @param term from 1; equal terms of one instance mean equal leaders, always
   */
  record Name(ProcessId id, long term) implements Leader {
    @Override
    public boolean isElected() {
      return true;
    }

    /** {@code 3:bot1#4294967297}: term, then id. */
    @Override
    public String toString() {
      return term + ":" + id;
    }
  }

  /** No leader yet. */
  record None() implements Leader {
    @Override
    public boolean isElected() {
      return false;
    }

    @Override
    public String toString() {
      return "null";
    }
  }

  /** No leader by the deadline. If the election is decided later, the name replaces this. */
  record Fail() implements Leader {
    @Override
    public boolean isElected() {
      return false;
    }

    @Override
    public String toString() {
      return "fail";
    }
  }
}
