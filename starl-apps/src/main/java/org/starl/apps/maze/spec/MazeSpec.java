package org.starl.apps.maze.spec;

import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.apps.maze.logic.Answer;
import org.starl.apps.maze.logic.Goal;
import org.starl.apps.maze.logic.MazeTrace;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Pose;
import org.starl.geometry.RegionText;
import org.starl.id.RobotId;
import org.starl.spec.Bodies;
import org.starl.spec.Circumstances;
import org.starl.spec.Monitor;
import org.starl.spec.Within;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Joined;

/**
 * The maze's own goal.
 *
 * <ul>
 *   <li>{@code Reached}: who says that it is at its goal is there, in truth.
 *   <li>{@code NoWay}: where a robot says that there is no way, there is none for a body that is wider
 *       by the margin, hidden obstacles and all.
 *   <li>{@code Belief}: where a robot believes that such a body cannot be, it cannot.
 *   <li>{@code Apart}: no two robots touch. Looked at every 20 ms of movement.
 *   <li>{@code Answered}: each goal is answered within the bound, as long as the world behaves.
 * </ul>
 */
public final class MazeSpec implements Monitor {

  static final String REACHED = "Reached";
  static final String NO_WAY = "NoWay";
  static final String BELIEF = "Belief";
  static final String APART = "Apart";
  static final String ANSWERED = "Answered";

  private static final long STEP_NS = 20_000_000;
  private static final double ROUNDING_MM = 0.01;

  /** Marks are looked at so closely. */
  private static final double GRAIN_MM = 20;

  private final MazeTruth truth;
  private final Within<String> answers;
  private final Circumstances circumstances = new Circumstances();
  private final Bodies bodies = new Bodies();
  private final SortedSet<String> touching = new TreeSet<>();
  private long nextLookNs;

  /**
   * @param boundNs from a robot's start to its last answer
   */
  public MazeSpec(MazeTruth truth, long boundNs) {
    this.truth = truth;
    answers = new Within<>(boundNs);
  }

  @Override
  public List<String> lemmas() {
    return List.of(REACHED, NO_WAY, BELIEF, APART, ANSWERED);
  }

