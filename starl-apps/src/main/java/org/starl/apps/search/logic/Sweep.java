package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.starl.geometry.Point;

/**
 * How to search a room: legs to drive, in order, from which all of it comes into view. Lanes are laid
 * along the room's longer side, from wall to wall, so far apart that a robot on one sees half way to
 * the next (boustrophedon
 * sweep; Choset, Pignon, "Coverage path planning: the boustrophedon cellular decomposition", FSR
 * 1997); what walls still hide gets stops of its own, most first. Then all are put in order: each time
 * the nearest end comes next.
 *
 * <p>Everything is computed from the room's cells and the sensor's range. What lies in no place's
 * view is in {@link #hidden}. Immutable.
 *
 * @param legs in order
 * @param hidden cells that no robot can see whole from any of the room's places
 */
public record Sweep(List<Leg> legs, BitSet hidden) {

  /** Half the distance of two lanes, as a part of what a robot can see to the side. */
  private static final double LANE = 0.85;

  /** Beside the longest row of a room, shorter ones get no lanes of their own. */
  private static final double SMALL = 0.2;

  /** Coarser, places are looked at first. */
  private static final int COARSE_CELLS = 3;

  public Sweep {
    legs = List.copyOf(legs);
    hidden = (BitSet) hidden.clone();
  }

  @Override
  public BitSet hidden() {
    return (BitSet) hidden.clone();
  }

  /** The sweep of a whole room, for a robot that comes from {@code from}. */
  public static Sweep of(House house, Room room, Point from) {
    Maker maker = new Maker(house, room);
    List<Leg> lanes = maker.lanes();
    BitSet rest = room.cells();
    lanes.forEach(lane -> maker.see(lane, rest));
    return maker.sweep(lanes, rest, from);
  }

  /**
   * The sweep of what is left of a room.
   *
   * @param barred places that are not to be used; what only they have in view is {@link #hidden}
   */
  static Sweep ofRest(House house, Room room, BitSet rest, BitSet barred, Point from) {
    Maker maker = new Maker(house, room);
    maker.places.andNot(barred);
    return maker.sweep(List.of(), rest, from);
  }

  private static final class Maker {
    private final House house;
    private final Grid grid;
    private final BitSet places;

    Maker(House house, Room room) {
      this.house = house;
      grid = house.grid();
      places = room.places();
    }

    /** Adds stops for the cells of {@code rest}, and puts all in order. */
    Sweep sweep(List<Leg> lanes, BitSet rest, Point from) {
      BitSet unseen = (BitSet) rest.clone();
      List<Leg> legs = new ArrayList<>(lanes);
      addStops(unseen, COARSE_CELLS, legs);
      addStops(unseen, 1, legs);
      return new Sweep(inOrder(legs, from), unseen);
    }

    List<Leg> lanes() {
      int[] columns = new int[grid.columns()];
      int[] rows = new int[grid.rows()];
      for (int cell = places.nextSetBit(0); cell >= 0; cell = places.nextSetBit(cell + 1)) {
        columns[cell % grid.columns()]++;
        rows[cell / grid.columns()]++;
      }
      List<Leg> lanes = new ArrayList<>();
      if (places.isEmpty()) {
        return lanes;
      }
      int[] width = bulk(columns);
      int[] height = bulk(rows);
      boolean alongX = width[1] - width[0] >= height[1] - height[0];
      int[] across = alongX ? height : width;
      for (int lane : spread(across[0], across[1])) {
        addLanes(lane, alongX, lanes);
      }
      return lanes;
    }

    /** The first and the last one that is not small beside the greatest, as a doorway's are. */
    private static int[] bulk(int[] counts) {
      double least = SMALL * Arrays.stream(counts).max().orElse(0);
      int from = 0;
      while (counts[from] < least) {
        from++;
      }
      int to = counts.length - 1;
      while (counts[to] < least) {
        to--;
      }
      return new int[] {from, to};
    }

