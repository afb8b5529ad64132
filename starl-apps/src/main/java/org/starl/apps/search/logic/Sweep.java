package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.geometry.Point;

/**
 * A plan to search a room: stops to drive to, in order, from which all of the room comes into view.
 * Each next stop is the place that shows the most new cells for the way to it (next-best-view
 * planning; Gonzalez-Banos, Latombe, "Navigation strategies for exploring indoor environments",
 * IJRR 21(10-11), 2002). A cell counts the more the fewer places show it: else the corners of the
 * room would be left over, each for a drive of its own. Immutable: nothing may change the set of
 * cells.
 *
 * @param hidden cells that no robot can see whole from any of the places that it may use
 */
public record Sweep(List<Point> stops, BitSet hidden) {

  /**
   * Candidates for stops are places on a coarse grid, and other places only for cells that none of
   * these shows.
   */
  private static final int COARSE_CELLS = 3;

  /** The way for which a robot needs as much time as for one stop. */
  private static final double STOP_MM = 500;

  /** On the way to a stop, cells come into view at steps of this length. */
  private static final double STEP_MM = 100;

  public Sweep {
    stops = List.copyOf(stops);
  }

  /**
   * Plans a sweep.
   *
   * @param cells to be seen
   * @param places where the robot may stand
   * @param from where it comes from
   */
  public static Sweep of(House house, BitSet cells, BitSet places, Point from) {
    Map<Point, BitSet> views = new LinkedHashMap<>();
    BitSet hidden = (BitSet) cells.clone();
    addViews(house, places, COARSE_CELLS, hidden, views);
    addViews(house, places, 1, hidden, views);
    int[] shown = new int[house.grid().count()];
    views.values().forEach(view -> view.stream().forEach(cell -> shown[cell]++));
    List<Point> stops = new ArrayList<>();
    Point here = from;
    while (!views.isEmpty()) {
      Point last = here;
      Map.Entry<Point, BitSet> next =
          views.entrySet().stream()
              .max(
                  Comparator.comparingDouble(view ->
                      worth(view.getValue(), shown) / (STOP_MM + view.getKey().distanceMm(last))))
              .orElseThrow();
      here = next.getKey();
      stops.add(here);
      BitSet seen = (BitSet) next.getValue().clone();
      addSeenOnWay(house, cells, places, last, here, seen);
      views
          .values()
          .removeIf(view -> {
            view.andNot(seen);
            return view.isEmpty();
          });
    }
    return new Sweep(stops, hidden);
  }

  /** Adds what places show of some cells, and takes from the cells what one of them shows. */
  private static void addViews(
      House house, BitSet places, int spacing, BitSet cells, Map<Point, BitSet> views) {
    int columns = house.grid().columns();
    BitSet shown = new BitSet();
    places.stream()
        .filter(cell -> cell % columns % spacing == 0 && cell / columns % spacing == 0)
        .mapToObj(house.grid()::centre)
        .forEach(at -> {
          BitSet view = house.view(at, House.SLACK_MM, cells);
          shown.or(view);
          if (!view.isEmpty()) {
            views.put(at, view);
          }
        });
    cells.andNot(shown);
  }

  private static double worth(BitSet view, int[] shown) {
    return view.stream().mapToDouble(cell -> 1.0 / shown[cell]).sum();
  }

  private static void addSeenOnWay(
      House house, BitSet cells, BitSet places, Point from, Point to, BitSet seen) {
    double lengthMm = from.distanceMm(to);
    for (double mm = STEP_MM; mm < lengthMm; mm += STEP_MM) {
      Point at = from.plus(to.minus(from).times(mm / lengthMm));
      int cell = house.grid().cellAt(at);
      if (cell >= 0 && places.get(cell)) {
        seen.or(house.view(at, House.SLACK_MM, cells));
      }
    }
  }
}
