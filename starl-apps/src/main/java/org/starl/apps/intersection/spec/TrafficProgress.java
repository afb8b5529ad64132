package org.starl.apps.intersection.spec;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.starl.apps.intersection.logic.CrossingTrace;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
import org.starl.id.RobotId;
import org.starl.spec.Circumstances;
import org.starl.spec.Monitor;
import org.starl.spec.Within;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Variable;

/**
 * {@code traffic_progress} (paper, section 3): within a bound every approaching vehicle departs. It is
 * owed from the moment at which a car comes onto the floor until it leaves it, while no fault is
 * under way and no car is dead: who stands behind one owes nothing. Nor does a parked car or a
 * roadside unit.
 */
final class TrafficProgress implements Monitor {

  private static final String LEMMA = "traffic_progress";

  private final Within<RobotId> departures;
  private final Circumstances circumstances = new Circumstances();
  private final Set<RobotId> dead = new TreeSet<>();
  private final Trips trips = new Trips();
  // Bodies on the floor of which it is not known yet whether they are cars'.
  private final Set<RobotId> unknown = new TreeSet<>();

  TrafficProgress(long boundNs) {
    departures = new Within<>(boundNs);
  }

  @Override
  public List<String> lemmas() {
    return List.of(LEMMA);
  }

  @Override
  public String says(String lemma) {
    return "Every car that comes has left again within the bound.";
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    expire(event.timeNs(), report);
    boolean isChanged = circumstances.observe(event);
    if (event instanceof TraceEvent.Fault) {
      dead.removeIf(circumstances::isUp);
      if (!circumstances.isUp(event.robot())) {
        dead.add(event.robot());
      }
    } else if (event instanceof Left) {
      dead.remove(event.robot());
    }
    if (isChanged) {
      departures.assumeAll(circumstances.isFair() && dead.isEmpty(), event.timeNs());
    }
    if (trips.observe(event) && unknown.remove(event.robot())) {
      owe(event.robot(), event.timeNs());
    }
    switch (event) {
      case Joined joined -> {
        if (trips.isCar(joined.robot())) {
          owe(joined.robot(), joined.timeNs());
        } else {
          unknown.add(joined.robot());
        }
      }
      case Left left -> {
        unknown.remove(left.robot());
        settle(left.robot(), report);
      }
      case Variable variable -> {
        if (variable.source().equals(CrossingTrace.SOURCE)
            && variable.name().equals(CrossingTrace.LOCATION)
            && variable.value().equals(Location.DONE.name())) {
          settle(variable.robot(), report);
        }
      }
      default -> {
        // Neither comes nor goes.
      }
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    expire(endNs, report);
  }

  private void owe(RobotId robot, long nowNs) {
    if (!trips.of(robot).isEmpty()) {
      departures.owe(robot, nowNs);
    }
  }

  private void settle(RobotId robot, Report report) {
    if (departures.settle(robot)) {
      report.checked(LEMMA);
    }
  }

  private void expire(long nowNs, Report report) {
    departures.expire(
        nowNs,
        (robot, sinceNs, deadlineNs) ->
            report.violated(
                LEMMA,
                deadlineNs,
                List.of(robot),
                "came at "
                    + sinceNs / 1_000_000
                    + " ms and has not departed within "
                    + departures.boundNs() / 1_000_000_000
                    + " s"));
  }
}
