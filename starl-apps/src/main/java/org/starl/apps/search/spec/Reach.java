package org.starl.apps.search.spec;

import static org.starl.time.Time.NS_PER_S;

import java.util.BitSet;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.Room;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.primitives.paths.Tube;
import org.starl.primitives.paths.TubeFact;
import org.starl.primitives.paths.TubeList;
import org.starl.spec.FaultState;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

/**
 * Where robots that are up can get past those that are down. The tubes of a robot that is down bar
 * the way until it is back, and for a while after that: the others do not know at once that it is
 * back.
 */
final class Reach {

  private static final long JUST_BACK_NS = 30 * NS_PER_S;

  /** Planners need some room beside a tube, and robots stop beside their goals. */
  private static final double MARGIN_MM = 100;

  private final House house;
  private final FaultState faults = new FaultState();
  private final SortedMap<RobotId, List<Tube>> held = new TreeMap<>();
  private final SortedMap<RobotId, List<Tube>> heldWhenDown = new TreeMap<>();
  private final SortedMap<RobotId, Long> backNs = new TreeMap<>();

  Reach(House house) {
    this.house = house;
  }

  void observe(TraceEvent event) {
    faults.observe(event);
    TubeList tubes = event instanceof Variable variable ? variable.of(TubeFact.HELD) : null;
    if (tubes != null) {
      held.put(event.robot(), tubes.tubes());
    } else if (event instanceof Fault fault && fault.name().equals(Fault.CRASH)) {
      heldWhenDown.put(fault.robot(), held.getOrDefault(fault.robot(), List.of()));
    } else if (event instanceof Fault fault && fault.name().equals(Fault.RESTART)) {
      backNs.put(fault.robot(), fault.timeNs());
    }
  }

  boolean isUp(RobotId robot) {
    return faults.isUp(robot);
  }

  /**
   * Whether each cell of a room that can be seen at all can be seen from a place that robots can
   * reach.
   *
   * @param from positions of the robots that are up
   */
  boolean isInReach(Room room, List<Point> from, long nowNs) {
    BitSet open = house.places();
    heldWhenDown.forEach((robot, tubes) -> {
      Long back = backNs.get(robot);
      if (!isUp(robot) || (back != null && nowNs - back < JUST_BACK_NS)) {
        tubes.forEach(tube -> bar(tube, open));
      }
    });
    BitSet reached = new BitSet();
    from.forEach(at -> reached.or(house.reachable(at, open)));
    return room.cells().stream()
        .allMatch(cell -> house.canBeSeen(cell, reached) || !house.canBeSeen(cell));
  }

  private void bar(Tube tube, BitSet open) {
    for (int i = 0; i < tube.parts(); i++) {
      house.bar(tube.part(i).axis(), 2.0 * tube.radiusMm() + MARGIN_MM, open);
    }
  }
}