    /** Rows, or columns, for lanes, the first and the last one right at the walls. */
    private List<Integer> spread(int from, int to) {
      double sideMm = house.rangeMm() - House.SLACK_MM - House.CELL_MM;
      double spacing = Math.max(1, 2 * LANE * sideMm / House.CELL_MM);
      int gaps = (int) StrictMath.ceil((to - from) / spacing);
      List<Integer> lanes = new ArrayList<>();
      for (int i = 0; i <= gaps; i++) {
        lanes.add(gaps == 0 ? from : from + (int) Math.round((double) (to - from) * i / gaps));
      }
      return lanes;
    }

    private void addLanes(int across, boolean alongX, List<Leg> lanes) {
      int length = alongX ? grid.columns() : grid.rows();
      int first = -1;
      for (int i = 0; i <= length; i++) {
        boolean isPlace = i < length && places.get(at(i, across, alongX));
        if (isPlace && first < 0) {
          first = i;
        } else if (!isPlace && first >= 0) {
          lanes.add(
              new Leg(
                  grid.centre(at(first, across, alongX)), grid.centre(at(i - 1, across, alongX))));
          first = -1;
        }
      }
    }

    private int at(int along, int across, boolean alongX) {
      return alongX ? grid.cell(along, across) : grid.cell(across, along);
    }

    /** Takes out of {@code rest} what comes into view on a leg. */
    void see(Leg leg, BitSet rest) {
      int steps = (int) StrictMath.ceil(leg.lengthMm() / (2 * House.CELL_MM));
      for (int i = 0; i <= steps; i++) {
        rest.andNot(view(leg.at(steps == 0 ? 0 : (double) i / steps), rest));
      }
    }

    private BitSet view(Point at, BitSet among) {
      BitSet view = new BitSet();
      grid.forEachWithin(
          at,
          house.rangeMm(),
          cell -> {
            if (among.get(cell) && house.covers(at, House.SLACK_MM, cell)) {
              view.set(cell);
            }
          });
      return view;
    }

    private void addStops(BitSet unseen, int spacing, List<Leg> legs) {
      if (unseen.isEmpty()) {
        return;
      }
      List<Integer> stops = new ArrayList<>();
      List<BitSet> views = new ArrayList<>();
      for (int place = places.nextSetBit(0); place >= 0; place = places.nextSetBit(place + 1)) {
        boolean isNext =
            place % grid.columns() % spacing == 0 && place / grid.columns() % spacing == 0;
        BitSet view = isNext ? view(grid.centre(place), unseen) : new BitSet();
        if (!view.isEmpty()) {
          stops.add(place);
          views.add(view);
        }
      }
      int best = largest(views);
      while (best >= 0) {
        Point at = grid.centre(stops.get(best));
        legs.add(new Leg(at, at));
        BitSet seen = (BitSet) views.get(best).clone();
        unseen.andNot(seen);
        views.forEach(view -> view.andNot(seen));
        best = largest(views);
      }
    }

    /** The first one of the greatest; -1 if all are empty. */
    private static int largest(List<BitSet> views) {
      int best = -1;
      int most = 0;
      for (int i = 0; i < views.size(); i++) {
        int size = views.get(i).cardinality();
        if (size > most) {
          most = size;
          best = i;
        }
      }
      return best;
    }

    private static List<Leg> inOrder(List<Leg> legs, Point from) {
      List<Leg> left = new ArrayList<>(legs);
      List<Leg> order = new ArrayList<>();
      Point at = from;
      while (!left.isEmpty()) {
        int best = 0;
        double bestMm = Double.POSITIVE_INFINITY;
        boolean isReversed = false;
        for (int i = 0; i < left.size(); i++) {
          double toFromMm = left.get(i).from().distanceMm(at);
          double toToMm = left.get(i).to().distanceMm(at);
          if (Math.min(toFromMm, toToMm) < bestMm) {
            best = i;
            bestMm = Math.min(toFromMm, toToMm);
            isReversed = toToMm < toFromMm;
          }
        }
        Leg next = left.remove(best);
        order.add(isReversed ? next.reversed() : next);
        at = order.get(order.size() - 1).to();
      }
      return order;
    }
  }
}
