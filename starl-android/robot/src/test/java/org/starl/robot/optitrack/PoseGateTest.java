package org.starl.robot.optitrack;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.geometry.Fix;
import org.starl.geometry.Pose;
import org.starl.random.Rng;
import org.starl.robot.optitrack.PoseGate.Verdict;

/** Possible and impossible fixes of a robot that drives 550 mm/s at most; in virtual time. */
class PoseGateTest {

  private static final long MS = 1_000_000;
  private static final double SPEED = 550;
  private static final double ERROR = 5;
  private static final long STILL_MS = 700;
  private static final FixBounds BOUNDS = FixBounds.DEFAULT.withMotion(SPEED, STILL_MS);

  private final List<String> lines = new ArrayList<>();
  private final Tally tally = new Tally((timeNs, level, tag, line) -> lines.add(line), "test");
  private final PoseGate gate = new PoseGate(BOUNDS);
  private long nowMs;

  private static Fix fix(double xMm, double headingRad, long atMs, double errorMm) {
    return new Fix(new Pose(xMm, 0, headingRad), atMs * MS, errorMm, 0.02);
  }

  private Verdict at(double xMm) {
    return gate.judge(fix(xMm, 0, nowMs, ERROR), null);
  }

  /** The robot stands at 0 and was measured there for a second. */
  private void settle() {
    for (; nowMs < 1000; nowMs += 10) {
      at(0);
    }
  }

  @Test
  void theFirstPlaceCountsOnceItWasMeasuredForTheTime() {
    for (; nowMs < STILL_MS; nowMs += 10) {
      assertThat(at(0)).isEqualTo(Verdict.EARLY);
    }
    assertThat(at(0)).isEqualTo(Verdict.PASSED);
  }

  @Test
  void anOlderFixOfTheFirstPlaceIsNoJump() {
    nowMs = 1000;
    at(0);
    nowMs -= 1;
    assertThat(at(0)).isEqualTo(Verdict.OUTDATED);
    nowMs += 11;
    assertThat(at(0)).isEqualTo(Verdict.EARLY);
  }

  @Test
  void withoutATimeEachNewerFixIsUsed() {
    PoseGate open = new PoseGate(FixBounds.DEFAULT);
    assertThat(open.judge(fix(0, 0, 1, 5), null)).isEqualTo(Verdict.PASSED);
    assertThat(open.judge(fix(9000, 3, 2, 5), null)).isEqualTo(Verdict.PASSED);
    assertThat(open.judge(fix(9000, 3, 2, 5), null)).isEqualTo(Verdict.OUTDATED);
  }

