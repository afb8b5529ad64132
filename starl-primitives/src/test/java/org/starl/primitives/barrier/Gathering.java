package org.starl.primitives.barrier;

import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.primitives.chaos.Life;
import org.starl.primitives.chaos.LiveRobot;
import org.starl.primitives.chaos.LiveWorld;
import org.starl.primitives.chaos.Weather;
import org.starl.random.Rng;
import org.starl.spec.SpecReport;
import org.starl.trace.Instance;

/** Robots that meet at a barrier again and again, in a world of their own. */
final class Gathering {

  static final Instance SOURCE = Instance.of(BarrierFact.PRIMITIVE, "gathering");
  static final long NS_PER_MS = 1_000_000;

  /** From the last arrival, a crash or healing, until all waiting robots are told. */
  static final long BOUND_MS = 15_000;

  private static final int MAX_ROBOTS = 6;
  private static final int GENERATIONS_AFTERWARDS = 5;

  final LiveWorld<Member> world;
  final BarrierSettings settings;
  Member.Maker maker = BarrierProtocol::new;
  private final SortedSet<ProcessId> first = new TreeSet<>();

  Gathering(long seed, int size, BarrierSettings settings) {
    this.settings = settings;
    world =
        new LiveWorld<>(
            seed,
            new BarrierSpec(BOUND_MS * NS_PER_MS, 2 * settings.deadlineMs() * NS_PER_MS),
            new BarrierConformance());
    world.add(size, name -> new Member(this, name));
    world.robots.forEach(robot -> first.add(ProcessId.first(robot.name, 1)));
  }

  /** All up, in weather that is steady. */
  static Gathering up(int size, BarrierSettings settings) {
    Gathering gathering = new Gathering(1, size, settings);
    gathering.world.weather(Weather.TEN_MS);
    gathering.world.robots.forEach(LiveRobot::start);
    return gathering;
  }

  /** One drawn from its seed: its size, how soon it suspects, and its deadline. */
  static Gathering drawn(long seed) {
    Rng draws = new Rng(seed).fork("gathering");
    return new Gathering(
        seed,
        2 + draws.nextInt(MAX_ROBOTS - 1),
        BarrierSettings.DEFAULT
            .withSilenceMs(draws.nextLong(1_000, 8_000))
            .withDeadlineMs(draws.nextLong(3_000, 40_000)));
  }

  SortedSet<ProcessId> first() {
    return first;
  }

  /**
   * Runs under faults; returns whether the remaining members then pass generation after generation.
   */
  boolean live() {
    Rng rng = world.rng.fork("life");
    Life<Member> life = new Life<>(world, rng, Gathering::act);
    life.crashChance = rng.nextBoolean(0.5) ? 0 : 0.4;
    life.live(() -> true, 0);
    long goal = members().stream().mapToLong(m -> m.protocol().generation()).max().orElse(0);
    return world.runUntil(
        () ->
            members().stream()
                .allMatch(m -> m.protocol().generation() > goal + GENERATIONS_AFTERWARDS),
        4 * BOUND_MS);
  }

  private static void act(Member member) {
    if (!member.protocol().isWaiting() && member.isIn()) {
      member.arrive();
    }
  }

  /** The robots that are up and believe to be members. */
  List<Member> members() {
    return world.robots.stream().filter(Member::isIn).toList();
  }

  SpecReport finish() {
    return world.finish();
  }
}
