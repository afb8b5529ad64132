package org.starl.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.geometry.Angles;
import org.starl.geometry.Fix;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.kernel.Kernel;
import org.starl.sim.kernel.SimStrand;

/** A robot's ports into the world: chassis, positioning, stable storage. */
final class PortsTest {

  private static final long MS = 1_000_000;

  private final TestTime time = new TestTime();
  private final World world =
      new World(time, time, new TestTrace(), WorldLimits.CREATE, Obstacles.NONE);

  private Body bot(int number, double xMm) {
    return world.add(new RobotId("bot" + number), new Pose(xMm, 0, 0), 165);
  }

  private List<Fix> fixes(Body body, long seed, PositionNoise noise, double seconds) {
    SimPositioning positioning =
        new SimPositioning(
            new RobotId("bot0"),
            new MeasuredRobots(),
            time,
            time,
            time,
            new Rng(seed),
            noise,
            75 * MS,
            0);
    positioning.mount(body);
    List<Fix> fixes = new ArrayList<>();
    positioning.onFix(fixes::add);
    time.runFor(seconds);
    return fixes;
  }

  @Test
  void withoutNoiseAFixIsTheTruePose() {
    Body body = bot(0, 0);
    body.drive(new WheelCommand(200, 0.1));
    List<Fix> fixes = fixes(body, 1, PositionNoise.NONE, 0.3);
    assertThat(fixes)
        .extracting(Fix::timeNs)
        .containsExactly(0L, 75 * MS, 150 * MS, 225 * MS, 300 * MS);
    assertThat(fixes.get(4)).isEqualTo(new Fix(body.pose(), 300 * MS, 0, 0));
  }

  @Property(tries = 50)
  void everyFixIsWithinItsErrorBound(@ForAll long seed) {
    Body body = bot(0, 12_345_678);
    PositionNoise noise = new PositionNoise(20, 0.05);
    double largest = 0;
    for (Fix fix : fixes(body, seed, noise, 20)) {
      double offMm = fix.pose().distanceMm(body.pose().at());
      assertThat(offMm).isLessThanOrEqualTo(fix.errorMm()).isLessThanOrEqualTo(20);
      assertThat(Math.abs(Angles.difference(fix.pose().headingRad(), 0)))
          .isLessThanOrEqualTo(fix.errorRad());
      largest = Math.max(largest, offMm);
    }
    assertThat(largest).isGreaterThan(12);
    world.remove(body);
  }

  @Test
  void noiseIsAMeasurementErrorNotADrift() {
    Body body = bot(0, 0);
    List<Fix> fixes = fixes(body, 3, new PositionNoise(20, 0), 300);
    double sum = 0;
    for (Fix fix : fixes) {
      sum += fix.pose().xMm();
    }
    assertThat(Math.abs(sum / fixes.size())).isLessThan(0.7);
    assertThat(body.pose()).isEqualTo(new Pose(0, 0, 0));
  }

  @Test
  void phasesDependOnTheSeedAndCoverThePeriod() {
    Rng root = new Rng(5);
    long least = Long.MAX_VALUE;
    long most = 0;
    for (int i = 0; i < 100; i++) {
      long phaseNs = SimPositioning.drawnPhaseNs(root.fork("bot" + i), 75 * MS);
      assertThat(phaseNs).isEqualTo(SimPositioning.drawnPhaseNs(root.fork("bot" + i), 75 * MS));
      least = Math.min(least, phaseNs);
      most = Math.max(most, phaseNs);
    }
    assertThat(least).isBetween(0L, 8 * MS);
    assertThat(most).isBetween(67 * MS, 75 * MS - 1);
  }

  @Test
  void positioningResumesInPhaseAfterAnOutage() {
    Body body = bot(0, 0);
    SimPositioning positioning =
        new SimPositioning(
            new RobotId("bot0"),
            new MeasuredRobots(),
            time,
            time,
            time,
            new Rng(1),
            PositionNoise.NONE,
            75 * MS,
            10 * MS);
    positioning.mount(body);
    List<Long> times = new ArrayList<>();
    positioning.onFix(fix -> times.add(fix.timeNs()));
    time.runUntil(100 * MS);
    positioning.turn(false);
    time.runUntil(300 * MS);
    positioning.turn(true);
    time.runUntil(400 * MS);
    assertThat(times).containsExactly(10 * MS, 85 * MS, 310 * MS, 385 * MS);
  }

  @Test
  void bumpsAreReportedOnTheRobotsStrand() {
    try (Kernel kernel = new Kernel(CarrierKind.PLATFORM)) {
      World floor =
          new World(kernel, kernel::timer, new TestTrace(), WorldLimits.CREATE, Obstacles.NONE);
      SimStrand strand = kernel.strand("bot0");
      Body body = floor.add(new RobotId("bot0"), new Pose(0, 0, 0), 165);
      floor.add(new RobotId("bot1"), new Pose(1000, 0, 0), 165);
      SimChassis chassis = new SimChassis(strand, new Rng(1), 0);
      chassis.mount(body);
      List<Bumps> seen = new ArrayList<>();
      chassis.onBump(() -> {
        assertThat(strand.isCurrent()).isTrue();
        seen.add(chassis.bumps());
        chassis.drive(WheelCommand.STOP);
      });
      strand.post(() -> chassis.drive(new WheelCommand(250, 0)));
      kernel.run(10_000 * MS, () -> false);
      assertThat(seen).containsExactly(Bumps.BOTH, Bumps.NONE);
    }
  }

