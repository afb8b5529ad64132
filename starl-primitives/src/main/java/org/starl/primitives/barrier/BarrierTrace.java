package org.starl.primitives.barrier;

import java.util.List;
import org.starl.primitives.Phases;
import org.starl.primitives.agreement.SynodMessage;

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

  private static final String IDLE = "IDLE";
  private static final String WAITING = "WAITING";
  private static final String PASSED = "PASSED";
  private static final String FAILED = "FAILED";

  /** The phases of the latest wait: none yet, going on, passed, and failed in any way. */
  public static final Phases PHASES =
      Phases.of(
              PRIMITIVE,
              BarrierMessage.class,
              () -> BarrierTrace::phase,
              IDLE,
              WAITING,
              PASSED,
              FAILED)
          .with(SYNOD, SynodMessage.class);

  private BarrierTrace() {}

  private static String phase(String before, String name, List<String> texts) {
    return switch (name) {
      case ARRIVE -> WAITING;
      case OUTCOME -> outcome(before, texts.get(0));
      default -> before;
    };
  }

  private static String outcome(String before, String outcome) {
    if (outcome.equals("null")) {
      return before;
    }
    return outcome.endsWith(":passed") ? PASSED : FAILED;
  }

  /** Whether {@code source} is a barrier, as in {@code barrier/convoy}. */
  static boolean isBarrier(String source) {
    return source.startsWith(PRIMITIVE + "/");
  }
}
