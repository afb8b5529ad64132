package org.starl.sim.fault;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.starl.sim.fault.ProbeRun.MS;
import static org.starl.sim.fault.ProbeRun.S;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.starl.sim.Director;
import org.starl.sim.fault.ProbeRun.Clock;
import org.starl.sim.fault.ProbeRun.Fix;
import org.starl.sim.fault.ProbeRun.Flushed;
import org.starl.sim.fault.ProbeRun.Said;
import org.starl.trace.TraceEvent;

/** Every fault of a robot bites while it lasts, and stops. */
class RobotFaultsTest {

  private static final String FOR_3_S = "at=3s,for=3s)";

  private static final long FROM = 3 * S;
  private static final long UNTIL = 6 * S;

  private static double drivenMm(ProbeRun run, long fromNs, long untilNs) {
    return run.bot0XMm(untilNs) - run.bot0XMm(fromNs);
  }

  @Test
  void aCrashEndsARobotAndARestartBringsItBack() {
    ProbeRun run = ProbeRun.of("crash(bot0,at=3s,restart=3s)");
    assertThat(run.count(0, 1, FROM + 20 * MS, UNTIL)).isZero();
    assertThat(run.count(0, 1, UNTIL, 12 * S)).isGreaterThan(40);
    assertThat(run.faults())
        .containsExactly(
            "3000 bot0 begin crash(bot0,at=3s,restart=3s)",
            "3000 bot0 crash",
            "6000 bot0 restart lost",
            "6000 bot0 end crash(bot0,at=3s,restart=3s)",
            "6000 world healed");
  }

  @Test
  void aCrashWithoutRestartEndsAtOnceAndSkipsCrashedRobots() {
    ProbeRun run = ProbeRun.of("crash(bot0,at=3s)", "crash(bot0,at=4s)");
    assertThat(run.faults())
        .containsExactly(
            "3000 bot0 begin crash(bot0,at=3s)",
            "3000 bot0 crash",
            "3000 bot0 end crash(bot0,at=3s)",
            "4000 bot0 begin crash(bot0,at=4s)",
            "4000 bot0 end crash(bot0,at=4s)",
            "4000 world healed");
    assertThat(run.count(0, 1, FROM + 20 * MS, 12 * S)).isZero();
  }

  @Test
  void anyIsDrawnFromTheRobotsThatAreUp() {
    List<String> drawn = new ArrayList<>();
    for (int seed = 1; seed <= 20; seed++) {
      ProbeRun run =
          ProbeRun.of(ProbeRun.simulation(seed, "crash(bot0,at=1s)", "crash(any,at=1s..2s)"));
      List<String> crashes = run.faults().stream().filter(l -> l.endsWith(" crash")).toList();
      assertThat(crashes).hasSize(2).first().isEqualTo("1000 bot0 crash");
      drawn.add(crashes.get(1).split(" ")[1]);
      assertThat(Long.parseLong(crashes.get(1).split(" ")[0])).isBetween(1000L, 2000L);
    }
    assertThat(drawn).contains("bot1", "bot2").doesNotContain("bot0");
  }

  @Test
  void allRobotsCrashTogether() {
    ProbeRun run = ProbeRun.of("crash(all,at=3s,restart=1s,lose=nothing)");
    assertThat(run.faults())
        .contains(
            "3000 bot0 crash", "3000 bot1 crash", "3000 bot2 crash", "4000 bot2 restart kept");
  }

  @Test
  void stuckWheelsStandStill() {
    ProbeRun run = ProbeRun.of("stuck(bot0," + FOR_3_S);
    assertThat(drivenMm(run, FROM, UNTIL)).isZero();
    assertThat(drivenMm(run, 2 * S, FROM)).isGreaterThan(100);
    assertThat(drivenMm(run, UNTIL + 2 * S, UNTIL + 3 * S)).isGreaterThan(100);
  }

  @Test
  void slowWheelsDriveAFractionOfTheSpeed() {
    double soundMm = drivenMm(ProbeRun.of(), 4 * S, UNTIL);
    ProbeRun run = ProbeRun.of("slow(bot0,0.5," + FOR_3_S, "slow(bot0,0.5,at=5s,for=2s)");
    assertThat(drivenMm(run, 4 * S, 5 * S)).isBetween(0.2 * soundMm, 0.3 * soundMm);
    assertThat(drivenMm(run, 5 * S, UNTIL)).isBetween(0.1 * soundMm, 0.15 * soundMm);
    assertThat(drivenMm(run, 8 * S, 10 * S)).isBetween(0.9 * soundMm, 1.1 * soundMm);
  }

