package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.starl.random.Rng;
import org.starl.sim.net.Latency;
import org.starl.sim.world.PositionNoise;
import org.starl.sim.world.Unsynced;

/**
 * Draws fault plans. Each run of a campaign gets a random subset of the kinds of faults, each with
 * random strength: this finds more bugs than runs that all use every kind (Groce et al., "Swarm
 * testing", ISSTA 2012). All faults have ended by the given time.
 */
final class Chaos {

  private static final long MS = 1_000_000;
  private static final double MEAN_GAP_MS = 1500;
  private static final double MEAN_LASTING_MS = 2000;
  private static final long LEAST_LASTING_MS = 50;
  private static final long MOST_DROPOUT_MS = 1000;

  private final Rng rng;
  private final long untilMs;
  private final List<Fault> faults = new ArrayList<>();

  private Chaos(Rng rng, long untilMs) {
    this.rng = rng;
    this.untilMs = untilMs;
  }

  static FaultPlan draw(Envelope envelope, int robots, long untilNs, Rng rng) {
    Chaos chaos = new Chaos(rng, untilNs / MS);
    List<Function<Chaos, FaultEffect>> kinds = kinds(envelope);
    if (kinds.isEmpty() || chaos.untilMs <= LEAST_LASTING_MS) {
      return FaultPlan.NONE;
    }
    List<Function<Chaos, FaultEffect>> some = new ArrayList<>(kinds);
    some.removeIf(kind -> !rng.nextBoolean(0.6));
    chaos.comeAndGo(some.isEmpty() ? kinds : some);
    if (envelope == Envelope.MORTAL && rng.nextBoolean(0.7)) {
      chaos.kill((robots - 1) / 2);
    }
    return new FaultPlan(chaos.faults);
  }

  private void comeAndGo(List<Function<Chaos, FaultEffect>> kinds) {
    // In some runs a fault lasts for the whole run, in most runs faults begin and end.
    if (rng.nextBoolean(0.3)) {
      add(network().get(rng.nextInt(network().size())).apply(this), 0, untilMs);
    }
    long atMs = Math.round(MEAN_GAP_MS / 2 * rng.nextExponential());
    while (atMs < untilMs - LEAST_LASTING_MS) {
      long lastingMs = LEAST_LASTING_MS + Math.round(MEAN_LASTING_MS * rng.nextExponential());
      FaultEffect harm = kinds.get(rng.nextInt(kinds.size())).apply(this);
      if (harm instanceof RobotFault.Dropout) {
        lastingMs = Math.min(lastingMs, MOST_DROPOUT_MS);
      }
      add(harm, atMs, Math.min(untilMs, atMs + lastingMs));
      atMs += 1 + Math.round(MEAN_GAP_MS * rng.nextExponential());
    }
  }

  private void kill(int most) {
    int deaths = most < 1 ? 0 : 1 + rng.nextInt(most);
    for (int i = 0; i < deaths; i++) {
      TimeRange at = TimeRange.exactly(MS * rng.nextLong(0, untilMs));
      faults.add(
          new Fault(new Crash(RobotSelector.ANY, Unsynced.LOST), new Span(at, null, Span.NEVER)));
    }
  }

  private void add(FaultEffect harm, long fromMs, long toMs) {
    faults.add(new Fault(harm, Span.between(fromMs * MS, toMs * MS)));
  }

