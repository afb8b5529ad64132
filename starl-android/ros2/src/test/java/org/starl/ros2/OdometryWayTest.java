package org.starl.ros2;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tuple;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Angles;
import org.starl.geometry.Pose;
import org.starl.robot.create.CreateTravel;
import org.starl.robot.file.Limits;

/** The way of a base by its odometry. */
class OdometryWayTest {

  private static final long PERIOD_NS = 50_000_000;

  /** One period of driving; the message at its end may be lost. */
  record Step(double forwardMm, double turnRad, boolean isLost) {}

  private static final Limits LIMITS = new Limits(300, 300, 500, 0.1, 200);

  @Provide
  Arbitrary<List<Step>> drives() {
    return Combinators.combine(
            Arbitraries.doubles().between(-16, 16),
            Arbitraries.doubles().between(-0.1, 0.1),
            Arbitraries.frequencyOf(
                Tuple.of(9, Arbitraries.just(false)), Tuple.of(1, Arbitraries.just(true))))
        .as(Step::new)
        .list()
        .ofMaxSize(60);
  }

  @Property(tries = 200)
  void itIsTheSumOfTheStepsAlsoIfMessagesAreLost(@ForAll("drives") List<Step> drive) {
    checkTheSum(drive);
  }

  @Test
  void aTurnAfterALostMessageTiltsTheChordOfTheWayBefore() {
    checkTheSum(List.of(new Step(0.01, 0, true), new Step(0, 0.03, false)));
  }

  private static void checkTheSum(List<Step> drive) {
    OdometryWay way = new OdometryWay(LIMITS);
    Pose pose = new Pose(1000, -500, 3);
    double forwardMm = 0;
    double turnedRad = 0;
    double drivenSinceMessage = 0;
    double turnedSinceMessage = 0;
    int stepsSinceMessage = 0;
    double errorMm = 0;
    long nowNs = 1;
    assertThat(way.add(message(nowNs, pose))).isFalse();
    for (Step step : drive) {
      double middle = pose.headingRad() + step.turnRad / 2;
      pose =
          new Pose(
              pose.xMm() + step.forwardMm * StrictMath.cos(middle),
              pose.yMm() + step.forwardMm * StrictMath.sin(middle),
              Angles.normalize(pose.headingRad() + step.turnRad));
      forwardMm += step.forwardMm;
      turnedRad += step.turnRad;
      nowNs += PERIOD_NS;
      drivenSinceMessage += Math.abs(step.forwardMm);
      turnedSinceMessage += Math.abs(step.turnRad);
      stepsSinceMessage++;
      if (!step.isLost) {
        // Lost messages leave one chord in place of their arcs: no arc is turned from it by more
        // than the turns between the two
        // messages.
        if (stepsSinceMessage > 1) {
          errorMm +=
              drivenSinceMessage * (1 - StrictMath.cos(Math.min(turnedSinceMessage, Math.PI)));
        }
        assertThat(way.add(message(nowNs, pose))).isTrue();
        CreateTravel travel = way.travel();
        assertThat(travel.forwardMm()).isCloseTo(forwardMm, within(errorMm + 1e-6));
        assertThat(travel.turnedRad()).isCloseTo(turnedRad, within(1e-9));
        drivenSinceMessage = 0;
        turnedSinceMessage = 0;
        stepsSinceMessage = 0;
      }
    }
  }

  @Test
  void aStepThatNoWheelsMakeIsANewBeginning() {
    OdometryWay way = new OdometryWay(LIMITS);
    way.add(message(1, new Pose(0, 0, 0)));
    assertThat(way.add(message(1 + PERIOD_NS, new Pose(200, 0, 0)))).isFalse();
    assertThat(way.add(message(1 + 2 * PERIOD_NS, new Pose(210, 0, 0)))).isTrue();
    assertThat(way.travel().forwardMm()).isEqualTo(10);
    assertThat(way.add(message(1 + 2 * PERIOD_NS, new Pose(220, 0, 0)))).isFalse(); // the same time
    assertThat(way.add(message(1 + 3 * PERIOD_NS, null))).isFalse();
    assertThat(way.add(message(1 + 4 * PERIOD_NS, new Pose(230, 0, 0)))).isFalse();
  }

  private static Messages.Odometry message(long stampNs, Pose pose) {
    return new Messages.Odometry(stampNs, pose, 0, 0);
  }
}
