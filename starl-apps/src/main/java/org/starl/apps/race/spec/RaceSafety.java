package org.starl.apps.race.spec;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.apps.race.logic.Claim;
import org.starl.apps.race.logic.Drive;
import org.starl.apps.race.logic.Patience;
import org.starl.apps.race.logic.RaceApp;
import org.starl.apps.race.logic.RaceApp.Location;
import org.starl.apps.race.logic.RaceFact;
import org.starl.apps.race.logic.RaceFact.Arrived;
import org.starl.apps.race.logic.RaceFact.Taken;
import org.starl.apps.race.logic.RaceFact.Way;
import org.starl.apps.race.logic.RacePoint;
import org.starl.apps.race.logic.RightOfWay;
import org.starl.geometry.Circle;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionFlag;
import org.starl.primitives.geocast.GeocastFact;
import org.starl.primitives.geocast.GeocastMessage;
import org.starl.spec.Bodies;
import org.starl.spec.LemmaMonitor;
import org.starl.spec.TellCheck;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/**
 * The safety of a race, under all faults.
 *
 * <ul>
 *   <li>{@code at_the_point}: a robot that arrives at a point is there by its true body: within the
 *       point's radius and the error bound of its position; or, kept off, within the distance
 *       that its {@link Patience} allows. Only then it claims to have been kept off.
 *   <li>{@code truly_won}: every winner that a robot knows has arrived and has claimed the point
 *       itself.
 *   <li>{@code one_winner}: a robot knows one winner of each point, and replaces it only by a
 *       better one ({@link Records#BETTER}): so two robots that know the same claims agree.
 *   <li>{@code announced}: a robot that learns of a winner, or of a better one, broadcasts that in the same
 *       step.
 *   <li>{@code moves_on}: a robot arrives only at a point whose winner it does not know; when it knows all,
 *       its motion has ended.
 *   <li>{@code confirmed}: when a robot is done, all robots that were never down know the winners, unless it
 *       has told them for long.
 *   <li>{@code makes_way}: a robot that draws back stays so for as long as it promises, and while another
 *       one has the way, or until the point is won; one that drives and hears of another one's way draws
 *       back. While a robot has the way, only a nearer one gets it, and it does not ask anew. When a robot
 *       asks for the way to a point, one has the way to that point, as far as it knows. It draws back away from
 *       its point.
 * </ul>
 */
public final class RaceSafety extends LemmaMonitor {

  private static final String AT_THE_POINT = "race.at_the_point";
  private static final String TRULY_WON = "race.truly_won";
  private static final String ONE_WINNER = "race.one_winner";
  private static final String ANNOUNCED = "race.announced";
  private static final String MOVES_ON = "race.moves_on";
  private static final String CONFIRMED = "race.confirmed";
  private static final String MAKES_WAY = "race.makes_way";

  // By a clock that runs fast, too.
  private static final long TELLS_NS = RaceApp.TELL_PATIENCE_MS * Time.NS_PER_MS / 2;
  private static final long MAKES_WAY_NS = RaceApp.MAKE_WAY_MS * Time.NS_PER_MS * 9 / 10;
  // It looks each 100 ms; a clock may jump by some ms.
  private static final long LOOKS_NS = Time.NS_PER_S;
  private static final long WAY_NS = RightOfWay.LASTS_NS - 100 * Time.NS_PER_MS;
  private static final double ROUNDING_MM = 0.01;

  // By so much a robot may err about how much nearer a motion has brought it.
  private static final double SURE_MM = 200;

  /** The way that a robot knows of, from then on. */
  private record Heard(long atNs, Way way) {}

