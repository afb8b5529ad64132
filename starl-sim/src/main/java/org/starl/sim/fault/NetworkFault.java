package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.List;
import org.starl.input.Quantities;
import org.starl.random.Rng;
import org.starl.sim.net.Latency;
import org.starl.sim.net.LinkRule;
import org.starl.sim.net.Verdict;

/** A fault of the radio network: it installs a {@link LinkRule}. Several act together. */
public sealed interface NetworkFault extends FaultEffect
    permits NetworkFault.OnLink, ConnectivityFault {

  /** The rule to install now. */
  LinkRule rule(FaultContext onset);

  @Override
  default RobotSelector who() {
    return RobotSelector.ALL;
  }

  @Override
  default Runnable begin(FaultContext onset) {
    return onset.ward().network().install(rule(onset))::uninstall;
  }

  /** A fault that can be limited to some links: {@code from=bot1,to=bot2}. */
  sealed interface OnLink extends NetworkFault {

    Link link();

    /** Its arguments without the link. */
    List<String> own();

    /**
     * The rule for the link's copies.
     *
     * @param salt forks a copy's generator for this fault alone
     */
    LinkRule unlimited(FaultContext onset, String salt);

    @Override
    default List<String> arguments() {
      List<String> arguments = new ArrayList<>(own());
      arguments.addAll(link().arguments());
      return arguments;
    }

    @Override
    default List<RobotSelector> named() {
      return List.of(link().from(), link().to());
    }

    @Override
    default LinkRule rule(FaultContext onset) {
      String salt = Long.toString(onset.rng().fork("copies").nextLong());
      return link().limit(unlimited(onset, salt), onset.ward(), onset.rng());
    }
  }

  /** Each copy is lost with this probability, on its own: {@code loss(0.3)}. */
  record Loss(double probability, Link link) implements OnLink {
    private static final Verdict LOST = Verdict.drop("loss");

    @Override
    public String name() {
      return "loss";
    }

    @Override
    public List<String> own() {
      return List.of(Quantities.numberText(probability));
    }

    @Override
    public LinkRule unlimited(FaultContext onset, String salt) {
      return copy -> copy.rng().fork(salt).nextBoolean(probability) ? LOST : Verdict.PASS;
    }
  }

  /**
   * Each link alternates between good and bad periods with these mean lengths, and loses copies with
   * this probability while it is bad: {@code burst(2s,200ms)}, {@code burst(2s,200ms,0.9)}.
   */
  record Burst(long goodNs, long badNs, double probability, Link link) implements OnLink {
    @Override
    public String name() {
      return "burst";
    }

    @Override
    public List<String> own() {
      String good = Quantities.durationText(goodNs);
      String bad = Quantities.durationText(badNs);
      return probability == 1
          ? List.of(good, bad)
          : List.of(good, bad, Quantities.numberText(probability));
    }

    @Override
    public LinkRule unlimited(FaultContext onset, String salt) {
      long nowNs = onset.ward().nowNs();
      return new BurstRule(goodNs, badNs, probability, nowNs, onset.rng().fork("links"));
    }
  }

  /** Each copy gets this additional delay: {@code delay(uniform(10ms,200ms))}. */
  record Delay(Latency more, Link link) implements OnLink {
    @Override
    public String name() {
      return "delay";
    }

    @Override
    public List<String> own() {
      return List.of(more.toString());
    }

    @Override
    public LinkRule unlimited(FaultContext onset, String salt) {
      return copy -> Verdict.later(more.drawNs(copy.rng().fork(salt)));
    }
  }

  /** With this probability a copy arrives twice, the second time up to {@code mostNs} later. */
  record Duplicate(double probability, long mostNs, Link link) implements OnLink {

    static final long USUAL_NS = 50_000_000;

    @Override
    public String name() {
      return "duplicate";
    }

    @Override
    public List<String> own() {
      String p = Quantities.numberText(probability);
      return mostNs == USUAL_NS ? List.of(p) : List.of(p, Quantities.durationText(mostNs));
    }

    @Override
    public LinkRule unlimited(FaultContext onset, String salt) {
      return copy -> {
        Rng rng = copy.rng().fork(salt);
        return rng.nextBoolean(probability) ? Verdict.again(rng.nextLong(0, mostNs)) : Verdict.PASS;
      };
    }
  }

  /** With this probability a copy is delayed by up to {@code mostNs}, so that others overtake it. */
  record Reorder(double probability, long mostNs, Link link) implements OnLink {
    @Override
    public String name() {
      return "reorder";
    }

    @Override
    public List<String> own() {
      return List.of(Quantities.numberText(probability), Quantities.durationText(mostNs));
    }

    @Override
    public LinkRule unlimited(FaultContext onset, String salt) {
      return copy -> {
        Rng rng = copy.rng().fork(salt);
        return rng.nextBoolean(probability) ? Verdict.later(rng.nextLong(0, mostNs)) : Verdict.PASS;
      };
    }
  }
}