  private static double fixError(ProbeRun run, long fromNs, long untilNs) {
    return most(run, fix -> StrictMath.hypot(fix.xMm(), fix.yMm() - 1000), fromNs, untilNs);
  }

  private static double most(
      ProbeRun run, ToDoubleFunction<Fix> number, long fromNs, long untilNs) {
    return run.said(1, Fix.class, fromNs, untilNs).stream()
        .mapToDouble(said -> number.applyAsDouble(said.fact()))
        .max()
        .orElseThrow();
  }

  @Test
  void positioningNoiseIsIncludedInTheBound() {
    ProbeRun run = ProbeRun.of("noise(bot1,40mm,until=3s)");
    assertThat(fixError(run, 0, FROM)).isBetween(5.0, 40.0);
    assertThat(most(run, Fix::errorMm, 0, 200 * MS)).isBetween(39.0, 41.0);
    assertThat(fixError(run, FROM + 100 * MS, 12 * S)).isZero();
    assertThat(most(run, Fix::errorMm, FROM + 100 * MS, 12 * S)).isLessThan(1);
  }

  @Test
  void fixesAgeDuringADropout() {
    ProbeRun run = ProbeRun.of("dropout(bot1," + FOR_3_S);
    assertThat(most(run, Fix::ageNs, FROM, UNTIL)).isGreaterThan(2.5 * S);
    assertThat(most(run, Fix::ageNs, 0, FROM)).isLessThan(0.2 * S);
    assertThat(most(run, Fix::ageNs, UNTIL + 200 * MS, 12 * S)).isLessThan(0.2 * S);
  }

  @Test
  void aJumpIsNotIncludedInTheBound() {
    ProbeRun run = ProbeRun.of("jump(bot1,300mm,until=3s)");
    assertThat(fixError(run, 200 * MS, FROM)).isBetween(299.0, 301.0);
    assertThat(most(run, Fix::errorMm, 200 * MS, FROM)).isLessThan(10);
    ProbeRun later = ProbeRun.of("jump(bot1,300mm," + FOR_3_S);
    assertThat(most(later, Fix::contradictions, 0, FROM)).as("contradictions").isZero();
    assertThat(most(later, Fix::contradictions, 0, UNTIL)).isBetween(38.0, 41.0);
    assertThat(most(later, Fix::contradictions, 0, 12 * S)).isBetween(38.0, 41.0);
  }

  private static double clockAheadMs(ProbeRun run, int robot, long atNs) {
    Said<Clock> said = run.said(robot, Clock.class, atNs, atNs + S).get(0);
    return (said.fact().shownNs() - said.timeNs()) / (double) MS;
  }

  @Test
  void aDriftingClockGainsOrLosesTime() {
    ProbeRun run = ProbeRun.of("drift(bot1,10000ppm,at=1s,until=6s)", "drift(bot2,-10000ppm)");
    assertThat(clockAheadMs(run, 0, 5 * S)).isZero();
    assertThat(clockAheadMs(run, 1, 0)).isZero();
    assertThat(clockAheadMs(run, 1, 5 * S)).isBetween(39.0, 42.0);
    assertThat(clockAheadMs(run, 1, 8 * S)).isBetween(49.9, 50.1);
    assertThat(clockAheadMs(run, 2, 8 * S)).isBetween(-82.0, -79.0);
    assertThat(run.said(2, Clock.class, 0, 12 * S)).as("its sleeps are longer").hasSize(100);
    long lastNs = run.said(2, Clock.class, 0, 12 * S).get(99).timeNs();
    assertThat(lastNs).isGreaterThan(9_990 * MS);
  }

  @Test
  void aSkewedClockIsAheadOrBehindAndNeverRunsBackwards() {
    ProbeRun run = ProbeRun.of("skew(bot1,50ms," + FOR_3_S, "skew(bot2,-50ms)");
    assertThat(clockAheadMs(run, 1, 2 * S)).isZero();
    assertThat(clockAheadMs(run, 1, 4 * S)).isEqualTo(50);
    assertThat(clockAheadMs(run, 1, 8 * S)).isZero();
    assertThat(clockAheadMs(run, 2, 8 * S)).isEqualTo(-50);
    List<Long> shown =
        run.said(1, Clock.class, 0, 12 * S).stream().map(said -> said.fact().shownNs()).toList();
    assertThat(shown).hasSize(100).isSorted();
  }

