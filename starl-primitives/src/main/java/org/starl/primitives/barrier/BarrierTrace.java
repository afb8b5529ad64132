package org.starl.primitives.barrier;

/**
 * The names of barriers in a trace. Ids are as {@link org.starl.id.ProcessId#parse} reads them.
 */
public final class BarrierTrace {

  public static final String PRIMITIVE = "barrier";

  /** The Synod's own channel. */
  static final String SYNOD = "barrier.synod";

  /** Action with the robot's id, then those of the members of generation 1. */
  static final String BARRIER = "Barrier";

  /** Action with a generation and the id that arrives in it. */
  static final String ARRIVE = "arrive";

  /**
   * Variable: {@code null}; or generation and {@code passed}, {@code failed} with the missing ids,
   * {@code excluded} or {@code unknown}.
   */
  public static final String OUTCOME = "outcome";

  private BarrierTrace() {}

  /** Whether {@code source} is a barrier, as in {@code barrier/convoy}. */
  static boolean isBarrier(String source) {
    return source.startsWith(PRIMITIVE + "/");
  }
}
