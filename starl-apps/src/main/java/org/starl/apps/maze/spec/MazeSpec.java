package org.starl.apps.maze.spec;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.apps.maze.logic.Goal;
import org.starl.apps.maze.logic.Mark;
import org.starl.apps.maze.logic.MazeApp.Location;
import org.starl.apps.maze.logic.MazeFact;
import org.starl.apps.maze.logic.MazeTask;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.HeldSections;
import org.starl.primitives.mutex.MutexFact;
import org.starl.spec.Bodies;
import org.starl.spec.FaultState;
import org.starl.spec.Monitor;
import org.starl.spec.TellCheck;
import org.starl.spec.Within;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/**
 * The maze's specification, checked against true bodies and true obstacles.
 *
 * <ul>
 *   <li>{@code Reached}: a robot that answers that it is at its goal is there.
 *   <li>{@code NoWay}: where a robot answers that there is no way, there is none for a body that is
 *       wider by the margin, hidden obstacles included.
 *   <li>{@code Belief}: no such body fits with its centre in a mark.
 *   <li>{@code Apart}: no two robots touch. Checked every 20 ms of movement.
 *   <li>{@code held}: a robot that drives holds each block that its true body touches, so no two are
 *       in one block. Checked each 400 ms of movement, and when a robot gives blocks up that is not where
 *       others expect it: near its start or one of its goals. And it sets out only on a way on which it holds
 *       each block that it touches; for the first way to a goal, also where it may get after a contact.
 *   <li>{@code Answered}: each goal is answered within the bound while no fault is active.
 *   <li>{@code Told}: a robot that has marked a place sends the mark to all others in the same step.
 * </ul>
 */
public final class MazeSpec implements Monitor {

  static final String REACHED = "maze.Reached";
  static final String NO_WAY = "maze.NoWay";
  static final String BELIEF = "maze.Belief";
  public static final String APART = "maze.Apart";
  public static final String HELD = "maze.held";
  static final String ANSWERED = "maze.Answered";
  static final String TOLD = "maze.Told";

  private static final long STEP_NS = 20 * Time.NS_PER_MS;
  private static final int HELD_STEPS = 20;
  private static final double ROUNDING_MM = 0.01;
  private static final double ROUNDED_MM = 1; // a traced way is in whole mm

  // Solid bodies never overlap. They may touch from a gap of a millimetre on.
  private static final double TOUCHING_MM = 2;

  // Distance of the points at which a mark or a way is checked.
  private static final double GRAIN_MM = 20;

  // So far beside its place a robot may rest, position errors included.
  private static final double REST_MM = 60;

  private final Obstacles obstacles;
  private final SortedMap<RobotId, MazeTask> tasks;
  private final double bodyMm;
  private final Within<GoalOf> answers;
  private final FaultState faults = new FaultState();
  private final Bodies bodies = new Bodies();
  private final SortedSet<String> touching = new TreeSet<>();
  private final HeldSections held = new HeldSections();
  private final SortedMap<RobotId, Location> locations = new TreeMap<>();
  private final SortedMap<RobotId, MazeFact.Way> ways = new TreeMap<>();
  private final SortedSet<RobotId> outside = new TreeSet<>();
  private final TellCheck tells = new TellCheck(TOLD);
  private long nextCheckNs;
  private long nextHeldNs;

  private record GoalOf(RobotId robot, String goal) {}

  /**
   * @param obstacles the true ones, hidden ones included
   * @param tasks of all robots
   * @param boundNs from a robot's start to its last answer
   */
  public MazeSpec(
      Obstacles obstacles, SortedMap<RobotId, MazeTask> tasks, double bodyMm, long boundNs) {
    this.obstacles = obstacles;
    this.tasks = tasks;
    this.bodyMm = bodyMm;
    answers = new Within<>(boundNs);
    tells.begin();
  }

  @Override
  public List<String> lemmas() {
    return List.of(REACHED, NO_WAY, BELIEF, APART, HELD, ANSWERED, TOLD);
  }

  @Override
  public List<String> progressLemmas() {
    return List.of(ANSWERED);
  }

