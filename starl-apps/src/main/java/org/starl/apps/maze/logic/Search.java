package org.starl.apps.maze.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.primitives.paths.LocalPlanner;
import org.starl.primitives.paths.Path;
import org.starl.primitives.paths.Plan;
import org.starl.primitives.paths.PlanTask;

/**
 * Looks for a way by what a robot believes. Immutable, to be asked off the strand.
 *
 * @param from where the robot is
 * @param bodyMm radius of its body
 */
record Search(Errand errand, Belief belief, Point from, Point goal, double bodyMm) {

  private static final LocalPlanner PLANNER = new LocalPlanner();

  /** A way may begin so far from the robot, where it stands nearer to something than a way does. */
  private static final int SLACK_MM = 150;

  /** What the planner rounds away of a margin. */
  private static final double PLANNER_MM = 6;

  /** For a robot that is where a wider body could not be: parts of the margin, in turn. */
  private static final List<Double> NARROWER = List.of(0.5, 0.0);

  /** What comes of a search. */
  sealed interface Outcome {

    /** A way; a narrow one leads through gaps that are wide enough for the body alone. */
    record Way(Path path, boolean isNarrow) implements Outcome {}

    /** Proven: no way for a body that is wider by the margin. */
    record NoWay() implements Outcome {}

    /** There is a way from the start, but none from here. */
    record Lost() implements Outcome {}
  }

  /** A way, or the proof that there is none. */
  Outcome anywhere() {
    Plan plan = fromHere(1, List.of());
    if (plan instanceof Plan.Found found) {
      return way(found, false);
    }
    // From a place that only the body itself could get to, having no way on proves nothing.
    return isCutOff() ? new Outcome.NoWay() : narrow(List.of());
  }

  /** A way that keeps out of {@code outside}. */
  private Outcome within(List<Polygon> outside) {
    return fromHere(1, outside) instanceof Plan.Found found
        ? way(found, false)
        : new Outcome.Lost();
  }

  /** A way that keeps out of {@code outside}; if there is none, one anywhere, or the proof. */
  Outcome onward(List<Polygon> outside) {
    return within(outside) instanceof Outcome.Way way ? way : anywhere();
  }

  /** A way that keeps out of {@code outside}, if need be through gaps that the margin closes. */
  Outcome back(List<Polygon> outside) {
    return within(outside) instanceof Outcome.Way way ? way : narrow(outside);
  }

  private Outcome narrow(List<Polygon> outside) {
    for (double part : NARROWER) {
      if (fromHere(part, outside) instanceof Plan.Found found) {
        return way(found, true);
      }
    }
    return new Outcome.Lost();
  }

  private Outcome.Way way(Plan.Found found, boolean isNarrow) {
    List<Point> points = new ArrayList<>(found.path().points());
    points.add(0, from);
    return new Outcome.Way(new Path(points), isNarrow);
  }

  /** Whether there is no way from the start, with as much of the margin as there is round it. */
  private boolean isCutOff() {
    Plan plan = PLANNER.plan(task(errand.start(), 1, List.of()));
    for (int i = 0; i < NARROWER.size() && isStartBlocked(plan); i++) {
      plan = PLANNER.plan(task(errand.start(), NARROWER.get(i), List.of()));
    }
    return !(plan instanceof Plan.Found) && !isStartBlocked(plan);
  }

  private static boolean isStartBlocked(Plan plan) {
    return plan instanceof Plan.Blocked blocked && blocked.end() == Plan.End.START;
  }

  private Plan fromHere(double part, List<Polygon> outside) {
    return PLANNER.planFromNear(task(from, part, outside), SLACK_MM);
  }

  private PlanTask task(Point start, double part, List<Polygon> outside) {
    List<Polygon> keepOut = new ArrayList<>(belief.places(part));
    keepOut.addAll(outside);
    return new PlanTask(
        start,
        goal,
        errand.floor(),
        belief.map(),
        errand.others(),
        keepOut,
        bodyMm,
        Math.max(0, part * Errand.MARGIN_MM - PLANNER_MM));
  }
}
