package org.starl.apps.search.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Segment;
import org.starl.random.Rng;

/** A sweep sees all of its room: checked by a second computation, in rooms of many shapes. */
class SweepTest {

  private static final double RANGE_MM = 600;
  private static final double CLEARANCE_MM = 280;
  private static final int WALL_MM = 100;

  private static Obstacle box(double x0, double y0, double x1, double y1) {
    return Obstacle.body(
        new Point(x0, y0), new Point(x1, y0), new Point(x1, y1), new Point(x0, y1));
  }

  /** A room above a hall, with up to four pieces of wall in it, some of them askew. */
  static HousePlan drawn(Rng rng) {
    double width = rng.nextLong(1_500, 5_000);
    double height = rng.nextLong(1_500, 4_000);
    double hall = 1_200;
    double door = rng.nextLong(200, (long) width - 1_000);
    List<Obstacle> walls = new ArrayList<>();
    walls.add(box(-WALL_MM, -WALL_MM, width + WALL_MM, 0));
    walls.add(box(-WALL_MM, 0, 0, hall + height + 2 * WALL_MM));
    walls.add(box(width, 0, width + WALL_MM, hall + height + 2 * WALL_MM));
    walls.add(box(0, hall, door, hall + WALL_MM));
    walls.add(box(door + 800, hall, width, hall + WALL_MM));
    walls.add(box(0, hall + WALL_MM + height, width, hall + height + 2 * WALL_MM));
    for (int i = rng.nextInt(5); i > 0; i--) {
      double x = rng.nextLong(0, (long) width);
      double y = hall + WALL_MM + rng.nextLong(900, (long) height);
      double u = rng.nextLong(50, 700);
      double v = rng.nextLong(50, 700);
      double askew = rng.nextBoolean(0.3) ? rng.nextLong(-200, 200) : 0;
      walls.add(
          Obstacle.body(
              new Point(x, y),
              new Point(x + u, y + askew),
              new Point(x + u, y + v + askew),
              new Point(x, y + v)));
    }
    return new HousePlan(
        new Rectangle(-WALL_MM, -WALL_MM, width + WALL_MM, hall + height + 2 * WALL_MM),
        new Obstacles(walls),
        List.of(new ItemPosition("A", door + 400, hall + WALL_MM / 2.0)),
        List.of(new Point(width / 2, hall / 2)));
  }

  private static final class Reckoning {
    private final HousePlan plan;
    private final List<Point> way = new ArrayList<>();

    Reckoning(HousePlan plan, Sweep sweep) {
      this.plan = plan;
      for (Segment leg : sweep.legs()) {
        double lengthMm = leg.from().distanceMm(leg.to());
        int steps = (int) (lengthMm / 50);
        for (int i = 0; i <= steps; i++) {
          double part = steps == 0 ? 0 : (double) i / steps;
          way.add(leg.from().plus(leg.to().minus(leg.from()).times(part)));
        }
      }
    }

    /** Step by step along the line: no obstacle is there. */
    private boolean sees(Point from, Point to) {
      int steps = (int) (from.distanceMm(to) / 10) + 1;
      for (int i = 0; i <= steps; i++) {
        Point between = from.plus(to.minus(from).times((double) i / steps));
        if (plan.walls().distanceMm(between) == 0) {
          return false;
        }
      }
      return true;
    }

    boolean seesFromSomewhere(Point cell) {
      for (Point at : way) {
        if (at.distanceMm(cell) <= RANGE_MM && sees(at, cell)) {
          return true;
        }
      }
      return false;
    }

    boolean keepsClear() {
      return way.stream().allMatch(at -> plan.walls().distanceMm(at) >= CLEARANCE_MM - 50);
    }
  }

  @Property(tries = 20)
  @Tag("long")
  void allCellsThatCanBeSeenComeIntoView(@ForAll long seed) {
    HousePlan plan = drawn(new Rng(seed));
    House house = House.of(plan, RANGE_MM, CLEARANCE_MM);
    Room room = house.room(0);
    Sweep sweep = Sweep.of(house, room, room.entry());
    Reckoning reckoning = new Reckoning(plan, sweep);
    assertThat(reckoning.keepsClear()).as("clear of walls, seed %d", seed).isTrue();
    room.cells().stream()
        .forEach(cell -> {
          boolean isSeen = reckoning.seesFromSomewhere(house.grid().centre(cell));
          boolean isHidden = sweep.hidden().get(cell);
          assertThat(isSeen || isHidden)
              .as("%s of seed %d comes into view", house.grid().centre(cell), seed)
              .isTrue();
        });
  }

  @Property(tries = 25)
  void onlyCellsThatNoPlaceSeesAreHidden(@ForAll long seed) {
    House house = House.of(drawn(new Rng(seed)), RANGE_MM, CLEARANCE_MM);
    Room room = house.room(0);
    Sweep sweep = Sweep.of(house, room, room.entry());
    room.cells().stream()
        .forEach(cell -> {
          if (sweep.hidden().get(cell)) {
            assertThat(house.canBeSeen(cell, room.places())).as("cell %d", cell).isFalse();
          }
        });
  }

  @Property(tries = 25)
  void theRestOfARoomIsSweptByStops(@ForAll long seed) {
    House house = House.of(drawn(new Rng(seed)), RANGE_MM, CLEARANCE_MM);
    Room room = house.room(0);
    BitSet rest = (BitSet) room.cells().clone();
    int half = rest.length() - rest.cardinality() / 2;
    rest.clear(0, half);
    Sweep sweep = Sweep.ofRest(house, rest, room.places(), room.entry());
    Coverage coverage = new Coverage(house, rest);
    coverage.forget(sweep.hidden());
    for (Segment leg : sweep.legs()) {
      assertThat(leg.from()).isEqualTo(leg.to());
      coverage.look(leg.from(), House.SLACK_MM);
    }
    assertThat(coverage.isComplete()).as("seed %d", seed).isTrue();
  }

  @Property(tries = 25)
  @Tag("long")
  void theRestOfARoomIsSeenFromPlacesThatAreNotBarred(@ForAll long seed) {
    House house = House.of(drawn(new Rng(seed)), RANGE_MM, CLEARANCE_MM);
    Room room = house.room(0);
    Point first =
        Sweep.ofRest(house, room.cells(), room.places(), room.entry()).legs().get(0).from();
    BitSet places = (BitSet) room.places().clone();
    house.grid().within(first, 300).forEach(places::clear);
    Sweep sweep = Sweep.ofRest(house, room.cells(), places, room.entry());
    Coverage coverage = new Coverage(house, room.cells());
    coverage.forget(sweep.hidden());
    for (Segment leg : sweep.legs()) {
      assertThat(leg.from().distanceMm(first)).as("seed %d", seed).isGreaterThan(300);
      coverage.look(leg.from(), House.SLACK_MM);
    }
    assertThat(coverage.isComplete()).as("seed %d", seed).isTrue();
  }
}
