package org.starl.apps.search.logic;

import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Deque;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.Computation;
import org.starl.GlobalVarHolder;
import org.starl.geometry.Point;

/**
 * The search of one room by one robot: drives to the stops of a {@link Sweep}, skips those that show
 * nothing new, and plans another sweep for the rest, until it has seen the whole room. Strand only.
 */
final class RoomSearch {

  /** In a room it claims no longer tubes: a robot that crashes bars hardly more than it has seen. */
  private static final double HOP_MM = 350;

  private static final long ON_THE_WAY_MS = 45_000;
  private static final long INSIDE_MS = 6_000;

  /** Where no free way leads, none leads so near either: other places see the same. */
  private static final double BARRED_MM = 100;

  /** A robot that moved less sees hardly anything new. */
  private static final double STEP_MM = 20;

  private final GlobalVarHolder gvh;
  private final House house;
  private final Room room;
  private final Drive drive;
  private final BitSet unseen;
  private final Deque<Point> stops = new ArrayDeque<>();

  /** Places from which it has looked, or to which it has found no way. */
  private final BitSet tried = new BitSet();

  private @Nullable Computation<Sweep> planning;
  private Point lookedFrom = new Point(Double.NEGATIVE_INFINITY, 0);
  private double lookedErrorMm;
  private boolean isFirstSweep = true;
  private boolean isInside;

  /** The state of a search. */
  enum State {
    GOING,
    SWEEPING,
    SWEPT,
    BLOCKED
  }

  /**
   * @param seen the cells of the room that robots have seen before
   */
  RoomSearch(GlobalVarHolder gvh, House house, Room room, BitSet seen, Drive drive) {
    this.gvh = gvh;
    this.house = house;
    this.room = room;
    this.drive = drive;
    unseen = (BitSet) room.cells().clone();
    unseen.andNot(seen);
    drive.stop();
    plan(room.places(), room.entry());
  }

  Room room() {
    return room;
  }

  /** The cells of the room that this robot and others have seen. */
  BitSet seen() {
    BitSet seen = (BitSet) room.cells().clone();
    seen.andNot(unseen);
    return seen;
  }

  /** Notes which cells the sensor, just read, has in view. */
  void look() {
    if (gvh.gps.hasFix()) {
      Point at = gvh.gps.pose().at();
      double errorMm = gvh.gps.errorMm();
      if (at.distanceMm(lookedFrom) >= STEP_MM || errorMm < lookedErrorMm) {
        lookedFrom = at;
        lookedErrorMm = errorMm;
        unseen.andNot(house.view(at, errorMm, unseen));
      }
    }
  }

  /** One step; to be called every period. */
  State step() {
    if (unseen.isEmpty()) {
      drive.stop();
      return State.SWEPT;
    }
    if (planning != null) {
      if (!planning.isDone()) {
        return state();
      }
      Sweep sweep = planning.result();
      planning = null;
      begin(sweep);
      return sweep.stops().isEmpty() && !unseen.isEmpty() ? State.BLOCKED : next();
    }
    switch (drive.check()) {
      case UNDER_WAY -> {
        return state();
      }
      case ARRIVED -> {
        isInside = true;
        tried.set(house.grid().cellAt(drive.target()));
      }
      case BLOCKED -> {
        if (!isInside) {
          return State.BLOCKED;
        }
        house.grid().within(drive.target(), BARRED_MM).forEach(tried::set);
        stops.clear();
      }
    }
    return next();
  }

  private State state() {
    return isInside ? State.SWEEPING : State.GOING;
  }

  private void plan(BitSet places, Point from) {
    BitSet cells = (BitSet) unseen.clone();
    planning = gvh.plat.compute(() -> Sweep.of(house, cells, places, from));
  }

  private void begin(Sweep sweep) {
    stops.addAll(sweep.stops());
    if (gvh.trace.isOn()) {
      gvh.trace.action(
          SearchTrace.SOURCE,
          SearchTrace.SWEEP,
          room.name(),
          sweep.stops().stream().map(SearchTrace::text).collect(Collectors.toList()));
    }
    if (isFirstSweep) {
      unseen.andNot(sweep.hidden()); // this sweep may use all places of the room
      isFirstSweep = false;
    }
  }

  /** Sets out for the next stop that shows anything new; else plans a sweep of the rest. */
  private State next() {
    stops.removeIf(stop ->
        tried.get(house.grid().cellAt(stop)) || house.view(stop, House.SLACK_MM, unseen).isEmpty());
    if (stops.isEmpty()) {
      BitSet places = drive.reachable(house);
      places.and(room.places());
      places.andNot(tried);
      plan(places, gvh.gps.pose().at());
    } else if (isInside) {
      drive.to(hop(stops.element()), INSIDE_MS);
    } else {
      drive.to(stops.element(), ON_THE_WAY_MS);
    }
    return state();
  }

  /** The next place on the straight line to a stop; the stop itself if that line is barred. */
  private Point hop(Point stop) {
    Grid grid = house.grid();
    Point from = gvh.gps.pose().at();
    Point way = stop.minus(from);
    double lengthMm = from.distanceMm(stop);
    for (double mm = House.CELL_MM; mm < lengthMm; mm += House.CELL_MM) {
      int cell = grid.cellAt(from.plus(way.times(mm / lengthMm)));
      if (cell < 0 || !room.places().get(cell)) {
        return stop;
      }
    }
    double hops = StrictMath.ceil(lengthMm / HOP_MM);
    int cell = grid.cellAt(from.plus(way.times(1 / Math.max(1, hops))));
    return hops <= 1 || tried.get(cell) ? stop : grid.centre(cell);
  }
}
