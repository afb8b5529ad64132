package org.starl.apps.race.spec;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.apps.race.logic.Claim;
import org.starl.apps.race.logic.RaceApp.Location;
import org.starl.apps.race.logic.RaceTrace;
import org.starl.apps.race.logic.Scoreboard;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Variable;

/** What each robot that is up knows of the points' winners, as it has told. */
final class Records {

  private final SortedMap<RobotId, Past> records = new TreeMap<>();

  /** Of one start of a robot's program. */
  private static final class Past {
    private final SortedMap<Integer, Claim> claims = new TreeMap<>();
    private boolean isDone;
  }

  /** What a program that ends knew is forgotten. */
  void observe(TraceEvent event) {
    switch (event) {
      case Joined joined -> records.putIfAbsent(joined.robot(), new Past());
      case Left left -> records.remove(left.robot());
      case Fault fault when fault.name().equals(Fault.CRASH) -> records.remove(fault.robot());
      case Fault fault when fault.name().equals(Fault.RESTART) ->
          records.put(fault.robot(), new Past());
      case Action action when isTaken(action) -> {
        Claim claim = Scoreboard.claim(action.args());
        of(action.robot()).claims.put(claim.point(), claim);
      }
      case Variable variable
          when variable.source().equals(RaceTrace.SOURCE)
              && variable.name().equals(RaceTrace.LOCATION) ->
          of(variable.robot()).isDone = variable.value().equals(Location.DONE.name());
      default -> {
        // Says nothing of winners.
      }
    }
  }

  static boolean isTaken(Action action) {
    return action.source().equals(RaceTrace.SOURCE) && action.name().equals(Scoreboard.TAKEN);
  }

  private Past of(RobotId robot) {
    return records.computeIfAbsent(robot, anybody -> new Past());
  }

  /** The robots whose programs are there. */
  List<RobotId> robots() {
    return List.copyOf(records.keySet());
  }

  /** Whether its app has come to its end. */
  boolean isDone(RobotId robot) {
    return of(robot).isDone;
  }

  /** The winner of {@code point} that {@code robot} knows of, or null. */
  @Nullable Claim claim(RobotId robot, int point) {
    return of(robot).claims.get(point);
  }

  /** Whether anybody who is up knows a winner of {@code point}. */
  boolean isKnown(int point) {
    return records.values().stream().anyMatch(record -> record.claims.containsKey(point));
  }
}
