package org.starl.apps.search.logic;

import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Deque;
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

  /** Action: a sweep's legs, for whoever draws them. */
  static final String SWEEP = "sweep";

  /**
   * In a room it claims no longer tubes: what a searcher that dies bars for the others is hardly more
   * than what it has seen.
   */
  private static final double HOP_MM = 350;

  private static final long ON_THE_WAY_MS = 45_000;
  private static final long INSIDE_MS = 6_000;

  /** It begins with what is left until a whole sweep has shown nothing new, and never oftener. */
  private static final int MOST_SWEEPS = 8;

  private final GlobalVarHolder gvh;
  private final House house;
  private final Room room;
  private final Drive drive;
  private final Deque<Point> ahead = new ArrayDeque<>();
  private final Deque<Leg> legs = new ArrayDeque<>();
  private final BitSet before;
  private final Coverage coverage;
  private @Nullable Computation<Sweep> computing;
  private int sweeps;
  private int unseenBefore = Integer.MAX_VALUE;
  private boolean inside;

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
    coverage.look(gvh.gps.pose().at(), gvh.gps.errorMm());
  }

  /** One step; to be called every period. */
  State step() {
    if (coverage.isComplete()) {
      drive.stop();
      return State.SWEPT;
    }
    Computation<Sweep> sweep = computing;
    if (sweep != null) {
      if (sweep.isDone()) {
        computing = null;
        begin(sweep.result());
      }
      return state();
    }
    switch (drive.look()) {
      case UNDER_WAY -> {
        return state();
      }
      case THERE -> inside = true;
      case BLOCKED -> {
        ahead.clear(); // what it misses so comes into the next sweep
        if (!inside) {
          return State.BLOCKED;
        }
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
      gvh.trace.action(SearchApp.SOURCE, SWEEP, room.name(), sweep.legs());
    }
    coverage.forget(sweep.hidden());
    next();
  }

  /** Sets out to the next place, if any is worth it; else thinks anew. */
  private boolean next() {
    while (ahead.isEmpty() && !legs.isEmpty()) {
      Leg leg = legs.remove();
      if (coverage.isWorthGoing(leg)) {
        ahead.add(leg.from());
        addHops(leg);
      }
    }
    if (!ahead.isEmpty()) {
      drive.to(ahead.remove(), inside ? INSIDE_MS : ON_THE_WAY_MS);
      return true;
    }
    BitSet rest = coverage.unseen();
    if (sweeps >= MOST_SWEEPS || rest.cardinality() == unseenBefore) {
      return coverage.isComplete();
    }
    unseenBefore = rest.cardinality();
    Point here = gvh.gps.pose().at();
    computing = gvh.plat.compute(() -> Sweep.ofRest(house, room, rest, here));
    return true;
  }

  private void addHops(Leg leg) {
    int hops = (int) StrictMath.ceil(leg.from().distanceMm(leg.to()) / HOP_MM);
    for (int i = 1; i <= hops; i++) {
      ahead.add(leg.from().plus(leg.to().minus(leg.from()).times((double) i / hops)));
    }
  }
}