  @Override
  public String says(String lemma) {
    return switch (lemma) {
      case REACHED -> "A robot that says it is at its goal is there, in truth.";
      case NO_WAY ->
          "Where a robot says that no way leads, there is none, hidden obstacles and all.";
      case BELIEF -> "Where a robot believes that it cannot be, it cannot.";
      case APART -> "No two robots touch.";
      case ANSWERED -> "Each goal is answered within the bound.";
      default -> "";
    };
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    expire(event.timeNs(), report);
    lookUntil(event.timeNs(), report);
    bodies.observe(event);
    if (circumstances.observe(event)) {
      answers.assumeAll(circumstances.isFair(), event.timeNs());
    }
    if (event instanceof Joined joined && truth.errands().containsKey(joined.robot())) {
      for (Goal goal : truth.errands().get(joined.robot()).goals()) {
        answers.owe(key(joined.robot(), goal.name()), joined.timeNs());
      }
    } else if (event instanceof Action action && action.source().equals(MazeTrace.SOURCE)) {
      acted(action, report);
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    expire(endNs, report);
    lookUntil(endNs, report);
  }

  private static String key(RobotId robot, String goal) {
    return robot + " " + goal;
  }

  private void expire(long nowNs, Report report) {
    answers.expire(
        nowNs,
        (key, sinceNs, deadlineNs) ->
            report.violated(
                ANSWERED,
                deadlineNs,
                List.of(new RobotId(key.substring(0, key.indexOf(' ')))),
                "no answer on " + key + " within " + answers.boundNs() / 1_000_000_000 + " s"));
  }

  private void acted(Action action, Report report) {
    switch (action.name()) {
      case MazeTrace.MARK -> checkMark(action, report);
      case MazeTrace.ANSWER -> {
        String name = action.args().get(0);
        if (answers.settle(key(action.robot(), name))) {
          report.checked(ANSWERED);
        }
        Goal goal = truth.goal(action.robot(), name);
        if (goal == null) {
          report.violated(
              REACHED, action.timeNs(), List.of(action.robot()), name + " is no goal of it");
        } else {
          checkAnswer(action, goal, report);
        }
      }
      default -> {
        // Of no concern here.
      }
    }
  }

  private void checkAnswer(Action action, Goal goal, Report report) {
    RobotId robot = action.robot();
    switch (Answer.valueOf(action.args().get(1))) {
      case REACHED -> {
        report.checked(REACHED);
        double errorMm = Double.parseDouble(action.args().get(2));
        Pose at = bodies.poseAt(robot, action.timeNs());
        double offMm = at.distanceMm(goal.at());
        if (!(offMm <= goal.toleranceMm() + errorMm + ROUNDING_MM)) {
          report.violated(
              REACHED,
              action.timeNs(),
              List.of(robot),
              "says that it is at " + goal.name() + " and is " + Math.round(offMm) + " mm off");
        }
      }
      case NO_WAY -> {
        report.checked(NO_WAY);
        if (truth.leadsTo(robot, goal)) {
          report.violated(
              NO_WAY, action.timeNs(), List.of(robot), "there is a way to " + goal.name());
        }
      }
      case GAVE_UP -> {
        // Says nothing of the world.
      }
    }
  }

  private void checkMark(Action action, Report report) {
    report.checked(BELIEF);
    Polygon mark = (Polygon) RegionText.parse(action.args().get(0));
    for (Point corner : mark.vertices()) {
      if (!isFine(corner, action, report)) {
        return;
      }
    }
    double xMin = mark.vertices().stream().mapToDouble(Point::xMm).min().orElseThrow();
    double xMax = mark.vertices().stream().mapToDouble(Point::xMm).max().orElseThrow();
    double yMin = mark.vertices().stream().mapToDouble(Point::yMm).min().orElseThrow();
    double yMax = mark.vertices().stream().mapToDouble(Point::yMm).max().orElseThrow();
    for (double x = xMin; x <= xMax; x += GRAIN_MM) {
      for (double y = yMin; y <= yMax; y += GRAIN_MM) {
        Point at = new Point(x, y);
        if (mark.contains(at) && !isFine(at, action, report)) {
          return;
        }
      }
    }
  }

  private boolean isFine(Point at, Action action, Report report) {
    if (!truth.isRoomAt(at)) {
      return true;
    }
    report.violated(
        BELIEF,
        action.timeNs(),
        List.of(action.robot()),
        "believes that nobody fits around ("
            + Math.round(at.xMm())
            + ", "
            + Math.round(at.yMm())
            + ") mm, where there is room");
    return false;
  }

  private void lookUntil(long timeNs, Report report) {
    while (nextLookNs <= timeNs) {
      if (!anybodyMoves()) {
        nextLookNs = timeNs + 1;
        return;
      }
      look(report);
      nextLookNs += STEP_NS;
    }
  }

  private boolean anybodyMoves() {
    for (RobotId robot : bodies.robots()) {
      if (bodies.isMoving(robot)) {
        return true;
      }
    }
    return false;
  }

  private void look(Report report) {
    report.checked(APART);
    List<RobotId> robots = List.copyOf(bodies.robots());
    for (int i = 0; i < robots.size(); i++) {
      for (int j = i + 1; j < robots.size(); j++) {
        if (bodies.isMoving(robots.get(i)) || bodies.isMoving(robots.get(j))) {
          checkApart(robots.get(i), robots.get(j), report);
        }
      }
    }
  }

  private void checkApart(RobotId one, RobotId other, Report report) {
    Point at = bodies.poseAt(one, nextLookNs).at();
    double gapMm =
        at.distanceMm(bodies.poseAt(other, nextLookNs).at())
            - bodies.radiusMm(one)
            - bodies.radiusMm(other);
    // Solid bodies never overlap; they touch from a gap of a millimetre on.
    if (gapMm > 2) {
      touching.remove(one + " " + other);
    } else if (touching.add(one + " " + other)) {
      report.violated(
          APART,
          nextLookNs,
          List.of(one, other),
          "touch around (" + Math.round(at.xMm()) + ", " + Math.round(at.yMm()) + ") mm");
    }
  }
}
