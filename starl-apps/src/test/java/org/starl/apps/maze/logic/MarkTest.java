package org.starl.apps.maze.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.starl.body.Bumps;
import org.starl.geometry.Angles;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Pose;
import org.starl.motion.Contact;
import org.starl.motion.Location;
import org.starl.random.Rng;

/** Marks against the points that were really touched. */
class MarkTest {

  private static final double BODY_MM = 165;

  /** Where one sensor's side begins and ends, in degrees: there all of an error of the heading counts. */
  private static final double[] EDGES = {-90, -15, 15, 90};

  private static Contact told(Pose at, double errorMm, double errorRad, Bumps bumps) {
    return new Contact(new Location.Known(at, errorMm, errorRad, 0, 0), bumps);
  }

  /** A body that touches one or two points before it, told by a robot that knows neither well. */
  private record Touching(Contact contact, List<Point> touched) {
    static Touching drawn(Rng rng, double mostErrorMm, double mostErrorRad) {
      Pose truth = new Pose(5_000, 5_000, StrictMath.PI * (2 * rng.nextDouble() - 1));
      boolean left = false;
      boolean right = false;
      List<Point> touched = new ArrayList<>();
      for (int i = 0; i <= rng.nextInt(2); i++) {
        double degrees = rng.nextBoolean(0.5) ? 180 * rng.nextDouble() - 90 : EDGES[rng.nextInt(4)];
        double bearing = Angles.fromDegrees(degrees);
        double direction = truth.headingRad() + bearing;
        double mm = BODY_MM + 2 * rng.nextDouble();
        touched.add(
            new Point(
                truth.xMm() + mm * StrictMath.cos(direction),
                truth.yMm() + mm * StrictMath.sin(direction)));
        left |= bearing >= Angles.fromDegrees(-15);
        right |= bearing <= Angles.fromDegrees(15);
      }
      // In half of the cases nothing but the heading is wrong: no allowance for more hides its own.
      double errorMm = rng.nextBoolean(0.5) ? 0 : mostErrorMm * rng.nextDouble();
      double errorRad = mostErrorRad * rng.nextDouble();
      double offRad = 2 * StrictMath.PI * rng.nextDouble();
      Pose told =
          new Pose(
              truth.xMm() + errorMm * StrictMath.cos(offRad),
              truth.yMm() + errorMm * StrictMath.sin(offRad),
              truth.headingRad() + errorRad * (2 * rng.nextDouble() - 1));
      return new Touching(told(told, errorMm, errorRad, Bumps.of(left, right)), touched);
    }
  }

  @Property(tries = 2_000)
  void noBodyWiderByAPartOfTheMarginFitsInAMarkForThatPart(@ForAll long seed) {
    Rng rng = new Rng(seed);
    Touching touching = Touching.drawn(rng, 60, 0.3);
    for (Mark mark : Mark.of(touching.contact(), BODY_MM)) {
      for (double part : new double[] {1, 0.5, 0}) {
        Polygon place = mark.place(part);
        for (int i = 0; place != null && i < 40; i++) {
          Point at =
              i < place.vertices().size()
                  ? place.vertices().get(i)
                  : new Point(4_700 + 600 * rng.nextDouble(), 4_700 + 600 * rng.nextDouble());
          double nearestMm = Double.POSITIVE_INFINITY;
          for (Point touched : touching.touched()) {
            nearestMm = Math.min(nearestMm, touched.distanceMm(at));
          }
          if (place.contains(at)) {
            assertThat(nearestMm).as("part %s", part).isLessThan(BODY_MM + part * 75);
          }
        }
      }
    }
  }

  @Property(tries = 500)
  void aMarkContainsADiscAroundTheRobotsPosition(@ForAll long seed) {
    Touching touching = Touching.drawn(new Rng(seed), 20, 0.1);
    List<Mark> marks = Mark.of(touching.contact(), BODY_MM);
    assertThat(marks).isNotEmpty();
    for (Mark mark : marks) {
      Polygon place = mark.place(1);
      assertThat(place).isNotNull();
      // The margin without the error, the width of a contact and the rounding of corners.
      double sureMm = 75 - touching.contact().at().errorMm() - 2 - 3 - 2;
      assertThat(place.depthMm(mark.at())).isGreaterThan(0.85 * sureMm);
    }
  }

  @Example
  void anUncertainPositionProvesNothing() {
    Pose at = new Pose(0, 0, 0);
    assertThat(Mark.of(told(at, 70, 0, Bumps.LEFT), BODY_MM)).isEmpty();
    assertThat(Mark.of(told(at, 0, 2, Bumps.LEFT), BODY_MM)).isEmpty();
    assertThat(Mark.of(told(at, 0, 0, Bumps.LEFT), BODY_MM)).hasSize(1);
    assertThat(Mark.of(told(at, 0, 0, Bumps.BOTH), BODY_MM)).hasSize(2);
  }
}