  private final List<RacePoint> points;
  private final Bodies bodies = new Bodies();
  private final Records records = new Records();
  private final Map<RobotId, RacePoint> racingTo = new TreeMap<>();
  private final Map<RobotId, MotionFlag> flags = new TreeMap<>();
  private final Map<RobotId, Integer> inVain = new TreeMap<>();
  private final Map<RobotId, Double> nearestMm = new TreeMap<>(); // of the motions in vain
  private final Map<RobotId, Integer> arrivedAt = new TreeMap<>();
  private final Set<Claim> made = new TreeSet<>();
  private final Map<RobotId, Long> tellsFromNs = new TreeMap<>();
  private final Map<RobotId, Long> makesWayFromNs = new TreeMap<>();
  private final Map<RobotId, Long> racesFromNs = new TreeMap<>();
  private final Map<RobotId, Heard> ways = new TreeMap<>();
  private final Set<RobotId> wereDown = new TreeSet<>();

  private final TellCheck tells = new TellCheck(ANNOUNCED);

  public RaceSafety(List<RacePoint> points) {
    lemma(AT_THE_POINT, "A robot that arrives at a point is there, by its true body.");
    lemma(
        TRULY_WON, "Every winner that a robot knows has arrived and has claimed the point itself.");
    lemma(
        ONE_WINNER,
        "A robot knows one winner of each point, and replaces it only by a better one.");
    lemma(
        ANNOUNCED,
        "A robot that learns of a winner, or of a better one, tells all robots in the same step.");
    lemma(
        MOVES_ON,
        "A robot arrives only at points without a known winner, and stops when it knows all.");
    lemma(
        CONFIRMED,
        "When a robot is done, all that were never down know the winners, or it has told them for long.");
    lemma(
        MAKES_WAY,
        "A robot draws back for 3 s, and while a nearer one that asks has the way, unless the point is won.");
    this.points = List.copyOf(points);
    tells.begin();
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    bodies.observe(event);
    tells.observe(event, report);
    switch (event) {
      case Action action when action.fact() instanceof Arrived arrived ->
          arrived(action, arrived, report);
      case Action action when action.fact() instanceof Taken taken ->
          taken(action, taken.claim(), report);
      case Action action when action.fact() instanceof Way way -> passes(action, way, report);
      case Action action
          when action.fact() instanceof GeocastFact.do_geocast asks
              && asks.area() instanceof Circle around ->
          asks(action, around.center(), report);
      case Action action
          when action.fact() instanceof MotionFact.doMove move
              && move.target().name().equals(Drive.BACK) ->
          drawsBack(action, move.target().at(), report);
      case Variable variable when variable.of(RaceFact.POINT) != null -> sets(variable);
      case Variable variable when variable.of(MotionFact.FLAG) != null -> ends(variable);
      case Variable variable when variable.of(RaceFact.LOCATION) != null ->
          goesOn(variable, report);
      case Fault fault when fault.name().equals(Fault.CRASH) -> {
        wereDown.add(fault.robot());
        makesWayFromNs.remove(fault.robot());
        racesFromNs.remove(fault.robot());
        ways.remove(fault.robot());
      }
      default -> {}
    }
    records.observe(event);
  }

  private void sets(Variable point) {
    RobotId robot = point.robot();
    inVain.put(robot, 0);
    nearestMm.remove(robot);
    racingTo.remove(robot);
    points.stream()
        .filter(each -> each.name().equals(point.of(RaceFact.POINT)))
        .forEach(each -> racingTo.put(robot, each));
  }

  /** Failed motions before one that has brought the robot nearer for certain do not count. */
  private void ends(Variable flag) {
    RobotId robot = flag.robot();
    MotionFlag now = Objects.requireNonNull(flag.of(MotionFact.FLAG));
    flags.put(robot, now);
    if (now != MotionFlag.FAIL) {
      return;
    }
    RacePoint point = racingTo.get(robot);
    if (point != null && bodies.isOnFloor(robot)) {
      double mm = bodies.poseAt(robot, flag.timeNs()).distanceMm(point.at());
      double beforeMm = nearestMm.getOrDefault(robot, Double.POSITIVE_INFINITY);
      if (mm < beforeMm - Patience.NEARER_MM - SURE_MM) {
        inVain.put(robot, 0);
      }
      nearestMm.put(robot, Math.min(mm, beforeMm));
    }
    inVain.merge(robot, 1, Integer::sum);
  }

