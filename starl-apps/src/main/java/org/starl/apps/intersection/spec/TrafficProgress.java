package org.starl.apps.intersection.spec;

import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.starl.apps.intersection.logic.CrossingFact;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.HeldSections;
import org.starl.spec.FaultState;
import org.starl.spec.LemmaMonitor;
import org.starl.spec.Within;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Variable;

/**
 * {@code traffic_progress} (paper, section 3): every approaching vehicle departs within a bound. The
 * bound runs from the time at which a car comes onto the floor until it leaves. It does not run while a
 * fault is active, a car is dead, or a stray car holds a zone, because cars behind these cannot depart.
 * Parked cars and roadside units need not depart.
 */
final class TrafficProgress extends LemmaMonitor {

  private static final String LEMMA = "intersection.traffic_progress";

  private final Within<RobotId> departures;
  private final FaultState faults = new FaultState();
  private final Set<RobotId> dead = new TreeSet<>();
  // Robots on a trip; a car that comes onto the floor may write its trip before or after that.
  private final Set<RobotId> cars = new TreeSet<>();
  private final Set<RobotId> onFloor = new TreeSet<>();
  private final Collection<RobotId> stray;
  private final HeldSections held = new HeldSections();

  /**
   * @param stray cars that leave their way: they may hold their zones for long
   */
  TrafficProgress(long boundNs, Collection<RobotId> stray) {
    this.stray = stray;
    departures = new Within<>(boundNs);
    progress(LEMMA, "Every car that has come onto the floor leaves it within the bound.");
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    expire(event.timeNs(), report);
    RobotId robot = event.robot();
    faults.observe(event);
    if (!stray.isEmpty()) {
      held.observe(event);
    }
    switch (event) {
      case Joined joined -> onFloor.add(robot);
      case Left left -> {
        dead.remove(robot);
        onFloor.remove(robot);
      }
      case Fault fault when faults.isUp(robot) -> dead.remove(robot);
      case Fault fault -> dead.add(robot);
      case Action action -> {
        if (CrossingFact.trip(action).filter(trip -> !trip.zones().isEmpty()).isPresent()) {
          cars.add(robot);
        }
      }
      default -> {
        // Changes nothing here.
      }
    }
    boolean isHeldUp = !dead.isEmpty() || !Collections.disjoint(stray, held.holders());
    departures.assumeAll(faults.isFaultFree() && !isHeldUp, event.timeNs());
    if (event instanceof Left || isDone(event)) {
      cars.remove(robot);
      if (departures.stop(robot)) {
        report.checked(LEMMA);
      }
    } else if (cars.contains(robot) && onFloor.contains(robot)) {
      departures.start(robot, event.timeNs());
    }
  }

  private static boolean isDone(TraceEvent event) {
    return event instanceof Variable
        && CrossingFact.location(event).filter(Location.DONE::equals).isPresent();
  }

  @Override
  public void finish(long endNs, Report report) {
    expire(endNs, report);
  }

  private void expire(long nowNs, Report report) {
    long boundS = departures.boundNs() / Time.NS_PER_S;
    departures.expire(
        nowNs,
        (robot, sinceNs, deadlineNs) ->
            report.overdue(
                LEMMA,
                deadlineNs,
                List.of(robot),
                String.format(
                    "came at %s ms, not departed within %s s", sinceNs / Time.NS_PER_MS, boundS)));
  }
}
