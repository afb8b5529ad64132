package org.starl.apps.race.spec;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import org.starl.apps.race.logic.Claim;
import org.starl.apps.race.logic.RaceFact;
import org.starl.apps.race.logic.RacePoint;
import org.starl.id.RobotId;
import org.starl.spec.FaultState;
import org.starl.spec.LemmaMonitor;
import org.starl.spec.Within;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;

/**
 * The progress of a race, required while no fault is active.
 *
 * <ul>
 *   <li>{@code told}: within a bound of the first robot that knows a point's winner, or a better one, all
 *       robots that are up know it.
 *   <li>{@code taken}: within a bound of one point the next one is won.
 *   <li>{@code agreed}: at the end, all robots whose apps have ended know the same winners.
 * </ul>
 */
public final class RaceProgress extends LemmaMonitor {

  private static final String TOLD = "race.told";
  private static final String TAKEN = "race.taken";
  private static final String AGREED = "race.agreed";

  /** Generous, to tell a race that stands still from one that is slow. */
  private static final double SLOWEST_MM_PER_S = 25;

  private static final double TURNS_S = 120;

  /**
   * A broadcast sends so many copies in 5 s; the next one begins at most a round after it began.
   */
  private static final int COPIES = 9;

  private static final double ROUND_S = 8.5;
  private static final double SETTLE_S = 1;

  /** So many copies in a row are lost in no run of all campaigns together. */
  private static final double NEVER = 1e-13;

  private static final int MAX_COPIES = 50_000;

  private final List<RacePoint> points;
  private final Records records = new Records();
  private final FaultState faults = new FaultState();
  private final Within<Hearing> told;
  private final Within<Integer> taken;
  private long fairSinceNs;

  /** A robot that does not know the best claim on a point that another robot knows. */
  private record Hearing(RobotId robot, int point) {}

  /** The best claim on each point that a robot knows that is up. */
  private final Map<Integer, Claim> best = new TreeMap<>();

  /**
   * @param longestDelayNs no message that arrives takes longer
   * @param loss probability that a message is lost
   * @param farthestMm no robot is farther from the next point
   */
  public RaceProgress(List<RacePoint> points, long longestDelayNs, double loss, double farthestMm) {
    this.points = List.copyOf(points);
    progress(
        TOLD, "Once a robot knows the winner of a point, all robots that are up know it in time.");
    progress(TAKEN, "Within the bound after one point the next one is won.");
    lemma(AGREED, "All robots that end know the same winners.");
    int copies = 1;
    for (double all = loss; all > NEVER && copies < MAX_COPIES; all *= loss) {
      copies++;
    }
    int rounds = 1 + Math.ceilDiv(copies, COPIES);
    long toldNs = 2 * longestDelayNs + (long) ((rounds * ROUND_S + SETTLE_S) * Time.NS_PER_S);
    long driveNs = (long) ((farthestMm / SLOWEST_MM_PER_S + TURNS_S) * Time.NS_PER_S);
    told = new Within<>(toldNs);
    taken = new Within<>(driveNs + toldNs);
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    long nowNs = event.timeNs();
    expire(nowNs, report);
    if (faults.observe(event)) {
      boolean isFair = faults.isFaultFree();
      told.assumeAll(isFair, nowNs);
      taken.assumeAll(isFair, nowNs);
      fairSinceNs = isFair ? nowNs : Long.MAX_VALUE;
    }
    records.observe(event);
    Claim claim = RaceFact.taken(event);
    if (claim != null) {
      update(claim.point(), nowNs, report);
    }
    if (event instanceof Joined || event instanceof Left || event instanceof Fault) {
      for (int point = 0; point < points.size(); point++) {
        update(point, nowNs, report);
      }
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    expire(endNs, report);
    if (faults.isFaultFree() && endNs - fairSinceNs > told.boundNs()) {
      for (int point = 0; point < points.size(); point++) {
        agree(point, endNs, report);
      }
    }
  }

  private void update(int point, long nowNs, Report report) {
    Claim winner = records.best(point);
    Claim before = winner == null ? best.remove(point) : best.put(point, winner);
    boolean isKnown = winner != null;
    boolean isOther = !Objects.equals(winner, before);
    for (RobotId robot : records.robots()) {
      Hearing hearing = new Hearing(robot, point);
      boolean knowsIt = Objects.equals(records.claim(robot, point), winner);
      if ((knowsIt || isOther) && told.stop(hearing) && knowsIt) {
        report.checked(TOLD);
      }
      if (!knowsIt) {
        told.start(hearing, nowNs);
      }
    }
    if (isKnown && taken.stop(point)) {
      report.checked(TAKEN);
    }
    for (int next = 0; next < points.size(); next++) {
      if (records.best(next) == null) {
        taken.start(next, nowNs);
        return;
      }
    }
  }

  private void agree(int point, long endNs, Report report) {
    report.checked(AGREED);
    for (RobotId robot : records.done()) {
      RobotId first = records.done().get(0);
      Claim theirs = records.claim(first, point);
      Claim own = records.claim(robot, point);
      if (!Objects.equals(theirs, own)) {
        String detail = name(point) + ": " + theirs + " and " + own;
        report.violated(AGREED, endNs, List.of(first, robot), detail);
        return;
      }
    }
  }

  private void expire(long nowNs, Report report) {
    told.expire(
        nowNs,
        (hearing, sinceNs, deadlineNs) -> {
          RobotId robot = hearing.robot();
          // A robot that has crashed since need not know.
          if (records.robots().contains(robot) && best.containsKey(hearing.point())) {
            String others = ", others have since " + sinceNs + " ns";
            String detail = "does not know the winner of " + name(hearing.point()) + others;
            report.overdue(TOLD, deadlineNs, List.of(robot), detail);
          }
        });
    taken.expire(
        nowNs,
        (point, sinceNs, deadlineNs) -> {
          String detail = name(point) + " has not been won since " + sinceNs + " ns";
          report.overdue(TAKEN, deadlineNs, List.of(), detail);
        });
  }

  private String name(int point) {
    return points.get(point).name();
  }
}
