package org.starl.apps.search.logic;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Point;
import org.starl.gvh.GvhCell;
import org.starl.id.RobotId;
import org.starl.trace.Instance;

/** A searcher with one planted bug, which a monitor must report. */
public final class BuggySearcher extends LogicThread {

  public enum Fault {
    /** Announces the thing without having been near it. */
    SEES_THROUGH_WALLS,
    /** Tells that a room was searched, and that nothing is there, before any robot has searched. */
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
  private final GvhCell<SearchFact.Assigned> duty;

  public BuggySearcher(GlobalVarHolder gvh, Fault fault) {
    super(gvh);
    this.fault = fault;
    duty = gvh.variable(SearchFact.DUTY, SearchFact.Assigned.NONE);
  }

  @Override
  public List<Object> callStarL() {
    RobotId me = gvh.id.name();
    boolean isFirst = me.equals(gvh.id.participants().asList().get(0));
    switch (fault) {
      case SEES_THROUGH_WALLS -> write(new SearchFact.Found("object", 1, 2, 0));
      case DOES_NOT_LOOK -> {
        write(new SearchFact.Swept("A"));
        answer(Answer.NOTHING);
      }
      case IS_LAZY -> answer(new Answer.GaveUp(List.of("A")));
      case IS_TIMID -> {
        sleep(5_000);
        answer(new Answer.GaveUp(List.of("A")));
      }
      case IS_STUBBORN -> answer(Answer.found("object", new Point(1, 2), me));
      case FORGETS_THE_DEAD -> {
        if (isFirst) {
          SortedMap<RobotId, String> rooms = new TreeMap<>();
          gvh.id.participants().forEach(robot -> rooms.put(robot, "A"));
          duty.set(new SearchFact.Assigned(1, rooms));
        }
        sleep(60_000);
      }
      case NEVER_ENDS -> await(() -> false);
    }
    return List.of();
  }

  private void answer(Answer answer) {
    write(new SearchFact.Ended(answer));
  }

  private void write(SearchFact fact) {
    gvh.trace.action(Instance.APP, SearchFact.SHAPE, fact);
  }
}
