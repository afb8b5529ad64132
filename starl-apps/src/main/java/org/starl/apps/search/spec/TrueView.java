package org.starl.apps.search.spec;

import java.util.BitSet;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.Room;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.spec.Bodies;
import org.starl.spec.Circumstances;
import org.starl.trace.TraceEvent;

/**
 * What was truly in view: each cell of a room whose middle was in range and sight of a robot's true
 * position while its program ran. Bodies are looked at every 50 ms of movement. For monitors and
 * pictures.
 */
public final class TrueView {

  private static final long STEP_NS = 50_000_000;
  private static final double STEP_MM = 5;

  private final House house;
  private final Bodies bodies;
  private final Circumstances circumstances;
  private final SortedMap<RobotId, Point> lookedFrom = new TreeMap<>();
  private final BitSet unseen = new BitSet();
  private long nextNs;

  public TrueView(House house) {
    this(house, new Bodies(), new Circumstances());
    for (Room room : house.rooms()) {
      room.forEachCell(unseen::set);
    }
  }

  private TrueView(House house, Bodies bodies, Circumstances circumstances) {
    this.house = house;
    this.bodies = bodies;
    this.circumstances = circumstances;
  }

  /** The same at this moment, from now on apart. */
  public TrueView copy() {
    TrueView copy = new TrueView(house, bodies.copy(), circumstances.copy());
    copy.lookedFrom.putAll(lookedFrom);
    copy.unseen.or(unseen);
    copy.nextNs = nextNs;
    return copy;
  }

  /** Sees the next event. */
  public void observe(TraceEvent event) {
    advance(event.timeNs());
    circumstances.observe(event);
    bodies.observe(event);
  }

  /** Time goes on to {@code timeNs}. */
  public void advance(long timeNs) {
    while (nextNs <= timeNs) {
      look(nextNs);
      nextNs += STEP_NS;
    }
  }

  /** Where a body truly is. */
  Point at(RobotId robot, long timeNs) {
    return bodies.poseAt(robot, timeNs).at();
  }

  /** Whose bodies are on the floor. */
  Set<RobotId> robots() {
    return bodies.robots();
  }

  boolean isOnFloor(RobotId robot) {
    return bodies.isOnFloor(robot);
  }

  /** Whether a cell of a room was in view at some time. */
  public boolean wasSeen(int cell) {
    return !unseen.get(cell);
  }

  /** The first cell that was not in view though a robot can see it; -1 if there is none. */
  int missed() {
    for (int cell = unseen.nextSetBit(0); cell >= 0; cell = unseen.nextSetBit(cell + 1)) {
      if (house.canBeSeen(cell)) {
        return cell;
      }
    }
    return -1;
  }

  private void look(long timeNs) {
    for (RobotId robot : bodies.robots()) {
      if (circumstances.isUp(robot)) {
        Point at = bodies.poseAt(robot, timeNs).at();
        Point before = lookedFrom.get(robot);
        if (before == null || before.distanceMm(at) >= STEP_MM) {
          lookedFrom.put(robot, at);
          see(at);
        }
      }
    }
  }

  private void see(Point at) {
    house
        .grid()
        .forEachWithin(
            at,
            house.rangeMm(),
            cell -> {
              if (unseen.get(cell) && house.sight().sees(at, house.grid().centre(cell))) {
                unseen.clear(cell);
              }
            });
  }
}