  @Override
  public String description(String lemma) {
    return switch (lemma) {
      case REACHED -> "A robot that answers that it is at its goal is there.";
      case NO_WAY ->
          "Where a robot answers that there is no way, there is none, hidden obstacles included.";
      case BELIEF -> "Where a robot has marked that its body does not fit, it does not fit.";
      case APART -> "No two robots touch.";
      case HELD ->
          "A robot that drives holds each block that its body touches, now and on its way.";
      case ANSWERED -> "Each goal is answered within the bound.";
      case TOLD -> "A robot that marks where bodies do not fit tells all robots in the same step.";
      default -> "";
    };
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    finish(event.timeNs(), report);
    tells.observe(event, report);
    bodies.observe(event);
    if (faults.observe(event)) {
      answers.assumeAll(faults.isFaultFree(), event.timeNs());
    }
    held.observe(event);
    if (event instanceof Variable variable) {
      changed(variable, report);
    }
    if (event instanceof Joined joined) {
      for (Goal goal : goals(joined.robot())) {
        answers.start(new GoalOf(joined.robot(), goal.name()), joined.timeNs());
      }
    } else if (event instanceof Action action && action.fact() instanceof MazeFact fact) {
      switch (fact) {
        case MazeFact.Marked marked -> {
          checkMark(action, marked.place(), report);
          tells.owes(
              action,
              Sent.ALL,
              "a mark",
              told -> told instanceof Mark mark && marked.place().equals(mark.place(1)));
        }
        case MazeFact.Answered answered -> checkAnswer(action, answered, report);
      }
    } else if (event instanceof Action action
        && action.fact() instanceof MutexFact.Release
        && !isAtRest(action.robot(), action.timeNs())) {
      checkHeld(action.robot(), action.timeNs(), report);
    }
  }

  private void changed(Variable variable, Report report) {
    RobotId robot = variable.robot();
    MazeFact.Way way = variable.of(MazeFact.WAY);
    Location location = variable.of(MazeFact.LOCATION);
    if (way != null) {
      ways.put(robot, way);
    }
    if (location != null) {
      boolean isFirst = locations.put(robot, location) == Location.ASK_WAIT;
      if (location == Location.DRIVE) {
        checkWay(robot, isFirst, variable.timeNs(), report);
      }
    }
  }

  /** Whether others expect the robot there while it holds no block. */
  private boolean isAtRest(RobotId robot, long timeNs) {
    MazeTask task = tasks.get(robot);
    if (task == null || !bodies.isOnFloor(robot)) {
      return true;
    }
    Point at = bodies.poseAt(robot, timeNs).at();
    return at.distanceMm(task.start()) <= REST_MM
        || task.goals().stream()
            .anyMatch(goal -> at.distanceMm(goal.at()) <= goal.toleranceMm() + REST_MM);
  }

  private void checkWay(RobotId robot, boolean isFirst, long timeNs, Report report) {
    MazeTask task = tasks.get(robot);
    MazeFact.Way way = ways.get(robot);
    if (task == null || way == null) {
      return;
    }
    double reachMm = bodyMm + (isFirst ? task.mode().wanderMm() : 0) - ROUNDED_MM;
    SortedSet<String> missing = new TreeSet<>();
    for (int i = 1; i < way.points().size(); i++) {
      Point from = way.points().get(i - 1);
      Point leg = way.points().get(i).minus(from);
      int pieces = (int) Math.max(1, StrictMath.ceil(leg.normMm() / GRAIN_MM));
      for (int piece = 0; piece <= pieces; piece++) {
        missing.addAll(touched(task, from.plus(leg.times((double) piece / pieces)), reachMm));
      }
    }
    missing.removeIf(block -> held.holds(robot, block));
    if (!missing.isEmpty()) {
      String detail = "sets out on a way through " + missing + " and holds " + held.held(robot);
      report.violated(HELD, timeNs, List.of(robot), detail);
    }
  }

  private static SortedSet<String> touched(MazeTask task, Point at, double reachMm) {
    SortedSet<String> touched = new TreeSet<>();
    task.blocks()
        .byName()
        .forEach((name, block) -> {
          if (block.distanceMm(at) <= reachMm) {
            touched.add(name);
          }
        });
    return touched;
  }

  @Override
  public void finish(long endNs, Report report) {
    answers.expire(
        endNs,
        (late, sinceNs, deadlineNs) -> {
          String detail = "no answer for " + late.goal() + " within ";
          report.overdue(
              ANSWERED,
              deadlineNs,
              List.of(late.robot()),
              detail + answers.boundNs() / Time.NS_PER_S + " s");
        });
    while (nextCheckNs <= endNs) {
      if (!bodies.isAnyMoving()) {
        nextCheckNs = endNs + 1;
      } else {
        checkApart(report);
        if (nextCheckNs >= nextHeldNs) {
          nextHeldNs = nextCheckNs + HELD_STEPS * STEP_NS;
          for (RobotId robot : bodies.robots()) {
            if (bodies.isMoving(robot)) {
              checkHeld(robot, nextCheckNs, report);
            }
          }
        }
        nextCheckNs += STEP_NS;
      }
    }
  }

