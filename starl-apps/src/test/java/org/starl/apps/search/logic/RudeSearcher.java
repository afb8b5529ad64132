package org.starl.apps.search.logic;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.gvh.GvhCell;
import org.starl.id.RobotId;

/** A searcher that does one thing wrong: what is checked of a search must see it. */
public final class RudeSearcher extends LogicThread {

  /** What it does wrong. */
  public enum Fault {
    /** It has found the thing without having been there. */
    SEES_THROUGH_WALLS,
    /** It says that nothing is there before anybody has looked. */
    DOES_NOT_LOOK,
    /** It gives rooms up that it could get into. */
    IS_LAZY,
    /** It gives rooms up because somebody is down, who is not in the way. */
    IS_TIMID,
    /** Each ends with an answer of its own. */
    IS_STUBBORN,
    /** It leads, and leaves a room with a robot that has crashed. */
    FORGETS_THE_DEAD,
    /** It never ends. */
    NEVER_ENDS
  }

  private final Fault fault;
  private final GvhCell<String> duty;

  public RudeSearcher(GlobalVarHolder gvh, Fault fault) {
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
      case DOES_NOT_LOOK -> answer(new Answer.Nothing());
      case IS_LAZY -> answer(new Answer.GaveUp(List.of("A")));
      case IS_TIMID -> {
        sleep(5_000);
        answer(new Answer.GaveUp(List.of("A")));
      }
      case IS_STUBBORN -> answer(new Answer.Found("object", 1, 2, me.name()));
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

  private void answer(Answer answer) {
    gvh.trace.action(SearchTrace.SOURCE, SearchTrace.ANSWER, answer);
  }
}
