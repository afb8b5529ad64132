package org.starl.apps.race.spec;

import java.util.List;
import java.util.Objects;
import org.starl.apps.race.logic.RacePoint;
import org.starl.id.RobotId;
import org.starl.spec.Circumstances;
import org.starl.spec.Monitor;
import org.starl.spec.Within;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/**
 * What a race owes while the world behaves.
 *
 * <ul>
 *   <li>{@code told}: within a bound of the first who knows that a point is won, everybody who is up
 *       knows that.
 *   <li>{@code taken}: within a bound of one point the next one is won.
 *   <li>{@code agreed}: at the end, all whose apps have come to their end know the same winners.
 * </ul>
 */
final class RaceProgress implements Monitor {

  private static final String TOLD = "told";
  private static final String TAKEN = "taken";
  private static final String AGREED = "agreed";

  private final List<RacePoint> points;
  private final RaceBounds bounds;
  private final Records records = new Records();
  private final Circumstances circumstances = new Circumstances();
  private final Within<Seat> told;
  private final Within<Integer> taken;
  private long fairSinceNs;

  /** A robot that has to hear of a point. */
  private record Seat(RobotId robot, int point) {}

  RaceProgress(List<RacePoint> points, RaceBounds bounds) {
    this.points = List.copyOf(points);
    this.bounds = bounds;
    told = new Within<>(bounds.toldNs());
    taken = new Within<>(bounds.takenNs());
  }

  @Override
  public List<String> lemmas() {
    return List.of(TOLD, TAKEN, AGREED);
  }

  @Override
  public String says(String lemma) {
    return switch (lemma) {
      case TOLD ->
          "Once somebody knows who has won a point, everybody who is up knows within the bound.";
      case TAKEN -> "Within the bound after one point the next one is won.";
      case AGREED -> "All who come to the end know the same winners.";
      default -> "";
    };
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    expire(event.timeNs(), report);
    if (circumstances.observe(event)) {
      long nowNs = event.timeNs();
      told.assumeAll(circumstances.isFair(), nowNs);
      taken.assumeAll(circumstances.isFair(), nowNs);
      fairSinceNs = circumstances.isFair() ? nowNs : Long.MAX_VALUE;
    }
    records.observe(event);
    switch (event) {
      case Action action when Records.isTaken(action) ->
          update(Integer.parseInt(action.args().get(0)), action.timeNs(), report);
      case TraceEvent.Joined joined -> updateAll(joined.timeNs(), report);
      case TraceEvent.Left left -> updateAll(left.timeNs(), report);
      case TraceEvent.Fault fault -> updateAll(fault.timeNs(), report);
      default -> {
        // Nothing more is owed, nothing less.
      }
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    expire(endNs, report);
    if (circumstances.isFair() && endNs - fairSinceNs > bounds.toldNs()) {
      for (int point = 0; point < points.size(); point++) {
        agree(point, endNs, report);
      }
    }
  }

  private void updateAll(long nowNs, Report report) {
    for (int point = 0; point < points.size(); point++) {
      update(point, nowNs, report);
    }
  }

  private void update(int point, long nowNs, Report report) {
    boolean isKnown = records.isKnown(point);
    for (RobotId robot : records.robots()) {
      Seat seat = new Seat(robot, point);
      if (isKnown && records.claim(robot, point) == null) {
        told.owe(seat, nowNs);
      } else if (told.settle(seat)) {
        report.checked(TOLD);
      }
    }
    if (isKnown && taken.settle(point)) {
      report.checked(TAKEN);
    }
    for (int next = 0; next < points.size(); next++) {
      if (!records.isKnown(next)) {
        taken.owe(next, nowNs);
        return;
      }
    }
  }

  private void agree(int point, long endNs, Report report) {
    List<RobotId> done = records.robots().stream().filter(records::isDone).toList();
    report.checked(AGREED);
    for (RobotId robot : done) {
      if (!Objects.equals(records.claim(robot, point), records.claim(done.get(0), point))) {
        report.violated(
            AGREED,
            endNs,
            List.of(done.get(0), robot),
            points.get(point).name()
                + ": "
                + records.claim(done.get(0), point)
                + " and "
                + records.claim(robot, point));
        return;
      }
    }
  }

  private void expire(long nowNs, Report report) {
    told.expire(
        nowNs,
        (seat, sinceNs, deadlineNs) -> {
          // Who has crashed since owes nothing.
          if (records.robots().contains(seat.robot()) && records.isKnown(seat.point())) {
            report.violated(
                TOLD,
                deadlineNs,
                List.of(seat.robot()),
                "does not know that "
                    + points.get(seat.point()).name()
                    + " is won, which others know since "
                    + sinceNs
                    + " ns");
          }
        });
    taken.expire(
        nowNs,
        (point, sinceNs, deadlineNs) ->
            report.violated(
                TAKEN,
                deadlineNs,
                List.of(),
                points.get(point).name() + " is open since " + sinceNs + " ns, and not won"));
  }
}
