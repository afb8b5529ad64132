package org.starl.apps.maze.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.primitives.paths.LocalPlanner;
import org.starl.primitives.paths.Path;
import org.starl.primitives.paths.Plan;
import org.starl.primitives.paths.PlanTask;

/**
 * Searches a way, with a robot's knowledge. Immutable, so it can run off the strand.
 *
 * @param map the obstacles that are known beforehand
 * @param marks proven by contacts
 * @param from the robot's position
 * @param bodyMm radius of its body
 */
record Search(
    MazeTask task, Obstacles map, List<Mark> marks, Point from, Point goal, double bodyMm) {

  private static final LocalPlanner PLANNER = new LocalPlanner();

  // A way may begin so far from the robot if the robot stands nearer to something than a way may
  // lead.
  private static final int SLACK_MM = 150;

  // The planner may round this much of a margin away.
  private static final double PLANNER_MM = 6;

  // Parts of the margin; less than all for a robot that is where a wider body does not fit.
  private static final List<Double> PARTS = List.of(1.0, 0.5, 0.0);
  private static final List<Double> NARROWER = PARTS.subList(1, 3);

  private static final List<Double> WIDE = PARTS.subList(0, 1);

  // A wall is longer than what was felt of it: of ways that fit the margin, one that stays three
  // margins away from what was touched comes first.
  private static final List<Double> FAR_FIRST = List.of(3.0, 1.0);

  Search {
    marks = List.copyOf(marks);
  }

  /** The result of a search. */
  sealed interface Outcome {

    /** A way; a narrow one leads through gaps that fit the body, but not the margin. */
    record Way(Path path, boolean isNarrow) implements Outcome {}

    /** Proven: there is no way from the start for a body that is wider by the margin. */
    record NoWay() implements Outcome {}

    /** There may be a way from the start, but none was found from here. */
    record Lost() implements Outcome {}
  }

  /** A way, or the proof that there is none. */
  Outcome anywhere() {
    Outcome wide = search(List.of(), wide());
    if (wide instanceof Outcome.Way) {
      return wide;
    }
    // The robot may be where a wider body does not fit; no way from there proves nothing.
    return isCutOff() ? new Outcome.NoWay() : search(List.of(), NARROWER);
  }

  /** A robot that drives along what it has touched is too near to it to keep away. */
  private List<Double> wide() {
    return task.mode() == CollisionMode.DISCOVER ? WIDE : FAR_FIRST;
  }

  /** A way outside of {@code forbidden}; if there is none, a way anywhere, or the proof. */
  Outcome onward(List<Polygon> forbidden) {
    Outcome inside = search(forbidden, wide());
    return inside instanceof Outcome.Way ? inside : anywhere();
  }

  /** A way outside of {@code forbidden}, through narrow gaps if necessary. */
  Outcome back(List<Polygon> forbidden) {
    return search(forbidden, PARTS);
  }

  /** The first way that is found for one of these parts of the margin, tried in turn. */
  private Outcome search(List<Polygon> forbidden, List<Double> parts) {
    for (double part : parts) {
      if (PLANNER.planFromNear(planTask(from, part, forbidden), SLACK_MM)
          instanceof Plan.Found found) {
        List<Point> points = new ArrayList<>(found.path().points());
        points.add(0, from);
        return new Outcome.Way(new Path(points), part < 1);
      }
    }
    return new Outcome.Lost();
  }

  /**
   * Whether there is no way from the start, with as much of the margin as fits around the start.
   */
  private boolean isCutOff() {
    for (double part : PARTS) {
      Plan plan = PLANNER.plan(planTask(task.start(), part, List.of()));
      boolean isStartBlocked = plan instanceof Plan.Blocked at && at.end() == Plan.End.START;
      if (!isStartBlocked) {
        return !(plan instanceof Plan.Found);
      }
    }
    return false;
  }

  private PlanTask planTask(Point start, double part, List<Polygon> forbidden) {
    List<Polygon> keepOut = new ArrayList<>(Mark.places(marks, part));
    keepOut.addAll(forbidden);
    double clearanceMm = Math.max(0, Math.min(1, part) * MazeTask.MARGIN_MM - PLANNER_MM);
    return new PlanTask(
        start, goal, task.floor(), map, task.others(), keepOut, bodyMm, clearanceMm);
  }
}