  /** The goals of a robot; none for an unknown robot. */
  private List<Goal> goals(RobotId robot) {
    MazeTask task = tasks.get(robot);
    return task == null ? List.of() : task.goals();
  }

  private void checkAnswer(Action action, MazeFact.Answered answered, Report report) {
    RobotId robot = action.robot();
    String name = answered.goal();
    if (answers.stop(new GoalOf(robot, name))) {
      report.checked(ANSWERED);
    }
    Goal goal = goals(robot).stream().filter(g -> g.name().equals(name)).findFirst().orElse(null);
    if (goal == null) {
      violated(REACHED, action, name + " is not its goal", report);
      return;
    }
    switch (answered.answer()) {
      case REACHED -> {
        report.checked(REACHED);
        double offMm = bodies.poseAt(robot, action.timeNs()).distanceMm(goal.at());
        if (!(offMm <= goal.toleranceMm() + answered.errorMm() + ROUNDING_MM)) {
          String detail = "answers that it is at " + name + ", but is " + Math.round(offMm);
          violated(REACHED, action, detail + " mm off", report);
        }
      }
      case NO_WAY -> {
        report.checked(NO_WAY);
        MazeTask task = Objects.requireNonNull(tasks.get(robot));
        if (task.hasWay(goal, obstacles, List.of(), bodyMm)) {
          violated(NO_WAY, action, "there is a way to " + name, report);
        }
      }
      case GAVE_UP -> {}
    }
  }

  private void checkMark(Action action, Polygon mark, Report report) {
    report.checked(BELIEF);
    List<Point> points = new ArrayList<>(mark.vertices());
    Rectangle box = Rectangle.around(mark.vertices());
    for (double x = box.xMinMm(); x <= box.xMaxMm(); x += GRAIN_MM) {
      for (double y = box.yMinMm(); y <= box.yMaxMm(); y += GRAIN_MM) {
        points.add(new Point(x, y));
      }
    }
    points.stream()
        .filter(at -> mark.contains(at) && obstacles.distanceMm(at) > bodyMm + MazeTask.MARGIN_MM)
        .findFirst()
        .ifPresent(
            at -> violated(BELIEF, action, "has marked " + text(at) + ", but fits there", report));
  }

  private static void violated(String lemma, Action action, String detail, Report report) {
    report.violated(lemma, action.timeNs(), List.of(action.robot()), detail);
  }

  private static String text(Point at) {
    return "(" + Math.round(at.xMm()) + ", " + Math.round(at.yMm()) + ") mm";
  }

  private void checkHeld(RobotId robot, long timeNs, Report report) {
    MazeTask task = tasks.get(robot);
    if (task == null || !bodies.isOnFloor(robot)) {
      return;
    }
    report.checked(HELD);
    Point at = bodies.poseAt(robot, timeNs).at();
    SortedSet<String> missing = touched(task, at, bodies.radiusMm(robot));
    missing.removeIf(block -> held.holds(robot, block));
    if (missing.isEmpty()) {
      outside.remove(robot);
    } else if (outside.add(robot)) {
      String detail = "is in " + missing + " and holds " + held.held(robot);
      report.violated(HELD, timeNs, List.of(robot), detail);
    }
  }

  private void checkApart(Report report) {
    report.checked(APART);
    List<RobotId> robots = List.copyOf(bodies.robots());
    for (int i = 0; i < robots.size(); i++) {
      for (RobotId other : robots.subList(i + 1, robots.size())) {
        if (bodies.isMoving(robots.get(i)) || bodies.isMoving(other)) {
          checkApart(robots.get(i), other, report);
        }
      }
    }
  }

  private void checkApart(RobotId one, RobotId other, Report report) {
    Point at = bodies.poseAt(one, nextCheckNs).at();
    double distanceMm = at.distanceMm(bodies.poseAt(other, nextCheckNs).at());
    if (distanceMm - bodies.radiusMm(one) - bodies.radiusMm(other) > TOUCHING_MM) {
      touching.remove(one + " " + other);
    } else if (touching.add(one + " " + other)) {
      report.violated(APART, nextCheckNs, List.of(one, other), "touch around " + text(at));
    }
  }
}
