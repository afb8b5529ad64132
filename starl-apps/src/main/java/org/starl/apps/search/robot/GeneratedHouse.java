package org.starl.apps.search.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.HousePlan;
import org.starl.apps.search.logic.Room;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.random.Rng;

/**
 * A house drawn from the seed: a hall from the bottom up, corridors across it, rooms along both
 * sides of each corridor. Rooms differ in width and depth; in some a wall or a pillar stands.
 * Robots start at the hall's lower end.
 */
public final class GeneratedHouse {

  public static final int MAX_ROOMS = 24;

  private static final int WALL_MM = 100;
  private static final int HALL_MM = 1_600;
  private static final int CORRIDOR_MM = 1_400;
  private static final int DOOR_MM = 900;
  private static final int BESIDE_DOOR_MM = 200;
  private static final int ROOM_MM = 2_500;
  private static final int JITTER_MM = 300;
  private static final int MIN_DEPTH_MM = 2_200;
  private static final int MAX_DEPTH_MM = 3_000;
  private static final int STEP_MM = 100;
  private static final int GAP_MM = 1_000;
  private static final int PILLAR_MM = 300;
  private static final int START_MM = 700;

  /** More robots start farther apart: in a longer house tubes have longer parts, and are wider. */
  private static final int ROBOTS_NEAR = 12;

  private static final int START_FAR_MM = 800;
  private static final int START_ROWS_FROM_MM = 500;

  /** More robots start in a lobby before the hall: a longer house would have tubes wider than its doors. */
  private static final int ROBOTS_IN_THE_HALL = 40;

  private static final int MOST_COLUMNS = 20;
  private static final int ROOMS_PER_RUN = 3;
  private static final int RUNS = 4;

  private final Rng rng;
  private final List<Obstacle> walls = new ArrayList<>();
  private final List<ItemPosition> doors = new ArrayList<>();
  private final int hallLeft;
  private final int hallRight;

  private GeneratedHouse(Rng rng) {
    this.rng = rng;
    hallLeft = ROOMS_PER_RUN * ROOM_MM + 2 * WALL_MM;
    hallRight = hallLeft + HALL_MM;
  }

  /**
   * A house.
   *
   * @param rooms from 1 to {@link #MAX_ROOMS}
   * @param robots how many starts it has
   */
  public static HousePlan of(int rooms, int robots, Rng rng) {
    return new GeneratedHouse(rng).plan(rooms, robots);
  }

  /** A place in one of the rooms that a robot can see. */
  public static Point somewhere(House house, Rng rng) {
    Room room = house.room(rng.nextInt(house.rooms().size()));
    List<Integer> cells =
        room.cells().stream().boxed().collect(Collectors.toCollection(ArrayList::new));
    int cell;
    do {
      cell = cells.remove(rng.nextInt(cells.size()));
    } while (!house.canBeSeen(cell));
    return house.grid().centre(cell);
  }

  private HousePlan plan(int rooms, int robots) {
    int corridors = (rooms + ROOMS_PER_RUN * RUNS - 1) / (ROOMS_PER_RUN * RUNS);
    int startMm = robots <= ROBOTS_NEAR ? START_MM : START_FAR_MM;
    int columns = robots <= ROBOTS_IN_THE_HALL ? 2 : MOST_COLUMNS;
    List<Point> starts = new ArrayList<>();
    for (int i = 0; i < robots; i++) {
      // The first ones stand in front.
      int row = (robots - 1) / columns - i / columns;
      double x = (hallLeft + hallRight) / 2.0 + (i % columns - (columns - 1) / 2.0) * startMm;
      starts.add(new Point(x, START_ROWS_FROM_MM + row * startMm));
    }
    int y = START_ROWS_FROM_MM + ((robots - 1) / columns + 1) * startMm;
    int hallSince = 0;
    int lobby = columns == 2 ? 0 : (columns * startMm - HALL_MM) / 2;
    if (lobby > 0) {
      lobbyWalls(lobby, y, false);
      lobbyWalls(lobby, y, true);
      hallSince = y;
    }
    int left = rooms;
    for (int i = 0; i < corridors; i++) {
      int here = (left + corridors - i - 1) / (corridors - i);
      left -= here;
      int below = depth();
      int above = depth();
      int corridor = y + 2 * WALL_MM + below;
      int[] counts = counts(here);
      run(counts[0], corridor, below, false, true);
      run(counts[1], corridor, below, true, true);
      run(counts[2], corridor, above, false, false);
      run(counts[3], corridor, above, true, false);
      closeCorridor(corridor, Math.max(counts[0], counts[2]), false, counts[0], counts[2]);
      closeCorridor(corridor, Math.max(counts[1], counts[3]), true, counts[1], counts[3]);
      hallWalls(hallSince, corridor, false);
      hallWalls(hallSince, corridor, true);
      if (Math.max(counts[0], counts[2]) == 0) {
        hallWalls(corridor, corridor + CORRIDOR_MM, false);
      }
      if (Math.max(counts[1], counts[3]) == 0) {
        hallWalls(corridor, corridor + CORRIDOR_MM, true);
      }
      hallSince = corridor + CORRIDOR_MM;
      y = hallSince + above + 2 * WALL_MM;
    }
    hallWalls(hallSince, y, false);
    hallWalls(hallSince, y, true);
    box(hallLeft - WALL_MM, hallSince, hallRight + WALL_MM, hallSince + WALL_MM);
    box(hallLeft - WALL_MM - lobby, -WALL_MM, hallRight + WALL_MM + lobby, 0);
    Rectangle bounds = new Rectangle(0, -WALL_MM, hallLeft + hallRight, y);
    return new HousePlan(bounds, new Obstacles(walls), doors, starts);
  }