  private static List<Function<Chaos, FaultEffect>> kinds(Envelope envelope) {
    List<Function<Chaos, FaultEffect>> kinds = new ArrayList<>();
    if (envelope == Envelope.NONE) {
      return kinds;
    }
    kinds.addAll(network());
    if (envelope != Envelope.NETWORK && envelope != Envelope.SPATIAL) {
      // Crashes are drawn more often than other faults, because they matter most for these
      // envelopes.
      kinds.add(c -> new Crash(RobotSelector.ANY, c.unsynced()));
      kinds.add(c -> new Crash(c.one(0.5) ? RobotSelector.ANY : RobotSelector.HALF, c.unsynced()));
      kinds.add(c -> new RobotFault.Disk(c.anyOrAll(), c.ms(1, 100)));
    }
    if (envelope == Envelope.HOSTILE) {
      kinds.add(c -> new AttackFault.Forge(c.anyOrAll(), c.ms(10, 500)));
      kinds.add(c -> new AttackFault.Replay(c.anyOrAll(), c.ms(10, 500)));
      kinds.add(c -> new AttackFault.Flood(c.anyOrAll(), c.ms(5, 100)));
    }
    if (envelope == Envelope.LOGICAL
        || envelope == Envelope.MORTAL
        || envelope == Envelope.HOSTILE) {
      kinds.add(c -> new RobotFault.Compute(c.anyOrAll(), c.ms(1, 20)));
      kinds.add(c -> new RobotFault.Drift(RobotSelector.ANY, c.rng.nextLong(-100_000, 100_000)));
      kinds.add(c -> new RobotFault.Skew(RobotSelector.ANY, c.ms(-1000, 1000)));
    }
    if (envelope == Envelope.SPATIAL || envelope == Envelope.MOVING) {
      kinds.add(c -> new RobotFault.Drift(RobotSelector.ANY, c.rng.nextLong(-200, 200)));
    }
    if (envelope == Envelope.SPATIAL) {
      kinds.add(c ->
          new RobotFault.Noise(
              c.anyOrAll(),
              new PositionNoise(c.rng.nextLong(1, 20), c.rng.nextLong(0, 20) / 1000.0)));
      kinds.add(c -> new RobotFault.Dropout(RobotSelector.ANY));
      kinds.add(c -> new RobotFault.Slow(RobotSelector.ANY, c.percent(50, 100)));
      kinds.add(c -> new RobotFault.Stuck(RobotSelector.ANY));
    }
    return kinds;
  }

  private static List<Function<Chaos, FaultEffect>> network() {
    return List.of(
        c -> new NetworkFault.Loss(c.percent(5, 100), c.link()),
        c -> new NetworkFault.Burst(c.ms(200, 2000), c.ms(50, 1000), c.percent(50, 100), c.link()),
        c -> new NetworkFault.Delay(c.latency(), c.link()),
        c -> new NetworkFault.Duplicate(c.percent(5, 80), c.ms(1, 1000), c.link()),
        c -> new NetworkFault.Reorder(c.percent(5, 80), c.ms(1, 500), c.link()),
        c ->
            new ConnectivityFault.Groups(
                List.of(c.one(0.5) ? RobotSelector.ANY : RobotSelector.HALF)),
        c ->
            new ConnectivityFault.OneWay(
                c.one(0.5) ? RobotSelector.ANY : RobotSelector.HALF,
                c.one(0.5) ? RobotSelector.ALL : RobotSelector.HALF));
  }

  private Latency latency() {
    return one(0.5) ? new Latency.Uniform(0, ms(1, 800)) : new Latency.Exponential(ms(1, 300));
  }

  private Link link() {
    return one(0.6)
        ? Link.ALL
        : one(0.5)
            ? new Link(RobotSelector.ANY, RobotSelector.ALL)
            : new Link(RobotSelector.ALL, RobotSelector.ANY);
  }

  private RobotSelector anyOrAll() {
    return one(0.5) ? RobotSelector.ANY : RobotSelector.ALL;
  }

  private Unsynced unsynced() {
    return Unsynced.values()[rng.nextInt(Unsynced.values().length)];
  }

  private double percent(int least, int most) {
    return rng.nextLong(least, most) / 100.0;
  }

  private long ms(long least, long most) {
    return MS * rng.nextLong(least, most);
  }

  private boolean one(double probability) {
    return rng.nextBoolean(probability);
  }
}
