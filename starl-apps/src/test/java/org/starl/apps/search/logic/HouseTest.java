package org.starl.apps.search.logic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Segment;
import org.starl.random.Rng;

/** Rooms are derived from walls and doors. */
class HouseTest {

  private static final Rectangle BOUNDS = new Rectangle(0, 0, 6_000, 4_000);
  private static final Point START = new Point(1_000, 500);

  private static Obstacle wall(double x0, double y0, double x1, double y1) {
    return Obstacle.body(
        new Point(x0, y0), new Point(x1, y0), new Point(x1, y1), new Point(x0, y1));
  }

  /** A hall below; above it the room L, and behind that the room R, through a door of its own. */
  private static final Obstacles WALLS =
      Obstacles.of(
          wall(0, 1_200, 1_000, 1_300),
          wall(1_900, 1_200, 6_000, 1_300),
          wall(3_000, 1_300, 3_100, 2_000),
          wall(3_000, 2_900, 3_100, 4_000));

  private static final ItemPosition LEFT = new ItemPosition("L", 1_450, 1_250);
  private static final ItemPosition RIGHT = new ItemPosition("R", 3_050, 2_450);

  private static House house(ItemPosition... doors) {
    return house(280, doors);
  }

  private static House house(double clearanceMm, ItemPosition... doors) {
    HousePlan plan = new HousePlan(BOUNDS, WALLS, List.of(doors), List.of(START));
    return House.of(plan, 600, clearanceMm);
  }

  @Test
  void aRoomIsTheFloorBehindItsDoor() {
    House house = house(RIGHT, LEFT);
    assertThat(house.rooms()).extracting(Room::name).containsExactly("R", "L");
    assertThat(house.roomAt(new Point(500, 3_500))).isEqualTo(1);
    assertThat(house.roomAt(new Point(5_500, 3_500))).isZero();
    assertThat(house.roomAt(START)).isNegative();
    assertThat(house.roomAt(new Point(3_050, 1_500))).isNegative();
    assertThat(house.roomAt(new Point(-10, 0))).isNegative();
    // 3000 by 2700 mm, and half of each doorway, in cells of 50 by 50.
    assertThat(house.room(1).cells().cardinality()).isBetween(3_240, 3_240 + 18 + 36);
    assertThat(house.rooms()).allMatch(Room::isEnterable);
  }

  @Test
  void theEntryOfARoomIsAtItsDoorAndItsRestFarFromIt() {
    House house = house(LEFT, RIGHT);
    assertThat(house.room(0).rest().distanceMm(LEFT.at())).isGreaterThan(1_500);
    assertThat(house.room(0).entry().distanceMm(LEFT.at())).isLessThan(150);
    int[] toRooms = house.distancesMm(START);
    assertThat(toRooms[0]).isBetween(900, 1_500);
    assertThat(toRooms[1]).isGreaterThan(toRooms[0] + 2_000);
  }

  @Test
  void aRoomWithTooNarrowADoorCannotBeEntered() {
    House house = house(460, LEFT, RIGHT);
    assertThat(house.rooms()).hasSize(2).noneMatch(Room::isEnterable);
    assertThat(house.canBeSeen(house.grid().cellAt(new Point(5_500, 3_500)))).isFalse();
  }

  @Test
  void aDoorThatDividesNothingIsNamed() {
    assertThatThrownBy(() -> house(new ItemPosition("X", 1_000, 600)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("door X");
    assertThatThrownBy(() -> house(new ItemPosition("X", 3_050, 1_500)))
        .hasMessageContaining("door X at")
        .hasMessageContaining("in no wall");
    assertThatThrownBy(() -> house(new ItemPosition("X", 30_050, 1_500)))
        .hasMessageContaining("expected on the floor");
  }

  @Test
  void aStartInAWallIsNamed() {
    HousePlan plan = new HousePlan(BOUNDS, WALLS, List.of(LEFT), List.of(new Point(500, 1_250)));
    assertThatThrownBy(() -> House.of(plan, 600, 280)).hasMessageContaining("start at");
  }

  @Property(tries = 200)
  void onlyObstaclesCutTheLineOfSight(@ForAll long seed) {
    Rng rng = new Rng(seed);
    Sight sight = Sight.of(WALLS);
    Point from = new Point(rng.nextLong(0, 6_000), rng.nextLong(0, 4_000));
    Point to = new Point(rng.nextLong(0, 6_000), rng.nextLong(0, 4_000));
    Segment line = new Segment(from, to);
    boolean isCut =
        WALLS.all().stream()
            .flatMap(body -> body.sides().stream())
            .anyMatch(side -> side.crosses(line));
    assertThat(sight.sees(from, to)).as("%s", line).isEqualTo(!isCut);
    double reachMm = Math.max(Math.abs(to.xMm() - from.xMm()), Math.abs(to.yMm() - from.yMm()));
    assertThat(sight.near(from, reachMm).sees(from, to)).as("near %s", line).isEqualTo(!isCut);
  }
}
