package org.starl.apps.race.spec;

import java.util.List;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.apps.race.logic.Claim;
import org.starl.apps.race.logic.RaceApp.Location;
import org.starl.apps.race.logic.RaceFact;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Variable;

/** The winners that each robot knows, by the trace. A crash ends what a robot knows. */
final class Records {

  /** Of each robot whose program runs: its best claim on each point. */
  private final SortedMap<RobotId, SortedMap<Integer, Claim>> claims = new TreeMap<>();

  private final SortedSet<RobotId> done = new TreeSet<>();

  void observe(TraceEvent event) {
    RobotId robot = event.robot();
    switch (event) {
      case Joined joined -> of(robot);
      case Left left -> forget(robot);
      case Fault fault when fault.name().equals(Fault.CRASH) -> forget(robot);
      case Fault fault when fault.name().equals(Fault.RESTART) -> {
        forget(robot);
        of(robot);
      }
      case Variable variable when variable.of(RaceFact.LOCATION) == Location.DONE ->
          done.add(robot);
      case Action action when action.fact() instanceof RaceFact.Taken taken ->
          of(robot).put(taken.point(), taken.claim());
      default -> {}
    }
  }

  private SortedMap<Integer, Claim> of(RobotId robot) {
    return claims.computeIfAbsent(robot, any -> new TreeMap<>());
  }

  private void forget(RobotId robot) {
    claims.remove(robot);
    done.remove(robot);
  }

  /** The robots whose programs run. */
  List<RobotId> robots() {
    return List.copyOf(claims.keySet());
  }

  /** The robots whose programs have ended. */
  List<RobotId> done() {
    return List.copyOf(done);
  }

  /** The claim on {@code point} that {@code robot} knows, or null. */
  @Nullable Claim claim(RobotId robot, int point) {
    SortedMap<Integer, Claim> known = claims.get(robot);
    return known == null ? null : known.get(point);
  }

  /** Whether a robot that is up knows a winner of {@code point}. */
  boolean isKnown(int point) {
    return claims.values().stream().anyMatch(known -> known.containsKey(point));
  }
}
