package org.starl.apps.search.logic;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.Computation;
import org.starl.GlobalVarHolder;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;
import org.starl.trace.Instance;

/**
 * The search of one room by one robot: drives the legs of a {@link Sweep}, skips those on which
 * nothing new can come into view, and computes another sweep for the rest, until its {@link
 * Coverage} is complete. Strand only.
 */
final class RoomSearch {

  /**
   * In a room it claims no longer tubes: what a searcher that dies bars for the others is hardly
   * more than what it has seen.
   */
  private static final double HOP_MM = 350;

  private static final long ON_THE_WAY_MS = 45_000;
  private static final long INSIDE_MS = 6_000;

  /** Where no free way leads, none leads so near either: other places see the same. */
  private static final double BARRED_MM = 100;

  /** It sweeps the rest until a whole sweep has changed nothing, and never more often than this. */
  private static final int MAX_SWEEPS = 12;

  private final GlobalVarHolder gvh;
  private final House house;
  private final Room room;
  private final Drive drive;
  private final Deque<Hop> ahead = new ArrayDeque<>();
  private final Deque<Segment> legs = new ArrayDeque<>();
  private final Coverage coverage;

  /** Places around those to which no way was found. */
  private final BitSet tried = new BitSet();

  private BitSet barred = new BitSet();
  private @Nullable Computation<Sweep> computing;
  private int sweeps;
  private int unseenBefore = Integer.MAX_VALUE;
  private BitSet barredBefore = new BitSet();
  private boolean isInside;
  private boolean isPassing;

  /**
   * One drive.
   *
   * @param isPassing on the way to a leg, where another way would do as well
   */
  private record Hop(Point to, boolean isPassing) {}

  /** The state of a search. */
  enum State {
    GOING,
    SWEEPING,
    SWEPT,
    BLOCKED
  }

  /**
   * @param before what other robots have seen of the room
   */
  RoomSearch(GlobalVarHolder gvh, House house, Room room, BitSet before, Drive drive) {
    this.gvh = gvh;
    this.house = house;
    this.room = room;
    this.drive = drive;
    BitSet wanted = (BitSet) room.cells().clone();
    wanted.andNot(before);
    coverage = new Coverage(house, wanted);
    drive.stop();
    computing = gvh.plat.compute(() -> Sweep.of(house, room, room.entry()));
  }

  Room room() {
    return room;
  }

  /** What this robot and others have seen of the room. */
  BitSet seen() {
    BitSet seen = (BitSet) room.cells().clone();
    seen.andNot(coverage.unseen());
    return seen;
  }

  /** The sensor was read just now. */
  void look() {
    if (gvh.gps.hasFix()) {
      coverage.look(gvh.gps.pose().at(), gvh.gps.errorMm());
    }
  }

  /** One step; to be called every period. */
  State step() {
    if (coverage.isComplete()) {
      drive.stop();
      return State.SWEPT;
    }
    if (computing != null) {
      if (!computing.isDone()) {
        return state();
      }
      begin(computing.result());
      computing = null;
      return next();
    }
    switch (drive.check()) {
      case UNDER_WAY -> {
        return state();
      }
      case ARRIVED -> isInside = true;
      case BLOCKED -> {
        if (!isInside) {
          return State.BLOCKED;
        }
        skipBlocked();
        house.grid().within(drive.target(), BARRED_MM).forEach(tried::set);
        barred = barredNow();
      }
    }
    return next();
  }

  private State state() {
    return isInside ? State.SWEEPING : State.GOING;
  }

  private void begin(Sweep sweep) {
    sweeps++;
    legs.addAll(sweep.legs());
    if (gvh.trace.isOn()) {
      List<SearchFact.Leg> planned =
          sweep.legs().stream().map(SearchFact.Leg::of).collect(Collectors.toList());
      gvh.trace.action(
          Instance.APP, SearchFact.SHAPE, new SearchFact.Planned(room.name(), planned));
    }
    if (sweeps == 1) {
      coverage.forget(sweep.hidden()); // this sweep may use all places of the room
    }
  }

  /** Leaves out what lies behind a place that is barred. */
  private void skipBlocked() {
    if (isPassing) {
      ahead.removeIf(Hop::isPassing); // there may be a way around
    } else {
      ahead.clear(); // the next sweep has what this one misses
    }
  }

  /**
   * Sets out for the next place that may show anything; else computes a sweep, if that may help.
   */
  private State next() {
    while (ahead.isEmpty() && !legs.isEmpty()) {
      Segment leg = legs.remove();
      if (coverage.isWorthDriving(leg)) {
        if (!isBarred(leg.from())) {
          addLeg(leg);
        } else if (!isBarred(leg.to())) {
          addLeg(Sweep.reversed(leg));
        }
      }
    }
    if (!ahead.isEmpty()) {
      Hop hop = ahead.remove();
      isPassing = hop.isPassing();
      drive.to(hop.to(), isInside ? INSIDE_MS : ON_THE_WAY_MS);
      return state();
    }
    BitSet rest = coverage.unseen();
    barred = barredNow();
    boolean isOfUse = rest.cardinality() != unseenBefore || !barred.equals(barredBefore);
    if (sweeps >= MAX_SWEEPS || !isOfUse) {
      return coverage.isComplete() ? state() : State.BLOCKED;
    }
    unseenBefore = rest.cardinality();
    barredBefore = barred;
    BitSet places = (BitSet) room.places().clone();
    places.andNot(barred);
    Point here = gvh.gps.pose().at();
    computing = gvh.plat.compute(() -> Sweep.ofRest(house, rest, places, here));
    return state();
  }

  /** Places where others are in the way now, and around which no way was found before. */
  private BitSet barredNow() {
    BitSet now = drive.barred(house);
    now.or(tried);
    return now;
  }

  private boolean isBarred(Point at) {
    return barred.get(house.grid().cellAt(at));
  }

  private void addLeg(Segment leg) {
    Segment way = new Segment(gvh.gps.pose().at(), leg.from());
    if (isInside && leadsOverPlaces(way)) {
      for (Point at : hops(way)) {
        ahead.add(new Hop(house.grid().centre(house.grid().cellAt(at)), true));
      }
      ahead.pollLast();
    }
    ahead.add(new Hop(leg.from(), false));
    hops(leg).forEach(at -> ahead.add(new Hop(at, false)));
  }

  private boolean leadsOverPlaces(Segment way) {
    int steps = 1 + (int) (2 * Sweep.lengthMm(way) / House.CELL_MM);
    for (int i = 0; i <= steps; i++) {
      int cell = house.grid().cellAt(Sweep.pointOn(way, i, steps));
      if (cell < 0 || !room.places().get(cell)) {
        return false;
      }
    }
    return true;
  }

  /** Places on a leg, the last one at its end; none if it has no length. */
  private static List<Point> hops(Segment leg) {
    List<Point> hops = new ArrayList<>();
    int count = (int) StrictMath.ceil(Sweep.lengthMm(leg) / HOP_MM);
    for (int i = 1; i <= count; i++) {
      hops.add(Sweep.pointOn(leg, i, count));
    }
    return hops;
  }
}
