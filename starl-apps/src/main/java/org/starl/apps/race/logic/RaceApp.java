package org.starl.apps.race.logic;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.apps.race.logic.RaceFact.Arrived;
import org.starl.gvh.GvhCell;
import org.starl.id.RobotId;
import org.starl.motion.Location.Known;
import org.starl.time.Time;

/**
 * A robot in a race. It drives to the first point without a known winner; the first robot there
 * announces that it has won, and all robots stop and take the next point. A robot that bumps into
 * another turns away until nothing is in front and drives on (the motion automaton's {@code
 * USE_COLAVOID}). If it gets no nearer that way, it drives to a random place near by and tries
 * again.
 */
public final class RaceApp extends LogicThread {

  /** The state of the program. */
  public enum Location {
    START,
    PICK,
    RACE,
    MAKE_WAY,
    TELL,
    DONE
  }

  /** A robot that has not acknowledged the winners after so long is taken for dead. */
  public static final long TELL_PATIENCE_MS = 90_000;

  /** So long a robot draws back at least, unless the point is won. */
  public static final long MAKE_WAY_MS = 3_000;

  private static final long PERIOD_MS = 100;

  private final List<RacePoint> points;
  private final Drive drive;
  private final Scoreboard board;
  private final RightOfWay way;
  private final GvhCell<Location> location;
  private final GvhCell<String> racingTo;

  private int number;
  private RacePoint point;
  private Patience patience;
  private long sinceNs;

  /**
   * @param xid the name of the race: robots with another one are in another race
   * @param points at least one, in the order in which the robots race to them
   */
  public RaceApp(GlobalVarHolder gvh, String xid, List<RacePoint> points) {
    super(gvh);
    this.points = List.copyOf(points);
    drive = new Drive(gvh);
    location = gvh.variable(RaceFact.LOCATION, Location.START);
    racingTo = gvh.variable(RaceFact.POINT, "");
    board = new Scoreboard(gvh, xid, points);
    way = new RightOfWay(gvh, xid);
    point = points.get(0);
    patience = patience();
  }

  /**
   * Returns the name of each point's winner, in the points' order, and then, if there are any, the
   * robots that may not know the winners.
   */
  @Override
  public List<Object> callStarL() {
    while (true) {
      switch (location.get()) {
        case START -> {
          if (gvh.gps.hasFix()) {
            location.set(Location.PICK);
          }
        }
        case PICK -> pick();
        case RACE -> race();
        case MAKE_WAY -> makeWay();
        case TELL -> {
          if (board.unconfirmed().isEmpty() || hasLasted(TELL_PATIENCE_MS)) {
            location.set(Location.DONE);
          }
        }
        case DONE -> {
          return results();
        }
      }
      sleep(PERIOD_MS);
    }
  }

  private void pick() {
    gvh.plat.moat.motion_stop();
    number = board.next();
    if (number == points.size()) {
      racingTo.set("");
      enter(Location.TELL);
      return;
    }
    point = points.get(number);
    racingTo.set(point.name());
    patience = patience();
    drive();
  }

  private void drive() {
    drive.to(point);
    enter(Location.RACE);
  }

  private void race() {
    if (board.isTaken(number)) {
      location.set(Location.PICK);
    } else if (gvh.gps.location() instanceof Known known) {
      double distanceMm = known.pose().distanceMm(point.at());
      if (drive.isAt(point, known)) {
        arrive(0); // maybe while it turns away from another robot
      } else if (gvh.plat.moat.failed()) {
        if (patience.recordFailedMotion(distanceMm)) {
          arrive((int) Math.ceil(distanceMm));
        } else {
          askForWay(distanceMm);
        }
      } else if (!gvh.plat.moat.inMotion()) {
        drive(); // a new fix shows that it is not quite there
      } else if (way.isOthers(number)) {
        askForWay(distanceMm);
      }
    }
  }

  /**
   * Asks for the way and drives on; draws back if it is another robot's turn.
   */
  private void askForWay(double distanceMm) {
    if (!way.mayAsk(number, distanceMm)) {
      drive.backFrom(point);
      enter(Location.MAKE_WAY);
      return;
    }
    way.ask(number, point.at(), distanceMm);
    if (!gvh.plat.moat.inMotion()) {
      drive();
    }
  }

  private void makeWay() {
    if (board.isTaken(number)) {
      location.set(Location.PICK);
    } else if (!way.isOthers(number) && hasLasted(MAKE_WAY_MS)) {
      drive();
    } else if (gvh.plat.moat.failed()) {
      drive.backFrom(point);
    }
  }

  private void arrive(int keptOffMm) {
    gvh.trace.action(
        Arrived.SHAPE,
        new Arrived(
            number,
            point.name(),
            gvh.gps.pose().distanceMm(point.at()),
            gvh.gps.errorMm(),
            Math.max(point.radiusMm(), keptOffMm)));
    board.claim(number, keptOffMm);
    location.set(Location.PICK);
  }

  private void enter(Location next) {
    location.set(next);
    sinceNs = gvh.plat.clock.nowNs();
  }

  private boolean hasLasted(long ms) {
    return gvh.plat.clock.nowNs() - sinceNs >= ms * Time.NS_PER_MS;
  }

  private Patience patience() {
    return new Patience(point, gvh.plat.moat.parameters().robotRadiusMm());
  }

  private List<Object> results() {
    List<Object> results = new ArrayList<>();
    board.winners().forEach(winner -> results.add(winner.name()));
    Set<RobotId> unconfirmed = board.unconfirmed();
    if (!unconfirmed.isEmpty()) {
      results.add("not confirmed by " + unconfirmed);
    }
    return results;
  }
}
