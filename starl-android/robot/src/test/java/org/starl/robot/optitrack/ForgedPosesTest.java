package org.starl.robot.optitrack;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.starl.geometry.Fix;
import org.starl.geometry.Pose;

/**
 * A robot that drives to a goal by its fixes, while an attacker sends poses in the cameras' name; in
 * virtual time. The robot stops without fixes for 500 ms, and when its fixes are doubted.
 */
class ForgedPosesTest {

  private static final long MS = 1_000_000;
  private static final double SPEED = 250;
  private static final double GOAL_MM = 2000;
  private static final long ATTACK_MS = 3000;
  private static final long REACTION_MS = 200;
  private static final int SENSORS_LATE_MS = 180;
  private static final FixBounds BOUNDS = FixBounds.DEFAULT.withMotion(550, 700);

  /** What the attacker sends. */
  enum Attack {
    /** The position scaled by half, from the beginning. */
    SCALED,
    /** From the middle of the way on: the way since then by half. */
    SCALED_FROM_HERE,
    /** Turned by half a radian. */
    TURNED,
    /** Where the robot was at the beginning of the attack. */
    FROZEN,
    /** Where the robot was a second before. */
    EARLIER,
    /** One mm further to the left with each frame. */
    DRIFTING,
    /** The same, along the way. */
    DRIFTING_AHEAD,
    /** By turns the truth and 100 mm beside it. */
    ALTERNATING,
    /** Where another robot is. */
    SWAPPED
  }

  private final List<String> lines = new ArrayList<>();
  private final Tally tally = new Tally((timeNs, level, tag, line) -> lines.add(line), "test");
  private final PoseGate gate = new PoseGate(BOUNDS);
  private final WheelPath path = new WheelPath(0.1, REACTION_MS * MS);
  private final Deque<Double> ways = new ArrayDeque<>();

  private long nowMs;
  private double xMm;
  private boolean isDoubted;
  private @Nullable Fix newest;
  private long frames;
  private double attackedAtMm;

  // The way while two streams were more than 60 mm, or 0.4 rad, apart: in this episode, and the
  // longest.
  private double contradictedMm;
  private double longestMm;
  // The largest distance between the robot and its newest fix while it drove.
  private double offMm;

  ForgedPosesTest() {
    tally.own("bot0", path, () -> isDoubted = true);
  }

  private Pose truth() {
    return new Pose(xMm, 0, 0);
  }

  private Pose forged(Attack attack) {
    frames++;
    return switch (attack) {
      case SCALED -> new Pose(300 + xMm / 2, 0, 0);
      case SCALED_FROM_HERE -> new Pose(attackedAtMm + (xMm - attackedAtMm) / 2, 0, 0);
      case TURNED -> new Pose(xMm, 0, 0.5);
      case FROZEN -> new Pose(attackedAtMm, 0, 0);
      case EARLIER -> new Pose(ways.getFirst(), 0, 0);
      case DRIFTING -> new Pose(xMm, frames, 0);
      case DRIFTING_AHEAD -> new Pose(xMm - frames, 0, 0);
      case ALTERNATING -> new Pose(xMm, frames % 2 * 100, 0);
      case SWAPPED -> new Pose(700, 900, 1.5);
    };
  }

  private void send(Pose pose, long lateMs) {
    Fix fix = new Fix(pose, (nowMs - lateMs) * MS, 5, 0.02);
    if (tally.admit(gate, "bot0", fix, nowMs * MS)) {
      newest = fix;
      isDoubted = false;
    }
  }

  /** One ms: the robot drives if it may. */
  private void step(boolean areApart) {
    nowMs++;
    Fix fix = newest;
    boolean drives =
        fix != null && !isDoubted && nowMs - fix.timeNs() / MS <= 500 && fix.pose().xMm() < GOAL_MM;
    if (drives && fix != null) {
      xMm += SPEED / 1000;
      offMm = Math.max(offMm, Math.abs(fix.pose().xMm() - xMm) + Math.abs(fix.pose().yMm()));
      contradictedMm += areApart ? SPEED / 1000 : 0;
      longestMm = Math.max(longestMm, contradictedMm);
    }
    ways.addLast(xMm);
    if (ways.size() > 1000) {
      ways.removeFirst();
    }
    if (nowMs % 15 == 0) {
      // Worn wheels turn further, and the sensors are late.
      Iterator<Double> newestFirst = ways.descendingIterator();
      double lateMm = xMm;
      for (int i = 0; i < SENSORS_LATE_MS && newestFirst.hasNext(); i++) {
        lateMm = newestFirst.next();
      }
      path.add(nowMs * MS, 1.04 * lateMm, 0, drives ? SPEED : 0, false);
    }
  }

