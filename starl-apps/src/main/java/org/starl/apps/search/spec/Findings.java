package org.starl.apps.search.spec;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.search.logic.Answer;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.Room;
import org.starl.apps.search.logic.SearchTrace;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/** {@code found}, {@code nothing} and {@code gave_up}: what robots say is so, in truth. */
final class Findings implements Monitor {

  private static final String FOUND = "found";
  private static final String NOTHING = "nothing";
  private static final String GAVE_UP = "gave_up";

  /** Things are told in whole mm. */
  private static final double ROUNDING_MM = 1;

  private final House house;
  private final List<ItemPosition> things;
  private final TrueView view;
  private final Reach reach;

  Findings(House house, List<ItemPosition> things) {
    this.house = house;
    this.things = List.copyOf(things);
    view = new TrueView(house);
    reach = new Reach(house);
  }

  @Override
  public List<String> lemmas() {
    return List.of(FOUND, NOTHING, GAVE_UP);
  }

  @Override
  public String says(String lemma) {
    return switch (lemma) {
      case FOUND ->
          "A robot that says it has found a thing sees it, and the thing is where it says.";
      case NOTHING ->
          "\"Nothing there\" is said only when every place of every room was truly seen.";
      case GAVE_UP ->
          "A room is given up only if robots that are down bar some of it, or none can get in.";
      default -> "";
    };
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    view.observe(event);
    reach.observe(event);
    if (event instanceof Action action && action.source().equals(SearchTrace.SOURCE)) {
      if (action.name().equals(SearchTrace.FOUND)) {
        checkFound(action, report);
      } else if (action.name().equals(SearchTrace.ANSWER)) {
        checkAnswer(action, action.args().get(0), report);
      }
    }
  }

  private void checkFound(Action action, Report report) {
    report.checked(FOUND);
    RobotId robot = action.robot();
    double xMm = Double.parseDouble(action.args().get(1));
    Point told = new Point(xMm, Double.parseDouble(action.args().get(2)));
    Point at = view.isOnFloor(robot) ? view.at(robot, action.timeNs()) : null;
    for (ItemPosition thing : things) {
      boolean isIt =
          thing.name().equals(action.args().get(0)) && thing.at().distanceMm(told) <= ROUNDING_MM;
      if (isIt
          && at != null
          && at.distanceMm(thing.at()) <= house.rangeMm() + ROUNDING_MM
          && house.sight().sees(at, thing.at())) {
        return;
      }
    }
    report.violated(
        FOUND,
        action.timeNs(),
        List.of(robot),
        "says that it sees " + action.args() + ", and is at " + at);
  }

  private void checkAnswer(Action action, String answer, Report report) {
    if (answer.equals(Answer.NOTHING)) {
      checkNothing(action, report);
    } else if (answer.startsWith(Answer.GAVE_UP)) {
      checkGaveUp(
          action, List.of(answer.substring(Answer.GAVE_UP.length()).split(" ", -1)), report);
    }
  }

  private void checkNothing(Action action, Report report) {
    report.checked(NOTHING);
    int missed = view.missed();
    if (missed >= 0) {
      Point at = house.grid().centre(missed);
      report.violated(
          NOTHING,
          action.timeNs(),
          List.of(action.robot()),
          "nobody has had (" + at.xMm() + ", " + at.yMm() + ") mm in range and sight");
      return;
    }
    for (ItemPosition thing : things) {
      if (house.roomAt(thing.at()) >= 0 && house.canBeSeen(house.grid().cellAt(thing.at()))) {
        report.violated(
            NOTHING, action.timeNs(), List.of(action.robot()), thing.name() + " is there");
      }
    }
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
      boolean isLeft = rooms.contains(room.name());
      if (isLeft && room.isEnterable() && reach.isInReach(room, up, action.timeNs())) {
        report.violated(
            GAVE_UP,
            action.timeNs(),
            List.of(action.robot()),
            "no robot that is down bars anything of room " + room.name());
      }
    }
  }
}
