package org.starl.workload;

import java.util.Map;
import java.util.TreeMap;
import org.starl.GlobalVarHolder;
import org.starl.primitives.barrier.Barrier;
import org.starl.primitives.barrier.BarrierOutcome;
import org.starl.primitives.barrier.BarrierSettings;
import org.starl.primitives.barrier.BarrierSpec;
import org.starl.primitives.registration.Registration;
import org.starl.spec.Deadlines;
import org.starl.time.Time;

/**
 * The registered robots meet, generation after generation, at a barrier for each view. A robot that
 * restarts or was excluded registers again, which starts another barrier. A robot that has done all
 * its rounds stays registered, to vote for the others; their barrier excludes it, and they continue
 * without it.
 */
final class BarrierClient extends Client {

  private static final String XID = "yard";
  private static final long THINK_MS = 500;

  static final long DEADLINE_MS = 10_000;

  /** A member may have done its rounds, and never arrive. */
  private static final long LATE_MS = DEADLINE_MS + 1_000;

  /** After the last arrival. */
  private static final long PROMPT_MS = 500;

  private static final int PROMPT_MESSAGES = 40;
  private static final BarrierSettings SETTINGS =
      BarrierSettings.DEFAULT.withSilenceMs(2_000).withDeadlineMs(DEADLINE_MS);

  /**
   * A crashed member is given up by its silence, long before the deadline; members that arrived
   * before they crashed may have the first turns to propose.
   */
  private static final long RELEASED_MS = 8_000;

  /**
   * Upper bound of the deadline by a clock that is slow by a tenth and was set back by a second.
   */
  private static final long TOLD_NS = (2 * DEADLINE_MS + DEADLINE_MS / 4 + 1_000) * Time.NS_PER_MS;

  private final Registration reg;
  private final Map<Long, Barrier> barriers = new TreeMap<>();

  private BarrierClient(GlobalVarHolder gvh, Setup setup) {
    super(gvh, setup, THINK_MS);
    reg = registration(XID, setup.registration());
    // Also after its rounds: a robot that registers again waits for votes at the barrier of its
    // view.
    reg.onChange(() -> {
      if (reg.mayRequest()) {
        open();
      }
    });
  }

  static void setUp(Setup setup) {
    setup.place(gvh -> new BarrierClient(gvh, setup));
    setup.simulation().monitor(() -> setup.registered(setup.registration()));
    long releasedNs =
        setup.isLossless() ? setup.withMessagesNs(RELEASED_MS, PROMPT_MESSAGES) : setup.withinNs();
    long promptNs =
        setup.isLossless() ? setup.withMessagesNs(PROMPT_MS, PROMPT_MESSAGES) : Deadlines.NO_BOUND;
    setup
        .simulation()
        .monitor(() -> new BarrierSpec(releasedNs, TOLD_NS, promptNs).patient(SETTINGS));
    setup.promise(LATE_MS, PROMPT_MESSAGES, true);
  }

  @Override
  protected void prepare() {
    register(reg);
  }

  @Override
  protected boolean obtain(int round) {
    long view = reg.ts();
    Barrier barrier = open();
    barrier.arrive();
    await(() -> barrier.outcome().get().isTold() || reg.ts() > view || !reg.mayRequest());
    BarrierOutcome outcome = barrier.outcome().get();
    if (outcome instanceof BarrierOutcome.Excluded) {
      unregister(reg); // to register again in a new view
    }
    return outcome instanceof BarrierOutcome.Passed;
  }

  /** The barrier of the latest view. */
  private Barrier open() {
    return barriers.computeIfAbsent(reg.ts(), any -> new Barrier(gvh, XID, reg, SETTINGS));
  }
}
