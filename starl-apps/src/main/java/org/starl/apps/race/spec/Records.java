package org.starl.apps.race.spec;

import java.util.Comparator;
import java.util.List;
import java.util.Objects;
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

  /**
   * The better one of two claims on a point first, by the rules of a race: who was at the point before who
   * was kept off, then who came first, then the first name. The app has an order of its own, to be checked.
   */
  static final Comparator<Claim> BETTER =
      Comparator.comparing((Claim claim) -> claim.keptOffMm() > 0)
          .thenComparingLong(Claim::atNs)
          .thenComparing(Claim::winner)
          .thenComparingInt(Claim::keptOffMm);

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

  /** The best claim on {@code point} that a robot knows that is up, or null. */
  @Nullable Claim best(int point) {
    return claims.values().stream()
        .map(known -> known.get(point))
        .filter(Objects::nonNull)
        .min(BETTER)
        .orElse(null);
  }
}
