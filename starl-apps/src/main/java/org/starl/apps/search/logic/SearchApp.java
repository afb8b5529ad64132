package org.starl.apps.search.logic;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.gvh.GvhCell;

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

  private static final long PERIOD_MS = 100;
  private static final long NS_PER_MS = 1_000_000;
  private static final long REST_AFTER_NS = 3_000 * NS_PER_MS;

  private final House house;
  private final Team team;
  private final Lookout lookout;
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
    location = gvh.variable(SearchTrace.SOURCE, SearchTrace.LOCATION, Location.ELECT);
    roomName = gvh.variable(SearchTrace.SOURCE, SearchTrace.ROOM, "");
    team = new Team(gvh, xid, house);
    lookout = new Lookout(gvh, sensing, team);
    drive = new Drive(gvh, Driving.paths(gvh, xid, house.bounds()));
    rest = new Rest(gvh, house, drive, team::isSwept);
  }

  @Override
  public List<Object> callStarL() {
    team.begin();
    while (location.get() != Location.DONE) {
      lookout.look();
      if (search != null) {
        search.look();
        team.saw(search.seen());
      }
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
    gvh.trace.action(SearchTrace.SOURCE, SearchTrace.ANSWER, team.decision());
    return returnResults();
  }

  @Override
  protected List<Object> returnResults() {
    return List.of(team.decision());
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
