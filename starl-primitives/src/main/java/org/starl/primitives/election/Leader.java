package org.starl.primitives.election;

import static org.starl.shape.Shapes.PROCESS;
import static org.starl.shape.Shapes.part;

import org.starl.id.ProcessId;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/** The paper's {@code Leader} (section 4.4): an identity, null, or fail. */
public sealed interface Leader {

  /** The paper's null: no election yet, or one is in progress. */
  Leader NONE = new None();

  /** The paper's fail: the election in progress has met its deadline. */
  Leader FAIL = new Fail();

  /** Its shape. */
  Shape<Leader> SHAPE =
      Shapes.oneOf(
          Leader.class,
          Shapes.of(
              Name.class,
              part("id", PROCESS, Name::id),
              part("term", Shapes.atLeast(1, "election term"), Name::term),
              Name::new),
          Shapes.of(None.class, None::new),
          Shapes.of(Fail.class, Fail::new));

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

    /** {@code 3:bot1}: term, then id. */
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
