package org.starl.apps.fleet.files;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.function.UnaryOperator;
import org.starl.apps.fleet.files.view.GreyImage;
import org.starl.apps.fleet.logic.NavGraph;
import org.starl.apps.fleet.logic.NavGraph.Lane;
import org.starl.apps.fleet.logic.NavGraph.Vertex;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.input.BadInput;
import org.starl.input.Field;
import org.starl.sim.world.GridMap;

/**
 * A map of map_server or Nav2, as a grid of places with lanes both ways between neighbours. A place
 * and each pixel of a lane have the clearance to the nearest cell that is occupied, unknown or outside. Of some grids,
 * shifted by parts of the spacing, the one with the largest connected part is taken.
 *
 * <p>A cell is free as Nav2 has it: by {@code free_thresh}; the mode scale also
 * needs an opaque pixel; a pixel of the mode raw is the cell's occupancy in percent. The image's lower left corner is at {@code origin} in m, turned by its yaw.
 * Occupied cells are walls of the world; unknown ones are not.
 *
 * <p>A grid map of the path-finding benchmarks has a place in each free cell.
 *
 * <p>Stations, and the chargers where robots also park, are by turns the places beside walls that
 * robots need not pass: without all of them the others stay connected. A charger keeps the lanes of one neighbour.
 */
final class OccupancyMap {

  static final int MOST_PLACES = 10_000;
  private static final int SHIFTS = 4;

  private static final Field<Double> RESOLUTION = Field.decimal("", 1e-4, 100, "");
  private static final Field<Double> METRES = Field.decimal("", -1e5, 1e5, "");
  private static final Field<Double> RADIANS = Field.decimal("", -100, 100, "");
  private static final Field<Double> SHARE = Field.decimal("", 0, 1, "");
  private static final Field<String> NEGATE = Field.choice("", "", "0", "1", "false", "true");
  private static final Field<String> MODE = Field.choice("", "", "trinary", "scale", "raw");

  private final int width;
  private final int height;
  private final double clearancePixels;

  /** Free cells; bit 0 of each row and of one more row is never set. */
  private final BitSet free = new BitSet();

  /** Of cells of side 1: the occupied ones are blocked, unknown ones are not. */
  private final GridMap walls;