  private void passes(Action action, Way way, Report report) {
    Heard last = ways.put(action.robot(), new Heard(action.timeNs(), way));
    if (last != null
        && last.way().point() == way.point()
        && action.timeNs() - last.atNs() < WAY_NS) {
      boolean isAgain =
          way.robot().equals(action.robot()) && last.way().robot().equals(way.robot());
      if (isAgain || way.distanceMm() > last.way().distanceMm()) {
        String detail =
            (isAgain ? "asks again, after " : "a farther robot has the way, after ") + last.way();
        report.violated(MAKES_WAY, action.timeNs(), List.of(action.robot()), detail);
      }
    }
  }

  /** A robot that asks the robots around a point for the way: one has the way there from then on. */
  private void asks(Action action, Point around, Report report) {
    report.checked(MAKES_WAY);
    Heard known = ways.get(action.robot());
    if (known == null || !points.get(known.way().point()).at().equals(around)) {
      String detail = "asks for the way to " + around + ", and knows of " + known;
      report.violated(MAKES_WAY, action.timeNs(), List.of(action.robot()), detail);
    }
  }

  /** It draws back by more than its position may be off. */
  private void drawsBack(Action action, Point to, Report report) {
    RacePoint point = racingTo.get(action.robot());
    if (point == null || !bodies.isOnFloor(action.robot())) {
      return;
    }
    report.checked(MAKES_WAY);
    double awayMm = bodies.poseAt(action.robot(), action.timeNs()).distanceMm(point.at());
    if (to.distanceMm(point.at()) < awayMm) {
      String detail = "draws back from " + point.name() + " to " + to + ", which is nearer";
      report.violated(MAKES_WAY, action.timeNs(), List.of(action.robot()), detail);
    }
  }

  /** Whether another robot has the way to its point for so long, as far as it knows. */
  private boolean isOthers(TraceEvent event, long forNs) {
    Heard last = ways.get(event.robot());
    return last != null
        && !last.way().robot().equals(event.robot())
        && points.get(last.way().point()).equals(racingTo.get(event.robot()))
        && event.timeNs() - last.atNs() >= forNs
        && event.timeNs() - last.atNs() < WAY_NS;
  }

  private void goesOn(Variable location, Report report) {
    RobotId robot = location.robot();
    Location next = Objects.requireNonNull(location.of(RaceFact.LOCATION));
    Long sinceNs = makesWayFromNs.remove(robot);
    long racesNs = location.timeNs() - racesFromNs.getOrDefault(robot, location.timeNs());
    racesFromNs.remove(robot);
    boolean hasDrivenOn = racesNs >= LOOKS_NS && isOthers(location, LOOKS_NS);
    if (hasDrivenOn || (next == Location.RACE && sinceNs != null && isOthers(location, 1))) {
      String detail = "drives on, and another robot has the way";
      report.violated(MAKES_WAY, location.timeNs(), List.of(robot), detail);
    }
    switch (next) {
      case MAKE_WAY -> makesWayFromNs.put(robot, location.timeNs());
      case RACE -> {
        report.checked(MAKES_WAY);
        racesFromNs.put(robot, location.timeNs());
        if (sinceNs != null && location.timeNs() - sinceNs < MAKES_WAY_NS) {
          String detail = "makes way for " + Time.text(location.timeNs() - sinceNs, 1) + " only";
          report.violated(MAKES_WAY, location.timeNs(), List.of(robot), detail);
        }
      }
      case TELL -> {
        tellsFromNs.put(robot, location.timeNs());
        if (flags.get(robot) == MotionFlag.MOVING) {
          String detail = "knows all winners, and drives on";
          report.violated(MOVES_ON, location.timeNs(), List.of(robot), detail);
        }
      }
      case DONE -> checkConfirmed(location, report);
      case START, PICK -> {
        // Nothing is promised.
      }
    }
  }

