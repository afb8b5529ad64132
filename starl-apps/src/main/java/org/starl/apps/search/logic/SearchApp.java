package org.starl.apps.search.logic;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.GvhCell;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.motion.MotionParameters;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.LocalPlanner;
import org.starl.primitives.paths.Tube;
import org.starl.primitives.paths.TubeSettings;

/**
 * A robot that searches a house with others (paper, section 5.4): a leader is elected and gives out
 * rooms; each robot drives to its room and sweeps it; who sees the thing says so; all end with one
 * {@link Answer}, which is what {@code callStarL} returns.
 *
 * <p>What it promises is in {@code org.starl.apps.search.spec}. Who starts anew begins without memory,
 * hears from the others what was searched, and is given a room again.
 */
public final class SearchApp extends LogicThread {

  /** Where the program stands. */
  public enum Location {
    ELECT,
    WAIT,
    GO,
    SWEEP,
    ANSWER,
    DONE
  }

  /** {@code source} of this app's trace events. */
  public static final String SOURCE = "app";

  /** Variable: the location. */
  public static final String LOCATION = "location";

  /** Variable: the room that this robot searches or is on its way to; empty for none. */
  public static final String ROOM = "room";

  /** Action: a thing was seen, with its place. */
  public static final String FOUND = "found";

  /** Action: the answer with which this robot ends. */
  public static final String ANSWER = "answer";

  /** Action: a room was searched in full. */
  public static final String SWEPT = Team.SWEPT;

  /** Action: a room and the legs of its sweep. */
  public static final String SWEEP = RoomSearch.SWEEP;

  /** Variable of a leader: its term, then who is to go where. */
  public static final String DUTY = Team.DUTY;

  private static final double GOAL_RADIUS_MM = 10;

  /** No way through a house is longer than so many times its width and height together. */
  private static final double WAY = 1;

  /** A way has corners, too. */
  private static final int SPARE_POINTS = 12;

  /** Most ways are within a room. */
  private static final double FIRST_LOOK_MM = 1_000;

  private static final double PLANNERS_CHORDS = 1.005;
  private static final double PLANNERS_ROUNDING_MM = 4;
  private static final long PERIOD_MS = 100;
  private static final long NS_PER_MS = 1_000_000;
  private static final long REST_AFTER_NS = 3_000 * NS_PER_MS;

  private final House house;
  private final Sensing sensing;
  private final Team team;
  private final Drive drive;
  private final Rest rest;
  private final GvhCell<Location> location;
  private final GvhCell<String> roomName;
  private @Nullable RoomSearch search;
  private long idleSinceNs;

  /**
   * @param xid names this search: robots with another one search elsewhere
   * @param house the same on every robot
   */
  public SearchApp(GlobalVarHolder gvh, String xid, House house, Sensing sensing) {
    super(gvh);
    this.house = house;
    this.sensing = sensing;
    location = gvh.variable(SOURCE, LOCATION, Location.ELECT);
    roomName = gvh.variable(SOURCE, ROOM, "");
    gvh.plat.moat.setParameters(motion(gvh.plat.moat.parameters()));
    team = new Team(gvh, xid, house);
    DistributedPathPlanning paths =
        new DistributedPathPlanning(
            gvh,
            xid,
            gvh.id.participants(),
            new FewerCorners(new LocalPlanner(FIRST_LOOK_MM)),
            house.bounds(),
            tubes(house.bounds()));
    drive = new Drive(gvh, paths);
    rest = new Rest(gvh, house, drive, team::isSwept);
  }

  /**
   * Tubes of a house: its longest ways fit one tube, of {@link Tube#MAX_POINTS}. The shorter their
   * parts are the narrower they can be; of up to a metre, robots may start 500 mm apart.
   */
  public static TubeSettings tubes(Rectangle bounds) {
    double longestMm =
        WAY * (bounds.xMaxMm() - bounds.xMinMm() + bounds.yMaxMm() - bounds.yMinMm());
    int legMm = (int) StrictMath.ceil(longestMm / (Tube.MAX_POINTS - SPARE_POINTS));
    return new TubeSettings(20, Math.max(1_000, legMm), 120_000, 200, 2_000, 500, 4_000);
  }

