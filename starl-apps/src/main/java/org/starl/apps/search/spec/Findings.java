package org.starl.apps.search.spec;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.starl.apps.search.logic.Answer;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.Room;
import org.starl.apps.search.logic.SearchFact;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.spec.InstanceMonitor;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/** {@code found}, {@code swept}, {@code nothing} and {@code gave_up}: what robots announce is true. */
final class Findings extends InstanceMonitor<Findings> {

  private static final String FOUND = "search.found";
  private static final String SWEPT = "search.swept";
  private static final String NOTHING = "search.nothing";
  private static final String GAVE_UP = "search.gave_up";

  /** Places of things are told in whole mm. */
  private static final double ROUNDING_MM = 1;

  private final House house;
  private final List<ItemPosition> things;
  private final TrueView view;
  private final Reach reach;

  /**
   * @param staysDown whether a robot may crash for good
   */
  Findings(House house, List<ItemPosition> things, boolean staysDown) {
    super(Instance.APP.kind());
    this.house = house;
    this.things = List.copyOf(things);
    view = new TrueView(house);
    reach = new Reach(house);
    lemma(
        FOUND,
        "A robot that announces a thing has it in range and sight, and tells its true place.");
    lemma(SWEPT, "A room is told to be searched only when every place of it was truly seen.");
    lemma(
        NOTHING,
        "\"Nothing there\" is announced only when every place of every room was truly seen.");
    lemma(
        GAVE_UP,
        "A room is given up only if robots that are down bar some of it, or no robot can enter.");
    if (!staysDown) {
      never(GAVE_UP, "every robot that crashes restarts, and bars no room for good");
    }
    if (this.things.isEmpty()) {
      never(FOUND, "there is no object");
    } else {
      never(NOTHING, "an object is there");
    }
  }

  @Override
  protected Findings begin(Instance source) {
    return this;
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    view.observe(event);
    reach.observe(event);
    super.observe(event, report);
  }

  @Override
  protected void acted(Action action, Report report) {
    if (action.fact() instanceof SearchFact.Found found) {
      checkFound(action, found, report);
    } else if (action.fact() instanceof SearchFact.Swept swept) {
      report.checked(SWEPT);
      house.rooms().stream()
          .filter(room -> room.name().equals(swept.room()))
          .forEach(room -> notSeen(SWEPT, action, view.missed(room), report));
    } else if (action.fact() instanceof SearchFact.Ended ended) {
      switch (ended.answer()) {
        case Answer.Nothing nothing -> checkNothing(action, report);
        case Answer.GaveUp gaveUp -> checkGaveUp(action, gaveUp.rooms(), report);
        case Answer.Found found -> {
          // Checked when its finder announced it.
        }
      }
    }
  }

  private void checkFound(Action action, SearchFact.Found found, Report report) {
    report.checked(FOUND);
    RobotId robot = action.robot();
    // A real sensor and a real position have errors.
    double offMm = ROUNDING_MM + found.withinMm();
    Point at = view.robots().contains(robot) ? view.at(robot, action.timeNs()) : null;
    for (ItemPosition thing : things) {
      if (thing.name().equals(found.thing())
          && thing.at().distanceMm(found.at()) <= offMm
          && at != null
          && at.distanceMm(thing.at()) <= house.rangeMm() + offMm
          && maySee(at, thing.at(), found.withinMm() > 0 ? offMm : 0)) {
        return;
      }
    }
    violated(FOUND, action, "announces " + action.args() + ", and is at " + at, report);
  }

  /** Whether one point within {@code offMm} of {@code at} along each axis sees {@code thing}. */
  private boolean maySee(Point at, Point thing, double offMm) {
    return Stream.of(
            new Point(0, 0), new Point(1, 1), new Point(1, -1), new Point(-1, 1), new Point(-1, -1))
        .anyMatch(corner -> house.sight().sees(at.plus(corner.times(offMm)), thing));
  }

  private void checkNothing(Action action, Report report) {
    report.checked(NOTHING);
    if (notSeen(NOTHING, action, view.missed(), report)) {
      return;
    }
    for (ItemPosition thing : things) {
      if (house.roomAt(thing.at()) >= 0 && house.canBeSeen(house.grid().cellAt(thing.at()))) {
        violated(NOTHING, action, thing.name() + " is there", report);
      }
    }
  }

  /** @param missed a cell, or -1 for none; returns whether there is one */
  private boolean notSeen(String lemma, Action action, int missed, Report report) {
    if (missed >= 0) {
      Point at = house.grid().centre(missed);
      String where = "(" + at.xMm() + ", " + at.yMm() + ") mm";
      violated(lemma, action, "no robot has had " + where + " in range and sight", report);
    }
    return missed >= 0;
  }

  private void checkGaveUp(Action action, List<String> rooms, Report report) {
    report.checked(GAVE_UP);
    List<Point> up = new ArrayList<>();
    for (RobotId robot : view.robots()) {
      if (reach.isUp(robot)) {
        up.add(view.at(robot, action.timeNs()));
      }
    }
    for (Room room : house.rooms()) {
      if (rooms.contains(room.name())
          && room.isEnterable()
          && reach.isInReach(room, up, action.timeNs())) {
        violated(
            GAVE_UP, action, "no robot that is down bars anything of room " + room.name(), report);
      }
    }
  }

  private static void violated(String lemma, Action action, String detail, Report report) {
    report.violated(lemma, action.timeNs(), List.of(action.robot()), detail);
  }
}
