package org.starl.apps.maze.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SortedSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Rectangle;
import org.starl.primitives.paths.Path;
import org.starl.random.Rng;

class FootprintTest {

  private static final double BODY_MM = 165;

  private final Blocks blocks = Blocks.of(new Rectangle(0, 0, 20_000, 15_000));
  private final Footprint footprint = new Footprint(blocks, BODY_MM, 0);

  @Property(tries = 300)
  void whatIsHeldForAWayAcrossTheFloorLeavesRoomAroundItToPlanAgain(@ForAll long seed) {
    Rng rng = new Rng(seed);
    Point at = place(rng);
    Path along = new Path(List.of(new Point(0, at.yMm()), new Point(20_000, at.yMm())));
    Path up = new Path(List.of(new Point(at.xMm(), 0), new Point(at.xMm(), 15_000)));
    Path way = rng.nextBoolean(0.5) ? along : up;
    double wanderMm = 1_000 * rng.nextDouble();
    Footprint wandering = new Footprint(blocks, BODY_MM, wanderMm);
    List<Polygon> outside = wandering.outside(wandering.along(way), false);
    Point middle = way.leg(0).from().plus(way.leg(0).to()).times(0.5);
    double directionRad = 2 * StrictMath.PI * rng.nextDouble();
    Point besides =
        middle.plus(
            new Point(StrictMath.cos(directionRad), StrictMath.sin(directionRad)).times(45));
    assertThat(outside).noneMatch(polygon -> polygon.contains(besides));
  }

  @Property(tries = 300)
  void whoStaysSparesAllThatItsBodyDoesNotTouchAndNothingElse(@ForAll long seed) {
    Rng rng = new Rng(seed);
    Point at = place(rng);
    SortedSet<String> spare = footprint.spare(blocks.all(), at);
    assertThat(spare).isNotEmpty().doesNotContainAnyElementsOf(blocks.around(at, BODY_MM));
    assertThat(spare).containsAll(footprint.spare(spare, at));
  }

  private static Point place(Rng rng) {
    return new Point(20_000 * rng.nextDouble(), 15_000 * rng.nextDouble());
  }
}