  @Test
  void wheelErrorsAreSeededAndBounded() {
    List<Double> speeds = new ArrayList<>();
    for (int i = 0; i < 2; i++) {
      Body body = bot(i, 10_000 * i);
      SimChassis chassis = new SimChassis(new DirectStrand(), new Rng(9), 0.1);
      chassis.mount(body);
      chassis.drive(new WheelCommand(200, 1));
      chassis.drive(new WheelCommand(200, 1));
      speeds.add(body.linearMmPerS());
      assertThat(body.linearMmPerS()).isBetween(180.0, 220.0).isNotEqualTo(200.0);
      assertThat(body.angularRadPerS()).isBetween(0.9, 1.1).isNotEqualTo(1.0);
    }
    assertThat(speeds.get(0)).isEqualTo(speeds.get(1));
  }

  @Test
  void lateWheelsTakeUpCommandsInOrderAndInTime() {
    try (Kernel kernel = new Kernel(CarrierKind.PLATFORM)) {
      World floor =
          new World(kernel, kernel::timer, new TestTrace(), WorldLimits.CREATE, Obstacles.NONE);
      SimStrand strand = kernel.strand("bot0");
      Body body = floor.add(new RobotId("bot0"), new Pose(0, 0, 0), 165);
      SimChassis chassis = new SimChassis(strand, new Rng(9), 0, kernel, 50 * MS);
      chassis.mount(body);
      boolean isLate = false;
      double before = 0;
      for (int i = 1; i <= 100; i++) {
        double speed = i;
        strand.post(() -> chassis.drive(new WheelCommand(speed, 0)));
        for (int ms = 0; ms < 10; ms++) {
          kernel.run(kernel.nowNs() + MS, () -> false);
          assertThat(body.linearMmPerS()).isBetween(Math.max(before, speed - 6), speed);
          before = body.linearMmPerS();
          isLate |= before < speed - 3;
        }
      }
      assertThat(isLate).isTrue();
      kernel.run(kernel.nowNs() + 50 * MS, () -> false);
      assertThat(body.linearMmPerS()).isEqualTo(100);
      strand.post(() -> chassis.drive(new WheelCommand(20, 0)));
      strand.post(chassis::halt);
      kernel.run(kernel.nowNs() + 100 * MS, () -> false);
      assertThat(body.linearMmPerS()).isZero();
    }
  }

  @Test
  void stuckWheelsStopAndRepairedWheelsContinue() {
    Body body = bot(0, 0);
    SimChassis chassis = new SimChassis(new DirectStrand(), new Rng(9), 0);
    chassis.mount(body);
    chassis.drive(new WheelCommand(200, 0));
    time.runFor(1);
    chassis.impair(0, 0);
    time.runFor(1);
    assertThat(body.pose().xMm()).isEqualTo(200);
    chassis.impair(1, 1);
    time.runFor(1);
    assertThat(body.pose().xMm()).isEqualTo(400);
    chassis.unmount();
    world.remove(body);
    chassis.drive(WheelCommand.STOP);
  }

  @Test
  void aFlushedWriteSurvivesARestartAndAnUnflushedOneDoesNot() {
    SimStable stable = new SimStable(time, 10 * MS);
    stable.restart(time);
    List<String> flushed = new ArrayList<>();
    stable.put("a", new byte[] {1}, () -> flushed.add("a1 " + time.nowNs()));
    time.runFor(0.005);
    stable.put("a", new byte[] {2}, () -> flushed.add("a2 " + time.nowNs()));
    stable.put("b", new byte[] {3}, () -> flushed.add("b"));
    assertThat(stable.get("a")).containsExactly(2);
    time.runFor(0.005);
    assertThat(flushed).containsExactly("a1 " + 10 * MS);
    stable.restart(time);
    time.runFor(1);
    assertThat(stable.get("a")).containsExactly(1);
    assertThat(stable.get("b")).isNull();
    assertThat(flushed).hasSize(1);
  }

  @Test
  void writesAreFlushedInOrderAndNeverInsidePut() {
    SimStable stable = new SimStable(time, 0);
    stable.restart(time);
    List<String> flushed = new ArrayList<>();
    stable.put("a", new byte[1], () -> stable.put("c", new byte[1], () -> flushed.add("c")));
    stable.put("b", new byte[1], () -> flushed.add("b"));
    stable.remove("b");
    assertThat(flushed).isEmpty();
    time.runFor(0);
    assertThat(flushed).containsExactly("b", "c");
    assertThat(stable.get("b")).isNull();
  }

  @Test
  void aSlowDiskMadeFastKeepsTheOrderOfWrites() {
    SimStable stable = new SimStable(time, 100 * MS);
    stable.restart(time);
    List<String> flushed = new ArrayList<>();
    stable.put("a", new byte[1], () -> flushed.add("a"));
    stable.setFlushDelay(0);
    stable.put("b", new byte[1], () -> flushed.add("b"));
    time.runFor(1);
    assertThat(flushed).containsExactly("a", "b");
  }

  @Test
  void stableStorageReturnsCopies() {
    SimStable stable = new SimStable(time, 0);
    assertThatThrownBy(() -> stable.put("a", new byte[1], () -> {}))
        .isInstanceOf(IllegalStateException.class);
    stable.restart(time);
    byte[] mine = {1};
    stable.put("a", mine, () -> {});
    mine[0] = 9;
    byte[] read = stable.get("a");
    assertThat(read).containsExactly(1);
  }
}
