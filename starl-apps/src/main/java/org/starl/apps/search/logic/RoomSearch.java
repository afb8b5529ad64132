package org.starl.apps.search.logic;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.Computation;
import org.starl.GlobalVarHolder;
import org.starl.geometry.Point;

/**
 * The search of one room by one robot: drives the legs of its {@link Sweep}, leaves out those on which
 * nothing new can come into view any more, and computes another sweep for what is left, until its
 * {@link Coverage} is complete. Strand only.
 */
final class RoomSearch {

  /**
   * In a room it claims no longer tubes: what a searcher that dies bars for the others is hardly more
   * than what it has seen.
   */
  private static final double HOP_MM = 350;

  private static final long ON_THE_WAY_MS = 45_000;
  private static final long INSIDE_MS = 6_000;

  /** Where no free way leads, none leads so near either: other places have the same in view. */
  private static final double BARRED_MM = 100;

  /** It begins with what is left until a whole sweep has changed nothing, and never oftener. */
  private static final int MOST_SWEEPS = 12;

  private final GlobalVarHolder gvh;
  private final House house;
  private final Room room;
  private final Drive drive;
  private final Deque<Hop> ahead = new ArrayDeque<>();
  private final Deque<Leg> legs = new ArrayDeque<>();
  private final BitSet before;
  private final Coverage coverage;
  private final BitSet tried = new BitSet();
  private BitSet barred = new BitSet();
  private @Nullable Computation<Sweep> computing;
  private int sweeps;
  private int unseenBefore = Integer.MAX_VALUE;
  private BitSet barredBefore = new BitSet();
  private boolean inside;
  private boolean passing;

  /**
   * One drive.
   *
   * @param passing on the way to a leg, where another way would do as well
   */
  private record Hop(Point to, boolean passing) {}

  /** How a search stands. */
  enum State {
    GOING,
    SWEEPING,
    SWEPT,
    BLOCKED
  }

  /**
   * @param before what somebody has seen of the room
   */
  RoomSearch(GlobalVarHolder gvh, House house, Room room, BitSet before, Drive drive) {
    this.gvh = gvh;
    this.house = house;
    this.room = room;
    this.drive = drive;
    this.before = (BitSet) before.clone();
    BitSet wanted = room.cells();
    wanted.andNot(before);
    coverage = new Coverage(house, wanted);
    drive.stop();
    Point from = room.entry();
    computing = gvh.plat.compute(() -> Sweep.of(house, room, from));
  }

  Room room() {
    return room;
  }

  /** What has been seen of the room, by whomever. */
  BitSet seen() {
    BitSet seen = room.cells();
    seen.andNot(coverage.unseen());
    seen.or(before);
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
    Computation<Sweep> sweep = computing;
    if (sweep != null) {
      if (!sweep.isDone()) {
        return state();
      }
      computing = null;
      begin(sweep.result());
      return next() ? state() : State.BLOCKED;
    }
    switch (drive.look()) {
      case UNDER_WAY -> {
        return state();
      }
      case THERE -> inside = true;
      case BLOCKED -> {
        if (!inside) {
          return State.BLOCKED;
        }
        leaveOut();
        house.grid().forEachWithin(drive.target(), BARRED_MM, tried::set);
        barred = barredNow();
      }
    }
    return next() ? state() : State.BLOCKED;
  }

  private State state() {
    return inside ? State.SWEEPING : State.GOING;
  }

  private void begin(Sweep sweep) {
    sweeps++;
    legs.addAll(sweep.legs());
    if (gvh.trace.isOn()) {
      gvh.trace.action(SearchTrace.SOURCE, SearchTrace.SWEEP, room.name(), sweep.legs());
    }
    if (sweeps == 1) {
      coverage.forget(sweep.hidden()); // of the whole room, nothing being barred
    }
  }

  /** Leaves out what lies behind a place that is barred. */
  private void leaveOut() {
    if (passing) {
      ahead.removeIf(Hop::passing); // there may be a way around
    } else {
      ahead.clear(); // what it misses so comes into the next sweep
    }
  }

  /** Sets out to the next place, if any is worth it; else thinks anew, if that may help. */
  private boolean next() {
    while (ahead.isEmpty() && !legs.isEmpty()) {
      Leg leg = legs.remove();
      if (coverage.isWorthGoing(leg)) {
        if (!isBarred(leg.from())) {
          addLeg(leg);
        } else if (!isBarred(leg.to())) {
          addLeg(leg.reversed());
        }
      }
    }
    if (!ahead.isEmpty()) {
      Hop hop = ahead.remove();
      passing = hop.passing();
      drive.to(hop.to(), inside ? INSIDE_MS : ON_THE_WAY_MS);
      return true;
    }
    BitSet rest = coverage.unseen();
    barred = barredNow();
    boolean isOfUse = rest.cardinality() != unseenBefore || !barred.equals(barredBefore);
    if (sweeps >= MOST_SWEEPS || !isOfUse) {
      return coverage.isComplete();
    }
    unseenBefore = rest.cardinality();
    barredBefore = barred;
    BitSet without = (BitSet) barred.clone();
    Point here = gvh.gps.pose().at();
    computing = gvh.plat.compute(() -> Sweep.ofRest(house, room, rest, without, here));
    return true;
  }

  /** Where others are in the way now, and where no way was found before. */
  private BitSet barredNow() {
    BitSet now = drive.barred(house);
    now.or(tried);
    return now;
  }

  private boolean isBarred(Point at) {
    return barred.get(house.grid().cellAt(at));
  }

  private void addLeg(Leg leg) {
    if (inside) {
      Leg way = new Leg(gvh.gps.pose().at(), leg.from());
      if (room.hasPlacesAlong(way, house.grid())) {
        for (Point at : hops(way)) {
          ahead.add(new Hop(house.grid().centre(house.grid().cellAt(at)), true));
        }
        ahead.pollLast();
      }
    }
    ahead.add(new Hop(leg.from(), false));
    hops(leg).forEach(at -> ahead.add(new Hop(at, false)));
  }

  /** Places on a leg, the last one at its end; none if it has no length. */
  private static List<Point> hops(Leg leg) {
    List<Point> hops = new ArrayList<>();
    int count = (int) StrictMath.ceil(leg.lengthMm() / HOP_MM);
    for (int i = 1; i <= count; i++) {
      hops.add(leg.at((double) i / count));
    }
    return hops;
  }
}
