package org.starl.apps.maze.logic;

import java.util.List;
import java.util.stream.Collectors;
import org.starl.GlobalVarHolder;
import org.starl.geometry.RegionText;
import org.starl.gvh.GvhCell;
import org.starl.primitives.paths.Path;
import org.starl.trace.TraceEvent.Action;

/** How one robot in a maze appears in a trace. Strand only. */
public final class MazeTrace {

  /** {@code source} of the app's events. */
  public static final String SOURCE = "app";

  /** Variable: the {@link MazeApp.Location}. */
  public static final String LOCATION = "location";

  /** Variable: the name of the goal that the robot drives to; empty at the end. */
  public static final String TOWARD = "toward";

  /** Variable: the intended way, as x,y>x,y in whole mm; empty for none. */
  public static final String WAY = "way";

  /** Action: a goal's name, the {@link Answer}, the position's error bound in mm. */
  public static final String ANSWER = "answer";

  /** Action: a polygon that excludes the centre of every body that is wider by the margin. */
  public static final String MARK = "mark";

  private final GlobalVarHolder gvh;
  private final GvhCell<String> toward;
  private final GvhCell<String> way;

  MazeTrace(GlobalVarHolder gvh) {
    this.gvh = gvh;
    toward = gvh.variable(SOURCE, TOWARD, "");
    way = gvh.variable(SOURCE, WAY, "");
  }

  /** Whether it is this app's action of that name. */
  public static boolean is(Action action, String name) {
    return action.source().equals(SOURCE) && action.name().equals(name);
  }

  void toward(String goal) {
    toward.set(goal);
  }

  void way(Path path) {
    way.set(
        path.points().stream()
            .map(at -> Math.round(at.xMm()) + "," + Math.round(at.yMm()))
            .collect(Collectors.joining(">")));
  }

  void noWay() {
    way.set("");
  }

  void answer(Goal goal, Answer answer) {
    gvh.trace.action(SOURCE, ANSWER, goal.name(), answer, gvh.gps.errorMm());
  }

  /** Writes the marks that exclude a body that is wider by the margin. */
  void marks(List<Mark> marks) {
    Mark.places(marks, 1)
        .forEach(place -> gvh.trace.action(SOURCE, MARK, RegionText.format(place)));
  }
}