  private void run(@Nullable Attack attack, long fromMs, long untilMs, boolean areTrueHeard) {
    long apartMs = -REACTION_MS;
    while (nowMs < untilMs) {
      step(areTrueHeard && nowMs - apartMs < 50);
      if (nowMs == fromMs) {
        attackedAtMm = xMm;
      }
      boolean isAttack = attack != null && nowMs >= fromMs;
      if (nowMs % 10 == 0 && (areTrueHeard || !isAttack)) {
        send(truth(), 5);
      }
      if (isAttack && nowMs % 3 == 0) {
        Pose pose = forged(attack);
        boolean isApart = pose.distanceMm(truth().at()) > 60 || pose.headingRad() > 0.4;
        contradictedMm = isApart && nowMs - apartMs > 1000 ? 0 : contradictedMm;
        apartMs = isApart ? nowMs : apartMs;
        send(pose, 1);
      }
    }
  }

  @Test
  void withoutAnAttackTheRobotComesToItsGoal() {
    run(null, 0, 12_000, true);
    assertThat(xMm).isBetween(GOAL_MM - 20, GOAL_MM + 20);
    assertThat(lines).isEmpty();
  }

  @ParameterizedTest
  @EnumSource
  void twoStreamsStopTheRobotWithinItsReactionTimeAndAreTold(Attack attack) {
    run(attack, ATTACK_MS, 20_000, true);
    assertThat(longestMm).isLessThanOrEqualTo(SPEED * REACTION_MS / 1000);
    assertThat(offMm).isLessThan(60);
    assertThat(lines)
        .anyMatch(line -> line.contains("bot0 is measured at (") && line.contains(" and at ("));
    assertThat(lines).hasSizeLessThan(10);
  }

  @ParameterizedTest
  @EnumSource
  void twoStreamsFromTheBeginningMoveNothing(Attack attack) {
    run(attack, 1, 20_000, true);
    assertThat(longestMm).isLessThanOrEqualTo(SPEED * REACTION_MS / 1000);
    assertThat(offMm).isLessThan(60);
  }

  @ParameterizedTest
  @EnumSource
  void posesThatReplaceTheTrueOnesAreJudgedByTheWheels(Attack attack) {
    run(attack, ATTACK_MS, 60_000, false);
    // The sensors' delay, as it is and as it is assumed, the errors of two fixes, a part of the
    // way.
    double mostMm = SPEED * (SENSORS_LATE_MS + 1.1 * REACTION_MS) / 1000 + 10 + 0.16 * 250;
    assertThat(offMm).isLessThan(mostMm);
    assertThat(xMm).isLessThan(GOAL_MM + mostMm);
  }

  @Test
  void aStreamThatBeganBeforeTheTrueOneStopsTheRobotWhenThatComes() {
    run(Attack.SCALED, 1, 2000, false);
    assertThat(xMm).isGreaterThan(50);
    double atMm = xMm;
    run(Attack.SCALED, 1, 20_000, true);
    assertThat(xMm - atMm).isLessThanOrEqualTo(SPEED * REACTION_MS / 1000);
  }

  @ParameterizedTest
  @EnumSource
  void afterTheAttackTheRobotDrivesOn(Attack attack) {
    run(attack, ATTACK_MS, 6000, true);
    double atMm = xMm;
    run(null, 0, 30_000, true);
    assertThat(atMm).isLessThan(GOAL_MM - 100);
    assertThat(xMm).isBetween(GOAL_MM - 20, GOAL_MM + 20);
  }

  @ParameterizedTest
  @EnumSource
  void aRobotOffTheFloorBelievesNoPlace(Attack attack) {
    path.lift(true);
    run(attack, 1, 3000, false);
    assertThat(newest).isNull();
    path.lift(false);
    run(attack, 1, 20_000, true);
    assertThat(longestMm).isLessThanOrEqualTo(SPEED * REACTION_MS / 1000);
    assertThat(offMm).isLessThan(60);
    run(null, 0, 50_000, true);
    assertThat(xMm).isBetween(GOAL_MM - 20, GOAL_MM + 20);
  }

  @Test
  void aRobotThatIsLiftedAndCarriedDrivesOnFromItsNewPlace() {
    run(null, 0, 3000, true);
    double fromMm = xMm;
    xMm += 400;
    path.lift(true);
    path.add(nowMs * MS, 1.04 * fromMm, 0, 0, false);
    path.lift(false);
    run(null, 0, 15_000, true);
    assertThat(xMm).isBetween(GOAL_MM - 20, GOAL_MM + 20);
    assertThat(lines).anyMatch(line -> line.contains("was moved by hand"));
  }
}