  private void arrived(Action action, Arrived arrived, Report report) {
    RobotId robot = action.robot();
    int number = arrived.point();
    RacePoint point = points.get(number);
    double errorMm = arrived.errorMm();
    double saidMm = arrived.withinMm();
    arrivedAt.put(robot, number);
    report.checked(MOVES_ON);
    Claim known = records.claim(robot, number);
    if (known != null) {
      String detail = "arrives at " + point.name() + ", and knows of " + known;
      report.violated(MOVES_ON, action.timeNs(), List.of(robot), detail);
    }
    report.checked(AT_THE_POINT);
    double truthMm =
        bodies.isOnFloor(robot)
            ? bodies.poseAt(robot, action.timeNs()).distanceMm(point.at())
            : Double.POSITIVE_INFINITY;
    double allowedMm = Math.max(point.radiusMm(), patienceMm(robot, point));
    if (truthMm > Math.min(saidMm, allowedMm) + errorMm + ROUNDING_MM) {
      String detail =
          String.format(
              Locale.ROOT,
              "arrives at %s and is %.1f mm off; %.1f mm said, %.1f mm allowed, error %.1f mm",
              point.name(),
              truthMm,
              saidMm,
              allowedMm,
              errorMm);
      report.violated(AT_THE_POINT, action.timeNs(), List.of(robot), detail);
    }
  }

  /** From so far the robot may claim that it was kept off; not above 0 for from nowhere. */
  private double patienceMm(RobotId robot, RacePoint point) {
    double bodyMm = bodies.isOnFloor(robot) ? bodies.radiusMm(robot) : 0;
    return (inVain.getOrDefault(robot, 0) - 2) * (2 * bodyMm + point.radiusMm()); // from the third
  }

  private void checkConfirmed(Variable done, Report report) {
    report.checked(CONFIRMED);
    if (done.timeNs() - tellsFromNs.getOrDefault(done.robot(), done.timeNs()) >= TELLS_NS) {
      return;
    }
    for (RobotId robot : records.robots()) {
      for (int point = 0; point < points.size() && !wereDown.contains(robot); point++) {
        Claim mine = records.claim(done.robot(), point);
        Claim theirs = records.claim(robot, point);
        if (theirs == null || (mine != null && Records.BETTER.compare(mine, theirs) < 0)) {
          String detail = robot + " does not know the winner of " + points.get(point).name();
          report.violated(CONFIRMED, done.timeNs(), List.of(done.robot()), detail);
          return;
        }
      }
    }
  }

  private void taken(TraceEvent event, Claim claim, Report report) {
    RobotId robot = event.robot();
    List<RobotId> concerned = List.copyOf(new TreeSet<>(List.of(robot, claim.winner())));
    Integer here = robot.equals(claim.winner()) ? arrivedAt.remove(robot) : null;
    if (here != null && here == claim.point()) {
      made.add(claim);
      if (claim.wasKeptOff() && patienceMm(robot, points.get(here)) <= 0) {
        String detail = claim + ", after " + inVain.getOrDefault(robot, 0) + " motions in vain";
        report.violated(AT_THE_POINT, event.timeNs(), concerned, detail);
      }
    }
    tells.owes(
        event,
        Sent.ALL,
        claim.toString(),
        told -> told instanceof GeocastMessage.Copy<?> copy && claim.equals(copy.message()));
    report.checked(TRULY_WON);
    if (!made.contains(claim)) {
      report.violated(TRULY_WON, event.timeNs(), concerned, claim + " was never made");
    }
    report.checked(ONE_WINNER);
    Claim before = records.claim(robot, claim.point());
    if (before != null && Records.BETTER.compare(before, claim) <= 0) {
      String detail = before + " is replaced by " + claim + ", which is no better";
      report.violated(ONE_WINNER, event.timeNs(), concerned, detail);
    }
  }
}