  /** How many rooms each of the four runs of a corridor has, as even as can be. */
  private static int[] counts(int rooms) {
    int[] counts = new int[RUNS];
    for (int i = 0; i < rooms; i++) {
      counts[i % RUNS]++;
    }
    return counts;
  }

  private int depth() {
    return (int) rng.nextLong(MIN_DEPTH_MM / STEP_MM, MAX_DEPTH_MM / STEP_MM) * STEP_MM;
  }

  private int jitter(int mostMm) {
    return (int) rng.nextLong(-mostMm / STEP_MM, mostMm / STEP_MM) * STEP_MM;
  }

  /** Rooms in a row along one side of a corridor, from the hall outwards. */
  private void run(int count, int corridor, int depth, boolean right, boolean below) {
    int near = below ? corridor : corridor + CORRIDOR_MM;
    int out = below ? -1 : 1;
    int from = 0;
    for (int i = 1; i <= count; i++) {
      int to = i * ROOM_MM + (i < count ? jitter(JITTER_MM) : 0);
      room(from, to, near, out, depth, right);
      from = to;
    }
  }

  /**
   * One room.
   *
   * @param from its inner side, from the hall's wall outwards
   * @param to its outer side, a wall included
   * @param near y of the corridor's side
   * @param out 1 for a room above the corridor, -1 for one below it
   */
  private void room(int from, int to, int near, int out, int depth, boolean right) {
    int slack = (to - from - WALL_MM - DOOR_MM - 2 * BESIDE_DOOR_MM) / STEP_MM;
    int door = from + BESIDE_DOOR_MM + (int) rng.nextLong(0, slack) * STEP_MM;
    int far = near + out * (WALL_MM + depth);
    wall(from, door, near, near + out * WALL_MM, right);
    wall(door + DOOR_MM, to, near, near + out * WALL_MM, right);
    wall(from, to, far, far + out * WALL_MM, right);
    wall(to - WALL_MM, to, near, far, right);
    Point at = new Point(x(door + DOOR_MM / 2, right), near + out * WALL_MM / 2.0);
    doors.add(new ItemPosition(name(doors.size()), at.xMm(), at.yMm()));
    int middle = (from + to - WALL_MM) / 2 / STEP_MM * STEP_MM;
    if (rng.nextBoolean(0.4)) {
      wall(middle, middle + WALL_MM, far, near + out * (WALL_MM + GAP_MM), right);
    } else if (rng.nextBoolean(0.4)) {
      int centre = near + out * (WALL_MM + depth / 2);
      int half = PILLAR_MM / 2;
      wall(middle - half, middle + half, centre - half, centre + half, right);
    }
  }

  /**
   * Where there are rooms on one side only, the corridor has a wall on the other; and one at its
   * end.
   */
  private void closeCorridor(int corridor, int longest, boolean right, int below, int above) {
    if (longest == 0) {
      return;
    }
    int end = longest * ROOM_MM;
    int top = corridor + CORRIDOR_MM;
    wall(end, end + WALL_MM, corridor - WALL_MM, top + WALL_MM, right);
    wall(below * ROOM_MM - WALL_MM, end, corridor - WALL_MM, corridor, right);
    wall(above * ROOM_MM - WALL_MM, end, top, top + WALL_MM, right);
  }

  private void lobbyWalls(int out, int toY, boolean right) {
    wall(out - WALL_MM, out, 0, toY - WALL_MM, right);
    wall(-WALL_MM, out, toY - WALL_MM, toY, right);
  }

  private void hallWalls(int fromY, int toY, boolean right) {
    wall(-WALL_MM, 0, fromY, toY, right);
  }

  /** A body by its extent outwards from the outer side of the hall's wall. */
  private void wall(int from, int to, int y0, int y1, boolean right) {
    if (from < to) {
      box(
          Math.min(x(from, right), x(to, right)),
          Math.min(y0, y1),
          Math.max(x(from, right), x(to, right)),
          Math.max(y0, y1));
    }
  }

  private int x(int outwards, boolean right) {
    return right ? hallRight + WALL_MM + outwards : hallLeft - WALL_MM - outwards;
  }

  private void box(int x0, int y0, int x1, int y1) {
    walls.add(
        Obstacle.body(new Point(x0, y0), new Point(x1, y0), new Point(x1, y1), new Point(x0, y1)));
  }

  /** A to X: with more rooms than letters it would need two. */
  private static String name(int index) {
    return String.valueOf((char) ('A' + index));
  }
}
