package org.starl.apps.search.logic;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Point;
import org.starl.gvh.GvhCell;
import org.starl.id.RobotId;

/** A searcher with one planted bug, which a monitor must report. */
public final class BuggySearcher extends LogicThread {

  public enum Fault {
    /** Announces the thing without having been near it. */
    SEES_THROUGH_WALLS,
    /** Answers that nothing is there before any robot has searched. */
    DOES_NOT_LOOK,
    /** Gives up a room that it could enter. */
    IS_LAZY,
    /** Gives up a room because a robot is down that is not in the way. */
    IS_TIMID,
    /** Each robot ends with a different answer. */
    IS_STUBBORN,
    /** Leads, and leaves a room with a robot that has crashed. */
    FORGETS_THE_DEAD,
    /** Never ends. */
    NEVER_ENDS
  }

  private final Fault fault;
  private final GvhCell<String> duty;

  public BuggySearcher(GlobalVarHolder gvh, Fault fault) {
    super(gvh);
    this.fault = fault;
    duty = gvh.variable(SearchTrace.SOURCE, SearchTrace.DUTY, "");
  }

  @Override
  public List<Object> callStarL() {
    RobotId me = gvh.id.name();
    boolean isFirst = me.equals(gvh.id.participants().asList().get(0));
    switch (fault) {
      case SEES_THROUGH_WALLS ->
          gvh.trace.action(SearchTrace.SOURCE, SearchTrace.FOUND, "object", 1, 2);
      case DOES_NOT_LOOK -> answer(Answer.NOTHING);
      case IS_LAZY -> answer(Answer.GAVE_UP + "A");
      case IS_TIMID -> {
        sleep(5_000);
        answer(Answer.GAVE_UP + "A");
      }
      case IS_STUBBORN -> answer(Answer.found("object", new Point(1, 2), me));
      case FORGETS_THE_DEAD -> {
        if (isFirst) {
          Map<String, String> rooms = new TreeMap<>();
          gvh.id.participants().forEach(robot -> rooms.put(robot.name(), "A"));
          duty.set("1 " + rooms.toString().replaceAll("[{},]", ""));
        }
        sleep(60_000);
      }
      case NEVER_ENDS -> await(() -> false);
    }
    return List.of();
  }

  private void answer(String answer) {
    gvh.trace.action(SearchTrace.SOURCE, SearchTrace.ANSWER, answer);
  }
}
