package org.starl.apps.maze.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.primitives.paths.Capsule;
import org.starl.primitives.paths.LocalPlanner;
import org.starl.primitives.paths.Path;
import org.starl.primitives.paths.Plan;
import org.starl.primitives.paths.PlanTask;

/**
 * Searches a way, with a robot's knowledge. Immutable, so it can run off the strand.
 *
 * @param map the obstacles that are known beforehand
 * @param marks proven by contacts
 * @param taken the tubes of other robots
 * @param tubeMm half the width of its own tube
 * @param from the robot's position
 * @param bodyMm radius of its body
 */
record Search(
    MazeTask task,
    Obstacles map,
    List<Mark> marks,
    List<Capsule> taken,
    double tubeMm,
    Point from,
    Point goal,
    double bodyMm) {

  private static final double FIRST_LOOK_MM = 6_000;
  private static final LocalPlanner PLANNER = new LocalPlanner(FIRST_LOOK_MM);

  // A way may begin so far from the robot if the robot stands nearer to something than a way may
  // lead.
  private static final int SLACK_MM = 150;

  // The planner may round this much of a margin away.
  private static final double PLANNER_MM = 6;

  // Parts of the margin; less than all for a robot that is where a wider body does not fit.
  private static final List<Double> PARTS = List.of(1.0, 0.5, 0.0);
  private static final List<Double> WIDE = PARTS.subList(0, 1);
  private static final List<Double> NARROWER = PARTS.subList(1, 3);

  // Tubes are rounded to whole mm, and must not touch.
  private static final double APART_MM = 3;

  Search {
    marks = List.copyOf(marks);
    taken = List.copyOf(taken);
  }

  /** The result of a search. */
  sealed interface Outcome {

    /** A way; a narrow one leads through gaps that fit the body, but not the margin. */
    record Way(Path path, boolean isNarrow) implements Outcome {}

    /** There is a way once other robots have given back their tubes. */
    record Taken() implements Outcome {}

    /** Proven: there is no way from the start for a body that is wider by the margin. */
    record NoWay() implements Outcome {}

    /** There may be a way from the start, but none was found from here. */
    record Lost() implements Outcome {}
  }

  /** A way, or the proof that there is none. */
  Outcome onward() {
    Outcome wide = search(WIDE);
    if (!(wide instanceof Outcome.Lost)) {
      return wide;
    }
    // The robot may be where a wider body does not fit; no way from there proves nothing.
    return isCutOff() ? new Outcome.NoWay() : search(NARROWER);
  }

  /** A way, through narrow gaps if necessary. */
  Outcome back() {
    return search(PARTS);
  }

  /** The first way that is found for one of these parts of the margin, tried in turn. */
  private Outcome search(List<Double> parts) {
    for (double part : parts) {
      List<Point> points = points(part, taken);
      if (!points.isEmpty()) {
        return new Outcome.Way(new Path(points), part < 1);
      }
      if (!taken.isEmpty() && !points(part, List.of()).isEmpty()) {
        return new Outcome.Taken();
      }
    }
    return new Outcome.Lost();
  }

  /** A way whose tube meets no tube of {@code held}, nor a robot at rest; empty if none is found. */
  private List<Point> points(double part, List<Capsule> held) {
    List<Capsule> tubes = new ArrayList<>(held);
    tubes.addAll(task.others());
    double moreMm = Math.max(0, tubeMm - bodyMm - clearanceMm(part)) + APART_MM;
    tubes.replaceAll(tube -> new Capsule(tube.axis(), tube.radiusMm() + moreMm));
    List<Point> points = new ArrayList<>();
    if (PLANNER.planFromNear(planTask(from, part, tubes), SLACK_MM) instanceof Plan.Found found) {
      points.add(from);
      points.addAll(found.path().points());
    }
    return points;
  }

  /**
   * Whether there is no way from the start, with as much of the margin as fits around the start.
   */
  private boolean isCutOff() {
    for (double part : PARTS) {
      Plan plan = PLANNER.plan(planTask(task.start(), part, task.others()));
      boolean isStartBlocked = plan instanceof Plan.Blocked at && at.end() == Plan.End.START;
      if (!isStartBlocked) {
        return !(plan instanceof Plan.Found);
      }
    }
    return false;
  }

  private PlanTask planTask(Point start, double part, List<Capsule> others) {
    List<Polygon> closed = Mark.places(marks, part);
    return new PlanTask(start, goal, task.floor(), map, others, closed, bodyMm, clearanceMm(part));
  }

  private static double clearanceMm(double part) {
    return Math.max(0, part * MazeTask.MARGIN_MM - PLANNER_MM);
  }
}