  /** Any way within speed and errors, with any times between the fixes. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  void everyFixOfARobotThatDrivesPasses(long seed) {
    settle();
    Rng rng = new Rng(seed);
    double xMm = 0;
    double headingRad = 0;
    for (int i = 0; i < 5000; i++) {
      long stepMs = 1 + rng.nextInt(rng.nextBoolean(0.02) ? 600 : 30);
      nowMs += stepMs;
      xMm += (2 * rng.nextDouble() - 1) * SPEED * stepMs / 1000;
      headingRad += (2 * rng.nextDouble() - 1) * BOUNDS.maxTurnRadPerS() * stepMs / 1000;
      double noiseMm = (2 * rng.nextDouble() - 1) * ERROR;
      assertThat(gate.judge(fix(xMm + noiseMm, headingRad, nowMs, ERROR), null))
          .as("fix %s", i)
          .isEqualTo(Verdict.PASSED);
    }
  }

  @Test
  void singleFalsePosesAmongTrueOnesAreJumpsAndTheTrueOnesPass() {
    settle();
    for (int i = 0; i < 1000; i++) {
      nowMs += 5;
      if (i % (STILL_MS / 5) == 0) {
        assertThat(at(2000)).isEqualTo(Verdict.JUMPED);
        // A false fix may claim a later time than the true one that comes after it.
        nowMs += i % 3 - 1;
      }
      assertThat(at(0)).isEqualTo(Verdict.PASSED);
    }
  }

  @Test
  void manyFalsePosesAreNeverUsedAndNoTrueOneIsUntilTheyEnd() {
    settle();
    for (int i = 0; i < 1000; i++) {
      nowMs += 5;
      assertThat(at(2000)).isEqualTo(i == 2 ? Verdict.CONTRADICTED : Verdict.JUMPED);
      nowMs += i % 3 - 1;
      assertThat(at(0)).isEqualTo(i < 2 ? Verdict.PASSED : Verdict.DOUBTED);
    }
    long lastMs = nowMs;
    for (nowMs += 5; nowMs < lastMs + STILL_MS - 1; nowMs += 5) {
      assertThat(at(0)).isEqualTo(Verdict.DOUBTED);
    }
    nowMs += 5;
    assertThat(at(0)).isEqualTo(Verdict.PASSED);
  }

  @Test
  void falsePosesAfterALossOfTheTrueOnesAreJumpsIfTheyCameBefore() {
    settle();
    for (int i = 0; i < 10; i++) {
      nowMs += 5;
      at(2000);
      nowMs += 5;
      at(0);
    }
    long lostMs = nowMs;
    for (nowMs += 5; nowMs < lostMs + PoseGate.DOUBT_NS / MS; nowMs += 5) {
      assertThat(at(2000)).isEqualTo(Verdict.JUMPED);
    }
    assertThat(at(2000)).isEqualTo(Verdict.MOVED);
  }

  @Test
  void aTurnFasterThanTheRobotIsAJump() {
    settle();
    assertThat(gate.judge(fix(0, 1.5, nowMs, ERROR), null)).isEqualTo(Verdict.JUMPED);
    assertThat(gate.judge(fix(0, 0.08, nowMs, ERROR), null)).isEqualTo(Verdict.PASSED);
  }

  @Test
  void aRobotMovedByHandHasFixesAgainAfterTheTime() {
    settle();
    long movedMs = nowMs;
    for (; nowMs < movedMs + STILL_MS; nowMs += 10) {
      assertThat(at(2000)).isIn(Verdict.JUMPED, Verdict.CONTRADICTED);
    }
    assertThat(at(2000)).isEqualTo(Verdict.MOVED);
    nowMs += 10;
    assertThat(at(2000)).isEqualTo(Verdict.PASSED);
  }

  @Test
  void fewFalsePosesAfterALossOfTheTrueOnesAreNotANewPlace() {
    settle();
    for (int i = 0; i < 20; i++) {
      nowMs += STILL_MS + 1;
      assertThat(at(2000)).isEqualTo(Verdict.JUMPED);
    }
    nowMs += 10;
    assertThat(at(0)).isEqualTo(Verdict.PASSED);
  }

  @Test
  void aLongGapIsNoLongWay() {
    settle();
    nowMs += 60_000;
    assertThat(at(SPEED * STILL_MS / 1000 + 2 * ERROR + 1)).isEqualTo(Verdict.JUMPED);
    assertThat(at(SPEED * STILL_MS / 1000 + 2 * ERROR - 1)).isEqualTo(Verdict.PASSED);
  }

  /** A false fix each ms, each a little further: their errors do not add up. */
  @ParameterizedTest
  @ValueSource(doubles = {ERROR, 20, 1e6})
  void manyFalseFixesInARowMoveARobotLittleFasterThanItDrives(double claimedErrorMm) {
    double errorMm = Math.min(claimedErrorMm, PoseGate.MOST_ERROR_MM);
    double furthestMm = 0;
    for (double stepMm = SPEED / 1000; stepMm < 256; stepMm *= 1.2) {
      PoseGate open = new PoseGate(BOUNDS);
      for (int ms = 0; ms < 1000; ms++) {
        open.judge(fix(0, 0, ms, claimedErrorMm), null);
      }
      for (int i = 1; i <= 1000; i++) {
        if (open.judge(fix(i * stepMm, 0, 1000 + i, claimedErrorMm), null) == Verdict.PASSED) {
          furthestMm = Math.max(furthestMm, i * stepMm);
        }
      }
    }
    assertThat(furthestMm).isBetween(0.9 * SPEED, 1.1 * SPEED + 12 * 2 * errorMm);
  }

  @Test
  void anEpisodeOfJumpsIsToldOnceWithRobotAndBothPoses() {
    for (int i = 0; i < 80; i++) {
      nowMs += 10;
      tally.admit(gate, "bot0", fix(1, 0, nowMs, ERROR), nowMs * MS);
    }
    assertThat(lines).isEmpty();
    for (int i = 0; i < 500; i++) {
      nowMs += 5;
      assertThat(tally.admit(gate, "bot0", fix(2000, 0, nowMs, ERROR), nowMs * MS)).isFalse();
      nowMs += 5;
      tally.admit(gate, "bot0", fix(1, 0, nowMs, ERROR), nowMs * MS);
    }
    assertThat(lines)
        .containsExactly(
            "bot0 jumps from (1 mm, 0 mm, 0.00 rad) to (2000 mm, 0 mm, 0.00 rad): faster than a"
                + " robot drives, or otherwise than its wheels, so no fix; further ones are only"
                + " counted: JUMPED");
    assertThat(tally.statistics().dropped(FeedDrop.JUMPED)).isEqualTo(500);

    nowMs += Tally.EPISODE_NS / MS + 1;
    for (int i = 0; i < 80; i++) {
      nowMs += 10;
      tally.admit(gate, "bot0", fix(3000, 0, nowMs, ERROR), nowMs * MS);
    }
    assertThat(lines).hasSize(3);
    assertThat(lines.get(2))
        .isEqualTo("bot0 was moved by hand: it is at (3000 mm, 0 mm, 0.00 rad)");
  }

  @Test
  void jumpsOfInventedBodiesFillNoLog() {
    for (int i = 0; i < 1000; i++) {
      PoseGate other = new PoseGate(BOUNDS);
      tally.admit(other, "body" + i, fix(0, 0, 1, ERROR), 1);
      tally.admit(other, "body" + i, fix(5000, 0, 2, ERROR), 2);
    }
    assertThat(lines).hasSizeLessThan(100);
    assertThat(tally.statistics().dropped(FeedDrop.JUMPED)).isEqualTo(1000);
  }
}