  @Test
  void aRobotWithAWrongClockIsTracedInTrueTime() {
    ProbeRun run = ProbeRun.of("skew(bot1,1s)");
    assertThat(run.events.stream().map(TraceEvent::timeNs).toList()).isSorted();
    assertThat(run.heard(1, 0, 0, S)).isNotEmpty();
  }

  @Test
  void aBusyProcessorHoldsTheStrandAndLosesNothing() {
    ProbeRun run = ProbeRun.of("compute(bot1,40ms," + FOR_3_S);
    // 20 beats a second come in and 10 steps of the app: more than 25 actions of 40 ms.
    assertThat(run.count(0, 1, FROM, UNTIL)).isLessThan(30);
    List<TraceEvent.Delivered> heard = run.heard(0, 1, 0, 12 * S);
    assertThat(heard).hasSize(100);
    assertThat(heard.stream().map(TraceEvent.Delivered::seq).toList()).isSorted();
    List<Said<Clock>> steps = run.said(1, Clock.class, FROM + S, UNTIL);
    for (int i = 1; i < steps.size(); i++) {
      assertThat(steps.get(i).timeNs() - steps.get(i - 1).timeNs()).isGreaterThan(100 * MS);
    }
  }

  @Test
  void aSlowDiskDelaysFlushes() {
    ProbeRun run = ProbeRun.of("disk(bot1,2s," + FOR_3_S);
    assertThat(run.said(1, Flushed.class, FROM + 100 * MS, 5 * S)).isEmpty();
    assertThat(run.said(1, Flushed.class, 0, 12 * S)).hasSizeBetween(95, 100);
    assertThat(run.said(0, Flushed.class, FROM, 5 * S)).hasSize(20);
  }

  @Test
  void aRammerTouchesTheRobotAndDisappears() {
    ProbeRun run = ProbeRun.of("ram(bot0," + FOR_3_S);
    assertThat(joined(run, "intruder0-0")).isEqualTo(1);
    assertThat(moved(run, "intruder0-0")).isPositive();
    assertThat(left(run, "intruder0-0")).containsExactly(UNTIL);
    double soundMm = drivenMm(ProbeRun.of(), FROM, UNTIL);
    assertThat(drivenMm(run, FROM, UNTIL)).isLessThan(soundMm / 2);
  }

  @Test
  void aBlockerParksInTheWayOfTheRobot() {
    ProbeRun run = ProbeRun.of("block(bot0," + FOR_3_S);
    assertThat(joined(run, "intruder0-0")).isEqualTo(1);
    assertThat(moved(run, "intruder0-0")).isZero();
    assertThat(left(run, "intruder0-0")).containsExactly(UNTIL);
    assertThat(drivenMm(run, FROM, UNTIL)).isLessThan(drivenMm(ProbeRun.of(), FROM, UNTIL));
  }

  private static long joined(ProbeRun run, String name) {
    return run.events.stream()
        .filter(e -> e instanceof TraceEvent.Joined && e.robot().name().equals(name))
        .count();
  }

  private static long moved(ProbeRun run, String name) {
    return run.events.stream()
        .filter(e -> e instanceof TraceEvent.Moved && e.robot().name().equals(name))
        .count();
  }

  private static List<Long> left(ProbeRun run, String name) {
    return run.events.stream()
        .filter(e -> e instanceof TraceEvent.Left && e.robot().name().equals(name))
        .map(TraceEvent::timeNs)
        .toList();
  }

  @Test
  void aFaultPersistsAfterARestart() {
    ProbeRun run = ProbeRun.of("stuck(bot0,at=2s)", "crash(bot0,at=3s,restart=1s)");
    assertThat(drivenMm(run, 2 * S, 9 * S)).isZero();
    ProbeRun all = ProbeRun.of("stuck(all)", "crash(bot0,at=3s,restart=1s)");
    assertThat(drivenMm(all, 0, 9 * S)).isZero();
  }

  @Test
  void anUnknownRobotIsBadInput() {
    String[] faults = {
      "crash(bot7)",
      "loss(0.1,from=bot7)",
      "partition(bot0|bot7)",
      "partition(bot0>bot7)",
      "ram(bot0+bot7)"
    };
    for (String fault : faults) {
      assertThatThrownBy(() -> ProbeRun.simulation(1, fault).build())
          .hasMessageStartingWith("'" + fault + "': no robot is called bot7; there are [bot0,");
    }
    Director director = control -> {};
    assertThatThrownBy(
            () -> ProbeRun.of(ProbeRun.simulation(1, "stuck(bot7,at=1s)").director(director)))
        .hasMessage("'stuck(bot7,at=1s)': no robot is called bot7; there are [bot0, bot1, bot2]");
  }
}
