package org.starl.apps.intersection.spec;

import java.util.List;
import org.starl.RobotId;
import org.starl.apps.intersection.logic.IntersectionApp;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
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
 * under way; a parked car owes nothing.
 */
final class TrafficProgress implements Monitor {

  private static final String LEMMA = "traffic_progress";

  // At most, for one car that has its turn: to join the view and be granted with a third of the
  // messages lost and 200 ms delays; to drive 3.5 m at the lowest straight speed; to turn three
  // times by a right angle at the lowest turning speed and settle.
  private static final long NETWORK_NS = 15_000_000_000L;
  private static final long DRIVE_NS = 20_000_000_000L;
  private static final long TURNS_NS = 15_000_000_000L;
  // And once: until the last debris is cleared away.
  private static final long DEBRIS_NS = 30_000_000_000L;

  private final Within<RobotId> departures;
  private final Circumstances circumstances = new Circumstances();

  TrafficProgress(int cars) {
    departures = new Within<>(boundNs(cars));
  }

  /** In the worst case cars cross one after another. */
  static long boundNs(int cars) {
    return cars * (NETWORK_NS + DRIVE_NS + TURNS_NS) + DEBRIS_NS;
  }

  @Override
  public List<String> lemmas() {
    return List.of(LEMMA);
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    expire(event.timeNs(), report);
    if (circumstances.observe(event)) {
      departures.assumeAll(circumstances.isFair(), event.timeNs());
    }
    switch (event) {
      case Joined joined -> departures.owe(joined.robot(), joined.timeNs());
      case Left left -> settle(left.robot(), report);
      case Variable variable -> {
        if (variable.source().equals(IntersectionApp.SOURCE)
            && variable.name().equals("location")
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