  /** How searchers move whose bodies are like that. */
  public static MotionParameters motion(MotionParameters body) {
    return body.toBuilder().goalRadiusMm(GOAL_RADIUS_MM).build();
  }

  /** How far from every wall such a searcher's centre stays: its tube's radius, what its planner spends on
   * fewer corners, and rounding. */
  public static double clearanceMm(MotionParameters body, Rectangle bounds) {
    double radiusMm = DistributedPathPlanning.radiusMm(motion(body), tubes(bounds));
    return (radiusMm + FewerCorners.SPARE_MM) * PLANNERS_CHORDS + PLANNERS_ROUNDING_MM;
  }

  @Override
  public List<Object> callStarL() {
    team.begin();
    while (location.get() != Location.DONE) {
      look();
      team.work();
      if (team.isDecided()) {
        location.set(Location.DONE);
        break;
      }
      if (team.answer().isPresent() && location.get() != Location.ANSWER) {
        leave(Location.ANSWER);
      }
      switch (location.get()) {
        case ELECT -> {
          if (team.hasLeader()) {
            waitFrom(Location.WAIT);
          }
        }
        case WAIT -> {
          Optional<Room> task = gvh.gps.hasFix() ? team.takeTask() : Optional.empty();
          if (task.isPresent()) {
            search = new RoomSearch(gvh, house, task.get(), team.seenOf(task.get()), drive);
            roomName.set(task.get().name());
            location.set(Location.GO);
          } else if (gvh.plat.clock.nowNs() - idleSinceNs > REST_AFTER_NS) {
            rest.step();
          }
        }
        case GO, SWEEP -> sweep();
        case ANSWER -> {
          // Until all have agreed on it.
        }
        case DONE -> throw new IllegalStateException("the loop has ended");
      }
      sleep(PERIOD_MS);
    }
    drive.stop();
    team.tellTheEnd();
    gvh.trace.action(SOURCE, ANSWER, team.decision());
    return returnResults();
  }

  @Override
  protected List<Object> returnResults() {
    return List.of(team.decision());
  }

  /** Reads the sensor; what it shows is seen from where the robot is now. */
  private void look() {
    if (!gvh.gps.hasFix()) {
      return;
    }
    for (ItemPosition thing : sensing.sensed()) {
      if (team.answer().isEmpty()) {
        Point at = thing.at();
        int xMm = (int) Math.round(at.xMm());
        int yMm = (int) Math.round(at.yMm());
        gvh.trace.action(SOURCE, FOUND, thing.name(), xMm, yMm);
        team.conclude(new Answer.Found(thing.name(), xMm, yMm, gvh.id.name().name()));
      }
    }
    if (search != null) {
      search.look();
      team.saw(search.seen());
    }
  }

  private void sweep() {
    RoomSearch now = search;
    if (now == null) {
      throw new IllegalStateException(location.get() + " without a room");
    }
    if (team.isSwept(now.room())) {
      team.leaveRoom(); // somebody who was taken for dead has done it
      leave(Location.WAIT);
      return;
    }
    switch (now.step()) {
      case GOING -> location.set(Location.GO);
      case SWEEPING -> location.set(Location.SWEEP);
      case SWEPT -> {
        team.sweptRoom();
        leave(Location.WAIT);
      }
      case BLOCKED -> {
        team.failedRoom();
        leave(Location.WAIT);
      }
    }
  }

  private void leave(Location next) {
    drive.stop();
    search = null;
    roomName.set("");
    waitFrom(next);
  }

  private void waitFrom(Location next) {
    idleSinceNs = gvh.plat.clock.nowNs();
    rest.begin();
    location.set(next);
  }
}
