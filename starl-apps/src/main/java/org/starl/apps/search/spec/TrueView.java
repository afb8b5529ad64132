package org.starl.apps.search.spec;

import static org.starl.time.Time.NS_PER_MS;

import java.util.BitSet;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.search.logic.Grid;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.Room;
import org.starl.apps.search.logic.Sight;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.spec.Bodies;
import org.starl.spec.FaultState;
import org.starl.trace.TraceEvent;

/**
 * The cells that were truly seen: those of a room whose centre was in range and sight of a robot's
 * true position while its program ran. Samples every 50 ms of movement. For monitors and pictures.
 */
public final class TrueView {

  private static final long STEP_NS = 50 * NS_PER_MS;
  private static final double STEP_MM = 5;

  private final House house;
  private final Bodies bodies;
  private final FaultState faults;
  private final SortedMap<RobotId, Point> lookedFrom = new TreeMap<>();
  private final BitSet unseen = new BitSet();
  private long nextNs;

  public TrueView(House house) {
    this(house, new Bodies(), new FaultState());
    house.rooms().forEach(room -> unseen.or(room.cells()));
  }

  private TrueView(House house, Bodies bodies, FaultState faults) {
    this.house = house;
    this.bodies = bodies;
    this.faults = faults;
  }

  /** The state at this moment; the copy and this one change apart from now on. */
  public TrueView copy() {
    TrueView copy = new TrueView(house, bodies.copy(), faults.copy());
    copy.lookedFrom.putAll(lookedFrom);
    copy.unseen.or(unseen);
    copy.nextNs = nextNs;
    return copy;
  }

  /** Sees the next event. */
  public void observe(TraceEvent event) {
    for (; nextNs <= event.timeNs(); nextNs += STEP_NS) {
      look(nextNs);
    }
    faults.observe(event);
    bodies.observe(event);
  }

  /** The true position of a body. */
  Point at(RobotId robot, long timeNs) {
    return bodies.poseAt(robot, timeNs).at();
  }

  /** The robots whose bodies are on the floor. */
  Set<RobotId> robots() {
    return bodies.robots();
  }

  /** The cells of a room that have been in view; the caller may change the set. */
  public BitSet seen(Room room) {
    BitSet seen = (BitSet) room.cells().clone();
    seen.andNot(unseen);
    return seen;
  }

  /** The first cell that has not been in view though a robot can see it; -1 if there is none. */
  int missed() {
    return unseen.stream().filter(house::canBeSeen).findFirst().orElse(-1);
  }

  /** The same of one room, and of robots in that room. */
  int missed(Room room) {
    BitSet cells = (BitSet) room.cells().clone();
    cells.and(unseen);
    return cells.stream()
        .filter(cell -> house.canBeSeen(cell, room.places()))
        .findFirst()
        .orElse(-1);
  }

  private void look(long timeNs) {
    for (RobotId robot : bodies.robots()) {
      Point at = at(robot, timeNs);
      Point before = lookedFrom.get(robot);
      if (faults.isUp(robot) && (before == null || before.distanceMm(at) >= STEP_MM)) {
        lookedFrom.put(robot, at);
        Grid grid = house.grid();
        Sight near = house.sight().near(at, house.rangeMm());
        grid.within(at, house.rangeMm())
            .filter(cell -> unseen.get(cell) && near.sees(at, grid.centre(cell)))
            .forEach(unseen::clear);
      }
    }
  }
}
