package org.starl.primitives.election;

import org.starl.id.Participants;
import org.starl.primitives.chaos.Life;
import org.starl.primitives.chaos.LiveRobot;
import org.starl.primitives.chaos.LiveWorld;
import org.starl.primitives.chaos.Weather;
import org.starl.random.Rng;
import org.starl.spec.SpecReport;
import org.starl.trace.Instance;

/** Robots that elect a leader, in a world of their own. */
final class Convoy {

  static final Instance SOURCE = Instance.of(ElectionFact.PRIMITIVE, "convoy");
  static final long NS_PER_MS = 1_000_000;

  /** From healing, or from the loss of a leader, to all knowing the same live leader. */
  static final long BOUND_MS = 20_000;

  private static final int MAX_ROBOTS = 6;

  final LiveWorld<Voter> world;
  ElectionSettings settings;
  Voter.Maker maker = ElectionProtocol::new;

  Convoy(long seed, int size, ElectionSettings settings) {
    this.settings = settings;
    world =
        new LiveWorld<>(
            seed,
            new ElectionSpec(BOUND_MS * NS_PER_MS, settings.deadlineMs() * NS_PER_MS),
            new ElectionConformance());
    world.add(size, name -> new Voter(this, name));
  }

  /** All up, in weather that is steady. */
  static Convoy up(int size, ElectionSettings settings) {
    Convoy convoy = new Convoy(1, size, settings);
    convoy.world.weather(Weather.TEN_MS);
    convoy.world.robots.forEach(LiveRobot::start);
    return convoy;
  }

  /** One drawn from its seed: its size, strategy and deadline. */
  static Convoy drawn(long seed) {
    Rng draws = new Rng(seed).fork("convoy");
    ElectionStrategy strategy = ElectionStrategy.values()[draws.nextInt(2)];
    return new Convoy(
        seed,
        2 + draws.nextInt(MAX_ROBOTS - 1),
        ElectionSettings.DEFAULT
            .withStrategy(strategy)
            .withDeadlineMs(draws.nextLong(1_000, 20_000)));
  }

  Participants participants() {
    return Participants.of(world.robots.stream().map(robot -> robot.name).toList());
  }

  /** Runs under faults; returns whether all robots then follow one live leader. */
  boolean live(boolean restarts) {
    Life<Voter> life = new Life<>(world, world.rng.fork("life"), Convoy::act);
    life.restarts = restarts;
    return life.live(this::isLedByOne, BOUND_MS + 5_000) && staysWell();
  }

  /** After healing no robot suspects another, so the leader does not change. */
  private boolean staysWell() {
    world.runForMs(2 * settings.silenceMs());
    if (!world.runUntil(this::isLedByOne, BOUND_MS)) {
      return false;
    }
    Leader led = anyUp().leader();
    world.runForMs(10_000);
    return isLedByOne() && anyUp().leader().equals(led);
  }

  private static void act(Voter voter) {
    if (!voter.takesPart() || voter.leader() instanceof Leader.Fail) {
      voter.do_election();
    }
  }

  boolean isLedByOne() {
    Leader led = anyUp().leader();
    return led instanceof Leader.Name name
        && world.robots.stream()
            .filter(LiveRobot::isUp)
            .allMatch(robot -> robot.leader().equals(led))
        && world.robots.stream()
            .filter(LiveRobot::isUp)
            .anyMatch(robot -> robot.protocol().me().equals(name.id()));
  }

  Voter anyUp() {
    return world.robots.stream().filter(LiveRobot::isUp).findFirst().orElseThrow();
  }

  SpecReport finish() {
    return world.finish();
  }
}