  private OccupancyMap(Part map, GreyImage image, double clearancePixels) {
    width = image.width();
    height = image.height();
    this.clearancePixels = clearancePixels;
    String mode = map.has("mode") ? map.at("mode", "").as(MODE) : "trinary";
    boolean isNegated = List.of("1", "true").contains(map.at("negate", "0 or 1").as(NEGATE));
    double freeBelow = map.at("free_thresh", "a number from 0 to 1").as(SHARE);
    Part occupied = map.at("occupied_thresh", "a number from 0 to 1");
    double occupiedAbove = occupied.as(SHARE);
    if (occupiedAbove < freeBelow) {
      throw occupied.wrong("at least free_thresh, " + freeBelow);
    }
    BitSet blocked = new BitSet();
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        double shade = image.brightness(x, y);
        double opacity = image.opacity(x, y);
        if (mode.equals("trinary") && image.hasAlpha()) {
          shade = (3 * shade + opacity) / 4;
        }
        boolean isSeen = !mode.equals("scale") || opacity == 1;
        double occupancy =
            mode.equals("raw") ? Math.round(shade * 255) / 100.0 : isNegated ? shade : 1 - shade;
        free.set(bit(x, y), isSeen && occupancy < freeBelow);
        blocked.set((height - 1 - y) * width + x, isSeen && occupancy > occupiedAbove);
      }
    }
    walls = new GridMap(width, height, blocked);
  }

  private OccupancyMap(GridMap map, double clearancePixels) {
    width = map.columns();
    height = map.rows();
    this.clearancePixels = clearancePixels;
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        free.set(bit(x, y), map.isFree(x, height - 1 - y));
      }
    }
    walls = map;
  }

  /** A place in each free cell of the map's largest connected part; a cell is as wide as the spacing. */
  static NavGraph read(String file, GridMap map, NavGraphs.Choice choice) {
    if (map.freeCells() > MOST_PLACES) {
      throw new BadInput(
          file + ": " + map.freeCells() + " free cells: expected at most " + MOST_PLACES);
    }
    OccupancyMap cells = new OccupancyMap(map, choice.clearanceMm() / choice.spacingMm());
    NavGraph grid = NavGraphs.largestPart(cells.grid(file, 1, 0, 0));
    return cells.stationed(file, grid, choice, choice.spacingMm(), new Point(0, 0), 0);
  }

  /** The largest connected part of the map's free cells. */
  static NavGraph read(Part map, Path imageFile, NavGraphs.Choice choice) {
    Part resolution = map.at("resolution", "metres per pixel");
    double mmPerPixel = resolution.as(RESOLUTION) * 1000;
    int step = (int) Math.round(choice.spacingMm() / mmPerPixel);
    if (step < 1) {
      throw resolution.wrong("at most the spacing of places, " + choice.spacingMm() / 1000 + " m");
    }
    Part pose = map.at("origin", "[X, Y, YAW]");
    List<Part> origin = pose.items(3, "[X, Y, YAW]");
    if (origin.size() > 3) {
      throw pose.wrong("[X, Y, YAW]");
    }
    Point corner = new Point(origin.get(0).as(METRES) * 1000, origin.get(1).as(METRES) * 1000);
    double yaw = origin.get(2).as(RADIANS);
    OccupancyMap cells =
        new OccupancyMap(map, GreyImage.read(imageFile), choice.clearanceMm() / mmPerPixel);
    NavGraph best = new NavGraph(List.of(), List.of());
    for (int shift = 0; shift < SHIFTS * SHIFTS; shift++) {
      NavGraph grid =
          NavGraphs.largestPart(
              cells.grid(
                  map.file(),
                  step,
                  step * (shift % SHIFTS) / SHIFTS,
                  step * (shift / SHIFTS) / SHIFTS));
      best = grid.vertices().size() > best.vertices().size() ? grid : best;
    }
    return cells.stationed(map.file(), best, choice, mmPerPixel, corner, yaw);
  }

  private NavGraph stationed(
      String file,
      NavGraph grid,
      NavGraphs.Choice choice,
      double mmPerPixel,
      Point corner,
      double yaw) {
    if (grid.vertices().size() < 2) {
      throw new BadInput(
          file
              + ": expected free cells for two places "
              + choice.spacingMm()
              + " mm apart with a clearance of "
              + choice.clearanceMm()
              + " mm, and found none");
    }
    return withStations(placed(grid, mmPerPixel, corner, yaw));
  }

  private int bit(int x, int y) {
    return y * (width + 1) + x + 1;
  }

  /** Places in pixels from the lower left corner of the image. */
  private NavGraph grid(String file, int step, int left, int bottom) {
    int columns = Math.max(0, (width - left + step - 1) / step);
    int rows = Math.max(0, (height - bottom + step - 1) / step);
    int[] numbers = new int[columns * rows];
    Arrays.fill(numbers, -1);
    List<Vertex> places = new ArrayList<>();
    List<Lane> lanes = new ArrayList<>();
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        int x = left + column * step;
        int y = height - 1 - bottom - row * step;
        if (!isClear(x, y)) {
          continue;
        }
        int number = places.size();
        if (number == MOST_PLACES) {
          throw new BadInput(
              file + ": more than " + MOST_PLACES + " places: expected a larger spacing of places");
        }
        numbers[row * columns + column] = number;
        Point at = new Point(x + 0.5, height - y - 0.5);
        places.add(new Vertex(name(column, row), at, false, false, false));
        if (column > 0 && isLane(x, y, -1, 0, step)) {
          join(numbers[row * columns + column - 1], number, lanes);
        }
        if (row > 0 && isLane(x, y, 0, 1, step)) {
          join(numbers[(row - 1) * columns + column], number, lanes);
        }
      }
    }
    return new NavGraph(places, lanes);
  }

  /** The name of a place. */
  static String name(int column, int row) {
    return "x" + column + "y" + row;
  }

  private static void join(int a, int b, List<Lane> lanes) {
    lanes.add(new Lane(a, b, ""));
    lanes.add(new Lane(b, a, ""));
  }

  private boolean isLane(int x, int y, int dx, int dy, int step) {
    for (int i = 1; i <= step; i++) {
      if (!isClear(x + i * dx, y + i * dy)) {
        return false;
      }
    }
    return true;
  }

  /** Whether the pixel's middle is at least the clearance away from each cell that is not free. */
  boolean isClear(int x, int y) {
    if (!free.get(bit(x, y))) {
      return false;
    }
    int reach = (int) Math.ceil(clearancePixels + 0.5);
    for (int row = y - reach; row <= y + reach; row++) {
      double up = Math.max(0, Math.abs(row - y) - 0.5);
      double aside = Math.max(0, besides(x, row) - 0.5);
      if (up * up + aside * aside < clearancePixels * clearancePixels) {
        return false;
      }
    }
    return true;
  }

  /** From column {@code x} to the nearest cell of the row that is not free, in pixels. */
  private int besides(int x, int row) {
    if (row < 0 || row >= height) {
      return 0;
    }
    int bit = bit(x, row);
    return Math.min(bit - free.previousClearBit(bit), free.nextClearBit(bit) - bit);
  }

  private NavGraph placed(NavGraph grid, double mmPerPixel, Point corner, double yaw) {
    double cos = StrictMath.cos(yaw);
    double sin = StrictMath.sin(yaw);
    UnaryOperator<Point> onFloor =
        pixel -> {
          Point from = pixel.times(mmPerPixel);
          return corner.plus(
              new Point(from.xMm() * cos - from.yMm() * sin, from.xMm() * sin + from.yMm() * cos));
        };
    List<Vertex> places = new ArrayList<>();
    for (Vertex v : grid.vertices()) {
      places.add(new Vertex(v.name(), onFloor.apply(v.at()), false, false, false));
    }
    List<Obstacle> boxes = new ArrayList<>();
    for (Obstacle box : walls.walls(1).all()) {
      boxes.add(Obstacle.body(box.points().stream().map(onFloor).toArray(Point[]::new)));
    }
    return new NavGraph(places, grid.lanes(), new Obstacles(boxes));
  }

  private static NavGraph withStations(NavGraph grid) {
    List<List<Integer>> next = new ArrayList<>();
    grid.vertices().forEach(v -> next.add(new ArrayList<>()));
    grid.lanes().forEach(lane -> next.get(lane.from()).add(lane.to()));
    List<Integer> ends = ends(next);
    List<Vertex> places = new ArrayList<>(grid.vertices());
    List<Lane> lanes = new ArrayList<>(grid.lanes());
    for (int i = 0; i < ends.size(); i++) {
      int end = ends.get(i);
      Vertex v = places.get(end);
      boolean isStation = i % 2 == 0;
      places.set(end, new Vertex(v.name(), v.at(), !isStation, isStation, !isStation));
      if (!isStation) {
        // No way leads through a robot that parks.
        int neighbour = next.get(end).get(0);
        lanes.removeIf(lane -> isOther(lane.from(), lane.to(), end, neighbour));
        lanes.removeIf(lane -> isOther(lane.to(), lane.from(), end, neighbour));
      }
    }
    return NavGraphs.withStations(
        new NavGraph(places, lanes, grid.walls()), List.of(Vertex::isStation, v -> true));
  }

  private static boolean isOther(int one, int other, int end, int neighbour) {
    return one == end && other != neighbour;
  }

  /** Places at walls, none beside another, without which the others are connected. */
  private static List<Integer> ends(List<List<Integer>> next) {
    List<Integer> ends = new ArrayList<>();
    BitSet others = new BitSet();
    others.set(0, next.size());
    for (int v = 0; v < next.size(); v++) {
      if (next.get(v).size() < 4 && next.get(v).stream().allMatch(others::get)) {
        others.clear(v);
        if (isConnected(next, others)) {
          ends.add(v);
        } else {
          others.set(v);
        }
      }
    }
    return ends;
  }

  private static boolean isConnected(List<List<Integer>> next, BitSet among) {
    int first = among.nextSetBit(0);
    return first >= 0 && NavGraphs.reached(next, first, among).cardinality() == among.cardinality();
  }
}
