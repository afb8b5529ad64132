package org.starl.workload;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.apps.Parameter;
import org.starl.primitives.election.Election;
import org.starl.primitives.election.ElectionSettings;
import org.starl.primitives.election.ElectionSpec;
import org.starl.primitives.election.ElectionStrategy;
import org.starl.time.Time;

/** In each round all robots take part in one more election. */
final class ElectionClient extends Client {

  static final Parameter STRATEGY =
      Parameter.choice(
          "strategy", "how robots elect: random (ballots) or bully", "random", "bully");

  static final long DEADLINE_MS = 10_000;
  private static final long THINK_MS = 1_000;

  /** Nearly twice the longest wait in 360 runs, with delays of 1 to 200 ms. */
  private static final long PROMPT_MS = 2_500;

  private static final int PROMPT_MESSAGES = 20;

  /**
   * Upper bound of the deadline by a clock that is slow by a tenth and was set back by a second.
   */
  private static final long TOLD_NS = (DEADLINE_MS + DEADLINE_MS / 5 + 1_000) * Time.NS_PER_MS;

  // Created at the start: each votes even before this robot takes part.
  private final List<Election> elections = new ArrayList<>();

  private ElectionClient(GlobalVarHolder gvh, Setup setup, ElectionSettings settings) {
    super(gvh, setup, THINK_MS);
    for (int i = 0; i < setup.course().allRounds(); i++) {
      elections.add(new Election(gvh, "round" + i, gvh.id.participants(), settings));
    }
  }

  static void setUp(Setup setup) {
    boolean isBully = setup.request().choice(STRATEGY).equals("bully");
    ElectionSettings settings =
        ElectionSettings.DEFAULT
            .withStrategy(isBully ? ElectionStrategy.BULLY : ElectionStrategy.RANDOM_BALLOT)
            .withDeadlineMs(DEADLINE_MS);
    setup.place(gvh -> new ElectionClient(gvh, setup, settings));
    // Until suspicion, perhaps twice, and decided after each.
    long electedNs = setup.withinNs() + 2 * settings.silenceMs() * Time.NS_PER_MS;
    setup
        .simulation()
        .monitor(() -> {
          ElectionSpec spec = new ElectionSpec(electedNs, TOLD_NS).patient(settings);
          return setup.isLossless() ? spec.leaderStays() : spec;
        });
    setup.promise(PROMPT_MS, PROMPT_MESSAGES, false);
  }

  @Override
  protected boolean obtain(int round) {
    Election election = elections.get(round);
    election.do_election();
    await(() -> election.Leader().get().isElected() || election.failed().get());
    return election.Leader().get().isElected();
  }
}
