package org.starl.apps.search;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.HousePlan;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.random.Rng;

/**
 * A house drawn from the seed: a hall from the bottom up, corridors across it, boxes in columns
 * along both sides of each corridor and of the hall. A box is a room with a door to the corridor, or
 * solid once the house has all its rooms. Rooms differ in width and depth; in some a wall or a
 * pillar stands. Robots start at the hall's lower end.
 */
final class GeneratedHouse {

  static final int MAX_ROOMS = 24;

  /** Each corridor has so many columns of four boxes: left and right, below and above it. */
  private static final int MAX_COLUMNS = 3;

  private static final int WALL_MM = 100;
  private static final int HALL_MM = 1_600;
  private static final int CORRIDOR_MM = 1_400;
  private static final int DOOR_MM = 900;
  private static final int BESIDE_DOOR_MM = 300;
  private static final int PILLAR_MM = 300;

  /** What a wall in a room leaves free before the door's side. */
  private static final int PASSAGE_MM = 1_000;

  private static final int START_MM = 700;
  private static final int STEP_MM = 100;

  private final Rng rng;
  private final List<Obstacle> walls = new ArrayList<>();
  private final List<ItemPosition> doors = new ArrayList<>();

  private GeneratedHouse(Rng rng) {
    this.rng = rng;
  }

  /**
   * A house.
   *
   * @param rooms from 1 to {@link #MAX_ROOMS}
   * @param robots how many starts it has
   */
  static HousePlan of(int rooms, int robots, Rng rng) {
    return new GeneratedHouse(rng).plan(rooms, robots);
  }

  /** A place in one of the rooms that a robot can see. */
  static Point somewhere(House house, Rng rng) {
    int[] cells = house.room(rng.nextInt(house.rooms().size())).cells().stream().toArray();
    int cell;
    do {
      cell = cells[rng.nextInt(cells.length)];
    } while (!house.canBeSeen(cell));
    return house.grid().centre(cell);
  }

  private HousePlan plan(int rooms, int robots) {
    int corridors = (rooms + 4 * MAX_COLUMNS - 1) / (4 * MAX_COLUMNS);
    int columns = (rooms + 4 * corridors - 1) / (4 * corridors);
    int[] sides = new int[columns + 1];
    sides[0] = HALL_MM / 2;
    for (int i = 0; i < columns; i++) {
      sides[i + 1] = sides[i] + draw(2_300, 2_800);
    }
    int middle = sides[columns];
    List<Point> starts = new ArrayList<>();
    int rows = (robots + 1) / 2;
    for (int i = 0; i < robots; i++) {
      // The first ones stand in front.
      double x = middle + (i % 2 - 0.5) * START_MM;
      starts.add(new Point(x, (rows - i / 2 - 0.5) * START_MM));
    }
    int y = rows * START_MM;
    box(0, 0, middle - sides[0], y);
    box(middle + sides[0], 0, 2 * middle, y);
    for (int corridor = 0; corridor < corridors; corridor++) {
      int low = y + draw(2_400, 3_200);
      int high = low + CORRIDOR_MM;
      int top = high + draw(2_400, 3_200);
      for (int i = 0; i < columns; i++) {
        for (int side = -1; side <= 1; side += 2) {
          int from = middle + side * sides[i];
          int to = middle + side * sides[i + 1];
          roomOrBox(from, to, low, y, rooms);
          roomOrBox(from, to, high, top, rooms);
        }
      }
      y = top;
    }
    Rectangle bounds = new Rectangle(0, 0, 2 * middle, y);
    return new HousePlan(bounds, new Obstacles(walls), doors, starts);
  }

  private int draw(int fromMm, int toMm) {
    return (int) rng.nextLong(fromMm / STEP_MM, toMm / STEP_MM) * STEP_MM;
  }

  /**
   * Adds a room, or a solid box if the house has all its rooms.
   *
   * @param x0 its side towards the hall
   * @param x1 its other side
   * @param near its side at the corridor, with the door
   * @param far its other side
   */
  private void roomOrBox(int x0, int x1, int near, int far, int rooms) {
    if (doors.size() == rooms) {
      box(x0, near, x1, far);
      return;
    }
    int out = Integer.signum(x1 - x0);
    int up = Integer.signum(far - near);
    int inside = near + up * WALL_MM;
    int most = Math.abs(x1 - x0) - 2 * BESIDE_DOOR_MM - DOOR_MM;
    int door = x0 + out * (BESIDE_DOOR_MM + draw(0, most));
    box(x0, near, door, inside);
    box(door + out * DOOR_MM, near, x1, inside);
    box(x0, far, x1, far - up * WALL_MM);
    box(x0, near, x0 + out * WALL_MM, far);
    box(x1, near, x1 - out * WALL_MM, far);
    String name = String.valueOf((char) ('A' + doors.size()));
    doors.add(new ItemPosition(name, door + out * DOOR_MM / 2.0, near + up * WALL_MM / 2.0));
    int x = (x0 + x1) / 2;
    int y = (near + far) / 2;
    if (rng.nextBoolean(0.4)) {
      box(x, far, x + WALL_MM, inside + up * PASSAGE_MM);
    } else if (rng.nextBoolean(0.4)) {
      box(x, y, x + PILLAR_MM, y + PILLAR_MM);
    }
  }

  /** A solid body between two opposite corners. */
  private void box(int x0, int y0, int x1, int y1) {
    walls.add(
        Obstacle.body(new Point(x0, y0), new Point(x1, y0), new Point(x1, y1), new Point(x0, y1)));
  }
}
