package org.starl.apps.maze.logic;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.RegionText;
import org.starl.gvh.GvhCell;
import org.starl.primitives.paths.Path;

/** How one robot in a maze appears in a trace. Strand only. */
public final class MazeTrace {

  /** {@code source} of the app's events. */
  public static final String SOURCE = "app";

  /** Variable: the {@link Location}. */
  public static final String LOCATION = "location";

  /** Variable: the name of the goal that the robot is after; empty at the end. */
  public static final String TOWARD = "toward";

  /** Variable: the way that it intends, as x,y>x,y in whole mm; empty for none. */
  public static final String WAY = "way";

  /** Action: a goal's name, the {@link Answer}, how well the robot knows its place in mm. */
  public static final String ANSWER = "answer";

  /** Action: a polygon in which no centre of a body can be that is wider by the margin. */
  public static final String MARK = "mark";

  private final GlobalVarHolder gvh;
  private final GvhCell<String> toward;
  private final GvhCell<String> way;

  MazeTrace(GlobalVarHolder gvh) {
    this.gvh = gvh;
    toward = gvh.variable(SOURCE, TOWARD, "");
    way = gvh.variable(SOURCE, WAY, "");
  }

  void toward(String goal) {
    toward.set(goal);
  }

  void way(Path path) {
    way.set(text(path));
  }

  void noWay() {
    way.set("");
  }

  void answer(Goal goal, Answer answer) {
    gvh.trace.action(SOURCE, ANSWER, goal.name(), answer, gvh.gps.errorMm());
  }

  /** Marks that prove something for a body that is wider by the margin; others are not told. */
  void marks(List<Mark> marks) {
    for (Mark mark : marks) {
      Polygon place = mark.place(1);
      if (place != null) {
        gvh.trace.action(SOURCE, MARK, RegionText.format(place));
      }
    }
  }

  private static String text(Path path) {
    StringBuilder text = new StringBuilder();
    for (Point point : path.points()) {
      text.append(text.length() == 0 ? "" : ">");
      text.append(Math.round(point.xMm())).append(',').append(Math.round(point.yMm()));
    }
    return text.toString();
  }
}
