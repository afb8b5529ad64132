package org.starl.apps.maze.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.stream.Collectors;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Rectangle;
import org.starl.primitives.paths.Path;
import org.starl.random.Rng;

class BlocksTest {

  private static final double BODY_MM = 165;
  private static final Blocks FLOOR = Blocks.of(new Rectangle(0, 0, 20_000, 15_000));

  @Property(tries = 300)
  void aFloorOfAnyShapeIsCoveredByAtMost32Blocks(@ForAll long seed) {
    Rng rng = new Rng(seed);
    double width = 300 + 100_000 * rng.nextDouble() * rng.nextDouble();
    double height = 300 + 100_000 * rng.nextDouble() * rng.nextDouble();
    Blocks blocks = Blocks.of(new Rectangle(0, 0, width, height));
    assertThat(blocks.all()).hasSizeBetween(1, 32);
    Point at = new Point(width * rng.nextDouble(), height * rng.nextDouble());
    assertThat(blocks.toRequest(new Path(List.of(at, at)), -119)).hasSizeBetween(1, 4);
  }

  @Property(tries = 300)
  void aDiscWithItsCentreNotForbiddenTouchesOnlyHeldBlocks(@ForAll long seed) {
    Rng rng = new Rng(seed);
    Path path = new Path(List.of(place(rng), place(rng), place(rng)));
    SortedSet<String> held = FLOOR.toRequest(path, 180);
    List<Polygon> forbidden = FLOOR.forbidden(held, 150);
    for (int i = 0; i < 50; i++) {
      Point at = place(rng);
      if (forbidden.stream().noneMatch(polygon -> polygon.contains(at))) {
        assertThat(held).containsAll(touched(at, 199));
      }
    }
    for (int i = 0; i < path.legs(); i++) {
      Point middle = path.leg(i).from().plus(path.leg(i).to()).times(0.5);
      assertThat(forbidden).noneMatch(polygon -> polygon.contains(middle));
    }
  }

  @Example
  void aWayThroughTheMiddleOfABlockNeedsOnlyThatBlock() {
    Blocks blocks = Blocks.of(new Rectangle(0, 0, 9_000, 6_000), 3, 2);
    Path path = new Path(List.of(new Point(4_000, 1_000), new Point(5_000, 2_000)));
    assertThat(blocks.toRequest(path, 380)).containsExactly("1.0");
    assertThat(blocks.toRequest(path, 880)).containsExactly("0.0", "1.0", "1.1", "2.0");
  }

  @Property(tries = 300)
  void blocksRequestedForAWayAcrossTheFloorLeaveRoomToPlanAgain(@ForAll long seed) {
    Rng rng = new Rng(seed);
    Point at = place(rng);
    Path along = new Path(List.of(new Point(0, at.yMm()), new Point(20_000, at.yMm())));
    Path up = new Path(List.of(new Point(at.xMm(), 0), new Point(at.xMm(), 15_000)));
    Path way = rng.nextBoolean(0.5) ? along : up;
    double reachMm = BODY_MM + 1_000 * rng.nextDouble();
    List<Polygon> forbidden = FLOOR.forbidden(FLOOR.toRequest(way, reachMm), reachMm);
    Point middle = way.leg(0).from().plus(way.leg(0).to()).times(0.5);
    double directionRad = 2 * StrictMath.PI * rng.nextDouble();
    Point beside =
        middle.plus(
            new Point(StrictMath.cos(directionRad), StrictMath.sin(directionRad)).times(45));
    assertThat(forbidden).noneMatch(polygon -> polygon.contains(beside));
  }

  @Property(tries = 300)
  void spareBlocksAreAllThatABodyDoesNotNeed(@ForAll long seed) {
    Rng rng = new Rng(seed);
    Point at = place(rng);
    SortedSet<String> spare = FLOOR.spare(FLOOR.all(), at, BODY_MM);
    assertThat(spare).isNotEmpty().doesNotContainAnyElementsOf(touched(at, BODY_MM));
    assertThat(spare).containsAll(FLOOR.spare(spare, at, BODY_MM));
  }

  private static Set<String> touched(Point at, double radiusMm) {
    return FLOOR.byName().entrySet().stream()
        .filter(block -> block.getValue().distanceMm(at) <= radiusMm)
        .map(Map.Entry::getKey)
        .collect(Collectors.toSet());
  }

  private static Point place(Rng rng) {
    return new Point(20_000 * rng.nextDouble(), 15_000 * rng.nextDouble());
  }
}
