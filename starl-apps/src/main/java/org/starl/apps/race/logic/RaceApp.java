package org.starl.apps.race.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.gvh.GvhCell;
import org.starl.motion.Location.Known;

/**
 * One robot in a race. It drives to the first point that it knows of nobody to have won; whoever is
 * there first says so to all, and all stop and take the next one. Who bumps into somebody turns away
 * until nothing is in front and drives on (the motion automaton's {@code USE_COLAVOID}); who comes no
 * nearer that way drives to a place near by, drawn at random, and tries again: robots that get into
 * each other's way again and again do not do so for ever. What lies between two sleeps is one atomic
 * action.
 */
public final class RaceApp extends LogicThread {

  /** Where the program is. */
  public enum Location {
    START,
    PICK,
    RACE,
    MAKE_WAY,
    TELL,
    DONE
  }

  /** Who has not acknowledged the winners after so long is taken for dead. */
  public static final long TELL_PATIENCE_MS = 90_000;

  private static final long PERIOD_MS = 100;
  private static final long NS_PER_MS = 1_000_000;
  private static final long MAKE_WAY_MS = 3_000;

  private final List<RacePoint> points;
  private final Drive drive;
  private final Scoreboard board;
  private final RightOfWay way;
  private final GvhCell<Location> location;
  private final GvhCell<String> racingTo;

  private int point;
  private Patience patience;
  private long sinceNs;

  /**
   * @param xid the race: robots with another one are in another race
   * @param points at least one, in the order in which they are raced to
   */
  public RaceApp(GlobalVarHolder gvh, String xid, List<RacePoint> points) {
    super(gvh);
    this.points = List.copyOf(points);
    drive = new Drive(gvh);
    location = gvh.variable(RaceTrace.SOURCE, RaceTrace.LOCATION, Location.START);
    racingTo = gvh.variable(RaceTrace.SOURCE, RaceTrace.POINT, "");
    board = new Scoreboard(gvh, xid, points, RaceTrace.SOURCE);
    way = new RightOfWay(gvh, xid);
    patience = new Patience(points.get(0), bodyMm());
  }

  /** Returns the name of each point's winner, in the points' order, and then who may not know. */
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
          if (board.isConfirmed() || hasLasted(TELL_PATIENCE_MS)) {
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
    point = board.next();
    if (point == points.size()) {
      racingTo.set("");
      enter(Location.TELL);
      return;
    }
    racingTo.set(points.get(point).name());
    patience = new Patience(points.get(point), bodyMm());
    drive();
  }

  private void drive() {
    drive.to(points.get(point));
    enter(Location.RACE);
  }

  private void race() {
    if (board.isTaken(point)) {
      location.set(Location.PICK);
    } else if (gvh.gps.location() instanceof Known known) {
      double distanceMm = known.pose().distanceMm(points.get(point).at());
      if (drive.isAt(points.get(point), known)) {
        arrive(0); // also in the midst of turning away from somebody
      } else if (gvh.plat.moat.failed()) {
        inVain(distanceMm);
      } else if (!gvh.plat.moat.inMotion()) {
        drive(); // a fix has shown that it is not quite there
      } else if (way.isOthers(point)) {
        giveWay(distanceMm);
      }
    }
  }

  private void inVain(double distanceMm) {
    if (patience.isEnough(distanceMm)) {
      arrive((int) Math.ceil(distanceMm));
    } else if (way.isOthers(point)) {
      giveWay(distanceMm);
    } else if (way.hasAsked()) {
      drawBack();
    } else {
      way.ask(point, points.get(point).at(), distanceMm);
      drive();
    }
  }

  /** Unless this robot is nearer, and has not had its turn. */
  private void giveWay(double distanceMm) {
    if (way.hasAsked() || !way.isNearer(distanceMm)) {
      drawBack();
    } else {
      way.ask(point, points.get(point).at(), distanceMm);
      if (!gvh.plat.moat.inMotion()) {
        drive();
      }
    }
  }

  private void makeWay() {
    if (board.isTaken(point)) {
      location.set(Location.PICK);
    } else if (!way.isOthers(point) && hasLasted(MAKE_WAY_MS)) {
      drive();
    } else if (gvh.plat.moat.failed()) {
      drive.backFrom(points.get(point));
    }
  }

  private void arrive(int keptOffMm) {
    RaceTrace.arrive(gvh, point, points.get(point), keptOffMm);
    board.claim(point, keptOffMm);
    location.set(Location.PICK);
  }

  private void drawBack() {
    drive.backFrom(points.get(point));
    enter(Location.MAKE_WAY);
  }

  private void enter(Location next) {
    location.set(next);
    sinceNs = gvh.plat.clock.nowNs();
  }

  private boolean hasLasted(long ms) {
    return gvh.plat.clock.nowNs() - sinceNs >= ms * NS_PER_MS;
  }

  private double bodyMm() {
    return gvh.plat.moat.parameters().robotRadiusMm();
  }

  private List<Object> results() {
    List<Object> results = new ArrayList<>();
    board.claims().forEach(claim -> results.add(claim.winner().name()));
    if (!board.isConfirmed()) {
      results.add("not confirmed by " + board.unconfirmed());
    }
    return results;
  }
}
