package org.starl.apps.race.logic;

import java.util.List;
import java.util.TreeMap;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.gvh.GvhCell;
import org.starl.primitives.geocast.Broadcast;

/** A racer without the scoreboard, with one planted bug. */
public final class BuggyRacer extends LogicThread {

  public enum Bug {
    /** Claims its point when it sets out for it. */
    CLAIMS_FROM_AFAR,
    /** Replaces the winner in each claim that it hears by the robot with the first name. */
    ANNOUNCES_ANOTHER_WINNER,
    /** Takes the claim that it hears last. */
    LAST_HEARD_COUNTS,
    /** Takes the claim that it hears first. */
    FIRST_HEARD_COUNTS,
    /** Announces nothing. */
    ANNOUNCES_NOTHING,
    /** Drives to each point, taken or not, and arrives there. */
    RACES_ON,
    /** Is done at once. */
    DOES_NOT_WAIT,
    /** Draws back for a moment. */
    MAKES_WAY_BRIEFLY,
    /** Stands still. */
    DOES_NOT_DRIVE
  }

  private final List<RacePoint> points;
  private final Bug bug;
  private final Broadcast<RaceMessage> broadcast;
  private final GvhCell<RaceApp.Location> location;
  private final TreeMap<Integer, Claim> best = new TreeMap<>();

  public BuggyRacer(GlobalVarHolder gvh, List<RacePoint> points, Bug bug) {
    super(gvh);
    this.points = points;
    this.bug = bug;
    location = gvh.variable(RaceFact.LOCATION, RaceApp.Location.RACE);
    broadcast =
        new Broadcast<>(
            gvh,
            "race",
            RaceMessage.shape(points.size()),
            (from, message) -> heard((Claim) message),
            Scoreboard.SETTINGS);
  }

  @Override
  public List<Object> callStarL() {
    await(gvh.gps::hasFix);
    for (int i = 0; i < points.size(); i++) {
      int point = i;
      RacePoint next = points.get(i);
      if (bug != Bug.DOES_NOT_DRIVE) {
        gvh.plat.moat.setParameters(Drive.motion(gvh.plat.moat.parameters(), next));
        gvh.plat.moat.doMove(new ItemPosition(next.name(), next.at().xMm(), next.at().yMm()));
      }
      if (bug == Bug.MAKES_WAY_BRIEFLY) {
        location.set(RaceApp.Location.MAKE_WAY);
        sleep(100);
        location.set(RaceApp.Location.RACE);
      }
      while ((!best.containsKey(point) || bug == Bug.RACES_ON)
          && gvh.gps.pose().distanceMm(next.at()) > next.radiusMm()
          && bug != Bug.CLAIMS_FROM_AFAR) {
        sleep(100);
      }
      if (!best.containsKey(point) || bug == Bug.RACES_ON) {
        arrive(point, next);
      }
    }
    location.set(RaceApp.Location.TELL);
    if (bug != Bug.DOES_NOT_WAIT) {
      sleep(10_000);
    }
    location.set(RaceApp.Location.DONE);
    return List.of();
  }

  private void arrive(int point, RacePoint next) {
    gvh.trace.action(
        RaceFact.Arrived.SHAPE, new RaceFact.Arrived(point, next.name(), 0, 0, next.radiusMm()));
    Claim claim = new Claim(point, gvh.id.name(), gvh.plat.clock.nowNs(), 0);
    record(claim);
    if (bug != Bug.ANNOUNCES_NOTHING) {
      broadcast.BCast(claim, 5_000);
    }
  }

  private void heard(Claim claim) {
    Claim mine = best.get(claim.point());
    switch (bug) {
      case LAST_HEARD_COUNTS -> record(claim);
      case ANNOUNCES_ANOTHER_WINNER ->
          record(new Claim(claim.point(), gvh.id.participants().asList().get(0), claim.atNs(), 0));
      case FIRST_HEARD_COUNTS -> {
        if (mine == null) {
          record(claim);
        }
      }
      default -> {
        if (mine == null || claim.compareTo(mine) < 0) {
          record(claim);
        }
      }
    }
  }

  private void record(Claim claim) {
    best.put(claim.point(), claim);
    gvh.trace.action(RaceFact.Taken.SHAPE, RaceFact.Taken.of(claim, points.get(claim.point())));
  }
}
