package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/**
 * A plan to search a room: legs to drive, in order, from which all of the room comes into view.
 * Lanes run along the room's longer side, from wall to wall, so far apart that a robot on one sees
 * half way to the next (boustrophedon sweep; Choset, Pignon, "Coverage path planning: the
 * boustrophedon cellular decomposition", FSR 1997). What walls hide from the lanes gets stops of
 * its own: each time the place that sees most of the rest. The legs are then ordered, the nearest
 * end first. Immutable: nothing may change the set of cells.
 *
 * @param legs in order; a stop is a leg with equal ends
 * @param hidden cells that no robot can see whole from any of the places that it may use
 */
public record Sweep(List<Segment> legs, BitSet hidden) {

  /** Half the distance between two lanes, as a part of how far a robot sees to the side. */
  private static final double LANE = 0.85;

  /** Rows shorter than this part of the longest row, as in a doorway, get no lane. */
  private static final double SMALL = 0.2;

  /** Candidates for stops: first on a coarse grid of so many cells, then all places. */
  private static final int COARSE_CELLS = 3;

  public Sweep {
    legs = List.copyOf(legs);
  }

  /** The sweep of a whole room, for a robot that comes from {@code from}. */
  public static Sweep of(House house, Room room, Point from) {
    List<Segment> lanes = lanes(house, room);
    BitSet rest = (BitSet) room.cells().clone();
    for (Segment lane : lanes) {
      int steps = (int) StrictMath.ceil(lengthMm(lane) / (2 * House.CELL_MM));
      for (int i = 0; i <= steps; i++) {
        rest.andNot(house.view(pointOn(lane, i, steps), House.SLACK_MM, rest));
      }
    }
    return withStops(house, lanes, rest, room.places(), from);
  }

  /** The sweep of some cells of a room, by stops at some of its places alone. */
  static Sweep ofRest(House house, BitSet rest, BitSet places, Point from) {
    return withStops(house, List.of(), rest, places, from);
  }

  /** The point after {@code i} of {@code steps} equal parts of a leg. */
  static Point pointOn(Segment leg, int i, int steps) {
    double part = steps == 0 ? 0 : (double) i / steps;
    return leg.from().plus(leg.to().minus(leg.from()).times(part));
  }

  static double lengthMm(Segment leg) {
    return leg.from().distanceMm(leg.to());
  }

  static Segment reversed(Segment leg) {
    return new Segment(leg.to(), leg.from());
  }

  private static Sweep withStops(
      House house, List<Segment> lanes, BitSet rest, BitSet places, Point from) {
    BitSet unseen = (BitSet) rest.clone();
    List<Segment> legs = new ArrayList<>(lanes);
    addStops(house, unseen, places, COARSE_CELLS, legs);
    addStops(house, unseen, places, 1, legs);
    return new Sweep(inOrder(legs, from), unseen);
  }

  private static List<Segment> lanes(House house, Room room) {
    Grid grid = house.grid();
    int[] perColumn = new int[grid.columns()];
    int[] perRow = new int[grid.rows()];
    room.places().stream()
        .forEach(cell -> {
          perColumn[cell % grid.columns()]++;
          perRow[cell / grid.columns()]++;
        });
    List<Integer> columns = longLines(perColumn);
    List<Integer> rows = longLines(perRow);
    List<Segment> lanes = new ArrayList<>();
    if (columns.isEmpty()) {
      return lanes;
    }
    boolean isAlongX = last(columns) - columns.get(0) >= last(rows) - rows.get(0);
    List<Integer> across = isAlongX ? rows : columns;
    int first = across.get(0);
    int width = last(across) - first;
    double viewMm = house.rangeMm() - House.SLACK_MM - House.CELL_MM;
    double spacing = Math.max(1, 2 * LANE * viewMm / House.CELL_MM);
    int gaps = (int) StrictMath.ceil(width / spacing);
    for (int i = 0; i <= gaps; i++) {
      int line = gaps == 0 ? first : first + (int) Math.round((double) width * i / gaps);
      addLanes(grid, room.places(), line, isAlongX, lanes);
    }
    return lanes;
  }

  /** Rows or columns whose number of places is not small beside the greatest. */
  private static List<Integer> longLines(int[] counts) {
    int most = IntStream.of(counts).max().orElse(0);
    List<Integer> lines = new ArrayList<>();
    for (int i = 0; i < counts.length; i++) {
      if (counts[i] > 0 && counts[i] >= SMALL * most) {
        lines.add(i);
      }
    }
    return lines;
  }

  private static int last(List<Integer> lines) {
    return lines.get(lines.size() - 1);
  }

  /** Adds the parts of a row or column over which a robot may drive. */
  private static void addLanes(
      Grid grid, BitSet places, int line, boolean isAlongX, List<Segment> lanes) {
    int length = isAlongX ? grid.columns() : grid.rows();
    int first = -1;
    int before = -1;
    for (int i = 0; i <= length; i++) {
      int cell = isAlongX ? grid.cell(i, line) : grid.cell(line, i);
      boolean isPlace = i < length && places.get(cell);
      if (isPlace && first < 0) {
        first = cell;
      } else if (!isPlace && first >= 0) {
        lanes.add(new Segment(grid.centre(first), grid.centre(before)));
        first = -1;
      }
      before = cell;
    }
  }

  /**
   * Adds stops, each at the place that sees most of {@code unseen}, and takes out what they see.
   */
  private static void addStops(
      House house, BitSet unseen, BitSet places, int spacing, List<Segment> legs) {
    Grid grid = house.grid();
    List<Point> stops = new ArrayList<>();
    List<BitSet> views = new ArrayList<>();
    for (int place = places.nextSetBit(0);
        place >= 0 && !unseen.isEmpty();
        place = places.nextSetBit(place + 1)) {
      if (place % grid.columns() % spacing == 0 && place / grid.columns() % spacing == 0) {
        BitSet view = house.view(grid.centre(place), House.SLACK_MM, unseen);
        if (!view.isEmpty()) {
          stops.add(grid.centre(place));
          views.add(view);
        }
      }
    }
    while (!views.isEmpty()) {
      int[] sizes = views.stream().mapToInt(BitSet::cardinality).toArray();
      int most = IntStream.of(sizes).max().orElse(0);
      if (most == 0) {
        return;
      }
      int best = 0;
      while (sizes[best] < most) {
        best++;
      }
      legs.add(new Segment(stops.get(best), stops.get(best)));
      BitSet seen = (BitSet) views.get(best).clone();
      unseen.andNot(seen);
      views.forEach(view -> view.andNot(seen));
    }
  }

  private static List<Segment> inOrder(List<Segment> legs, Point from) {
    List<Segment> left = new ArrayList<>(legs);
    List<Segment> order = new ArrayList<>();
    Point at = from;
    while (!left.isEmpty()) {
      Point here = at;
      Segment next =
          left.stream()
              .min(
                  Comparator.comparingDouble(
                      leg -> Math.min(leg.from().distanceMm(here), leg.to().distanceMm(here))))
              .orElseThrow();
      left.remove(next);
      boolean isReversed = next.to().distanceMm(here) < next.from().distanceMm(here);
      order.add(isReversed ? reversed(next) : next);
      at = order.get(order.size() - 1).to();
    }
    return order;
  }
}
