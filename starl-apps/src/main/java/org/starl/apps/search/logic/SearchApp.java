package org.starl.apps.search.logic;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.gvh.GvhCell;
import org.starl.platform.Sighting;
import org.starl.trace.Instance;

/**
 * A robot that searches a house with others (paper, section 5.4). The robots elect a leader; the
 * leader assigns rooms; each robot drives to its room and sweeps it; a robot that sees the thing
 * announces it; all end with one {@link Answer}, which {@code callStarL} returns.
 *
 * <p>{@code org.starl.apps.search.spec} specifies it. A robot that restarts begins without memory,
 * hears from the others what was searched, and is assigned a room again.
 */
public final class SearchApp extends LogicThread {

  /** The state of the program. */
  public enum Location {
    ELECT,
    WAIT,
    GO,
    SWEEP,
    ANSWER,
    DONE
  }

  private static final long PERIOD_MS = 100;
  private static final long PARK_AFTER_NS = 3_000_000_000L;

  private final House house;
  private final Team team;
  private final Drive drive;
  private final Parking parking;
  private final GvhCell<Location> location;
  private final GvhCell<String> roomName;
  private @Nullable RoomSearch search;
  private long idleSinceNs;

  /**
   * @param xid the name of the search: robots with another one take part in another search
   * @param house the same on every robot; its range is that of every robot's object sensor
   */
  public SearchApp(GlobalVarHolder gvh, String xid, House house) {
    super(gvh);
    gvh.plat.objects.require(house.rangeMm());
    this.house = house;
    location = gvh.variable(SearchFact.LOCATION, Location.ELECT);
    roomName = gvh.variable(SearchFact.ROOM, "");
    team = new Team(gvh, xid, house);
    drive = new Drive(gvh, xid, house.bounds());
    parking = new Parking(gvh, house, drive, team::isSwept);
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
      if (team.hasAnswer() && location.get() != Location.ANSWER) {
        leave(Location.ANSWER);
      }
      switch (location.get()) {
        case ELECT -> {
          if (team.hasLeader()) {
            waitIn(Location.WAIT);
          }
        }
        case WAIT -> takeRoomOrPark();
        case GO, SWEEP -> sweep();
        case ANSWER -> {
          // Until the robots have agreed on it.
        }
        case DONE -> throw new IllegalStateException("the loop has ended");
      }
      sleep(PERIOD_MS);
    }
    drive.stop();
    team.tellDecision();
    write(new SearchFact.Ended(team.decision()));
    return returnResults();
  }

  @Override
  protected List<Object> returnResults() {
    return List.of(team.decision());
  }

  /**
   * Reads the sensor: a thing in view ends the search; else the robot has seen more of its room.
   */
  private void look() {
    if (gvh.gps.hasFix()) {
      for (Sighting thing : gvh.plat.objects.sensed()) {
        if (!team.hasAnswer()) {
          write(SearchFact.Found.of(thing, gvh.gps.errorMm()));
          team.conclude(Answer.found(thing.name(), thing.at(), gvh.id.name()));
        }
      }
    }
    if (search != null) {
      search.look();
      team.known().saw(search.room().index(), search.seen());
    }
  }

  private void write(SearchFact fact) {
    gvh.trace.action(Instance.APP, SearchFact.SHAPE, fact);
  }

  private void takeRoomOrPark() {
    Optional<Room> task = gvh.gps.hasFix() ? team.takeTask() : Optional.empty();
    if (task.isPresent()) {
      Room room = task.get();
      search = new RoomSearch(gvh, house, room, team.known().seen(room.index()), drive);
      roomName.set(room.name());
      location.set(Location.GO);
    } else if (gvh.plat.clock.nowNs() - idleSinceNs > PARK_AFTER_NS) {
      parking.step();
    }
  }

  private void sweep() {
    RoomSearch now = search;
    if (now == null) {
      throw new IllegalStateException(location.get() + " without a room");
    }
    if (team.isSwept(now.room())) {
      team.leaveRoom(); // a robot that seemed to be dead has searched it
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
    waitIn(next);
  }

  private void waitIn(Location next) {
    idleSinceNs = gvh.plat.clock.nowNs();
    parking.begin();
    location.set(next);
  }
}
