package org.starl.sim.fault;

import java.util.LinkedHashMap;
import java.util.Map;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.sim.net.LinkRule;
import org.starl.sim.net.Transmission;
import org.starl.sim.net.Verdict;

/**
 * Loss in bursts, after Gilbert (1960) and Elliott (1963): each direction of each link is
 * alternately good and bad, for exponential times; datagrams sent while it is bad are lost with the
 * given probability.
 */
final class BurstRule implements LinkRule {

  private static final Verdict LOST = Verdict.drop("burst");

  private final long goodNs;
  private final long badNs;
  private final double lossWhileBad;
  private final long beginNs;
  private final Rng rng;
  private final Map<Ends, State> states = new LinkedHashMap<>();

  private record Ends(RobotId from, RobotId to) {}

  private static final class State {
    private final Rng rng;
    private boolean isBad;
    private long untilNs;

    State(Rng rng) {
      this.rng = rng;
    }
  }

  /**
   * @param goodNs mean time of a good phase, above 0
   * @param badNs mean time of a bad phase, above 0
   * @param beginNs start of the rule; all links are then good
   */
  BurstRule(long goodNs, long badNs, double lossWhileBad, long beginNs, Rng rng) {
    this.goodNs = goodNs;
    this.badNs = badNs;
    this.lossWhileBad = lossWhileBad;
    this.beginNs = beginNs;
    this.rng = rng;
  }

  @Override
  public Verdict judge(Transmission copy) {
    State state = states.computeIfAbsent(new Ends(copy.from(), copy.to()), this::begin);
    while (copy.sentAtNs() >= state.untilNs) {
      state.isBad = !state.isBad;
      state.untilNs += drawNs(state, state.isBad ? badNs : goodNs);
    }
    boolean isLost = state.isBad && copy.rng().fork("burst").nextBoolean(lossWhileBad);
    return isLost ? LOST : Verdict.PASS;
  }

  private State begin(Ends ends) {
    State state = new State(rng.fork(ends.from() + ">" + ends.to()));
    state.untilNs = beginNs + drawNs(state, goodNs);
    return state;
  }

  private static long drawNs(State state, long meanNs) {
    return 1 + Math.round(meanNs * state.rng.nextExponential());
  }
}
