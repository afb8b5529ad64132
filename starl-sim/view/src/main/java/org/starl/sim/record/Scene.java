package org.starl.sim.record;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.motion.Deviation;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionFailure;
import org.starl.sim.Failure;
import org.starl.spec.Bodies;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Variable;
import org.starl.trace.Var;

/**
 * The visible state of a run at one moment, computed from its events. Of the robots that have left
 * the floor only the last twelve are kept.
 */
public final class Scene {

  private static final long TRAIL_STEP_NS = 100_000_000;
  private static final long FAILURE_SHOWN_NS = 10_000_000_000L;
  private static final int KEPT_GONE = 12;
  private static final int KEPT_BUMPS = 64;

  /** A robot reported that it bumped into something. */
  public record Bump(long timeNs, Point at) {}

  /** Visits the bodies on the floor. */
  public interface Visitor {

    /**
     * @param number see {@link Scene#number}
     * @param pose true pose of the body
     */
    void visit(RobotId robot, int number, Pose pose, double radiusMm);
  }

  private final Obstacles obstacles;
  private final Bodies bodies;
  private final SortedMap<RobotId, Trail> trails = new TreeMap<>();
  private final Map<RobotId, SortedMap<String, Variable>> variables = new TreeMap<>();
  private final Map<RobotId, Integer> numbers = new TreeMap<>();
  private final Set<RobotId> gone = new LinkedHashSet<>();
  private final Set<RobotId> down = new TreeSet<>();
  private final Deque<Bump> bumps = new ArrayDeque<>();
  private final BoundingBox extent;
  private @Nullable Failure failure;
  private int came;
  private long nowNs;
  private long trailNs;

  /**
   * @param obstacles of the world, hidden ones included
   */
  public Scene(Obstacles obstacles) {
    this(obstacles, new Bodies(), new BoundingBox());
    for (Obstacle obstacle : obstacles.all()) {
      obstacle.points().forEach(extent::add);
    }
  }

  private Scene(Obstacles obstacles, Bodies bodies, BoundingBox extent) {
    this.obstacles = obstacles;
    this.bodies = bodies;
    this.extent = extent;
  }

  /**
   * An independent copy in the same state; copy and original may be used by two threads. The points
   * of trails are shared.
   */
  public Scene copy() {
    Scene copy = new Scene(obstacles, bodies.copy(), extent.copy());
    // putAll of a sorted map takes linear time.
    copy.trails.putAll(trails);
    copy.trails.replaceAll((robot, trail) -> trail.copy());
    copy.variables.putAll(variables);
    copy.variables.replaceAll((robot, values) -> new TreeMap<>(values));
    copy.numbers.putAll(numbers);
    copy.gone.addAll(gone);
    copy.down.addAll(down);
    copy.bumps.addAll(bumps);
    copy.failure = failure;
    copy.came = came;
    copy.nowNs = nowNs;
    copy.trailNs = trailNs;
    return copy;
  }

  /** Applies the next event. */
  public void observe(TraceEvent event) {
    advance(event.timeNs());
    bodies.observe(event);
    if (event instanceof Variable variable) {
      variables
          .computeIfAbsent(variable.robot(), robot -> new TreeMap<>())
          .put(key(variable.source(), variable.name()), variable);
    } else if (event instanceof TraceEvent.Joined joined) {
      gone.remove(joined.robot());
      numbers.computeIfAbsent(joined.robot(), robot -> came++);
      trails
          .computeIfAbsent(joined.robot(), robot -> new Trail())
          .append(joined.pose().at(), TrailPainter.mostPoints(trails.size()));
      extent.add(joined.pose().at());
    } else if (event instanceof TraceEvent.Left left) {
      gone.add(left.robot());
      if (gone.size() > KEPT_GONE) {
        forget(gone.iterator().next());
      }
    } else if (event instanceof TraceEvent.Fault fault) {
      if (fault.name().equals(TraceEvent.Fault.CRASH)) {
        down.add(fault.robot());
        // What it believed is lost with the program.
        variables
            .getOrDefault(fault.robot(), new TreeMap<>())
            .remove(key(Deviation.SOURCE, Deviation.VAR.name()));
      } else if (fault.name().equals(TraceEvent.Fault.RESTART)) {
        down.remove(fault.robot());
      }
    } else if (event instanceof TraceEvent.Action action) {
      noteBump(action);
    }
  }

  private void noteBump(TraceEvent.Action action) {
    if (action.fact() instanceof MotionFact.failed end
        && end.reason() == MotionFailure.BUMPED
        && bodies.isOnFloor(action.robot())) {
      Pose pose = bodies.poseAt(action.robot(), action.timeNs());
      double radiusMm = bodies.radiusMm(action.robot());
      Point ahead =
          new Point(
              radiusMm * StrictMath.cos(pose.headingRad()),
              radiusMm * StrictMath.sin(pose.headingRad()));
      bumps.add(new Bump(action.timeNs(), pose.at().plus(ahead)));
      if (bumps.size() > KEPT_BUMPS) {
        bumps.remove();
      }
    }
  }

  private void forget(RobotId robot) {
    gone.remove(robot);
    trails.remove(robot);
    variables.remove(robot);
    numbers.remove(robot);
    down.remove(robot);
  }

  /** Advances the time to {@code timeNs}. */
  public void advance(long timeNs) {
    int most = TrailPainter.mostPoints(trails.size());
    while (trailNs <= timeNs) {
      Iterator<Map.Entry<RobotId, Trail>> all = trails.entrySet().iterator();
      bodies.forEach(
          trailNs,
          (robot, pose, radiusMm, isMoving) -> {
            // Both are sorted, and each robot on the floor has a trail.
            Map.Entry<RobotId, Trail> entry = all.next();
            while (!entry.getKey().equals(robot)) {
              entry = all.next();
            }
            if (isMoving) {
              entry.getValue().append(pose.at(), most);
              extent.add(pose.at());
            }
          });
      trailNs += TRAIL_STEP_NS;
    }
    nowNs = timeNs;
  }

  public long nowNs() {
    return nowNs;
  }

  public Obstacles obstacles() {
    return obstacles;
  }

  /** The robots on the floor and the last twelve that have left it, sorted. */
  public List<RobotId> robots() {
    return List.copyOf(trails.keySet());
  }

  /** Number of robots that joined before this one; determines its colour. */
  public int number(RobotId robot) {
    return numbers.getOrDefault(robot, 0);
  }

  /** The true pose of a robot; empty if it is not on the floor. */
  public Optional<Pose> pose(RobotId robot) {
    return bodies.isOnFloor(robot) ? Optional.of(bodies.poseAt(robot, nowNs)) : Optional.empty();
  }

  /** The radius of a robot on the floor. */
  public double radiusMm(RobotId robot) {
    return bodies.radiusMm(robot);
  }

  /** Visits every body on the floor at the present time, in order; fast for many bodies. */
  public void forEachBody(Visitor visitor) {
    Iterator<Map.Entry<RobotId, Integer>> all = numbers.entrySet().iterator();
    bodies.forEach(
        nowNs,
        (robot, pose, radiusMm, isMoving) -> {
          Map.Entry<RobotId, Integer> entry = all.next();
          while (!entry.getKey().equals(robot)) {
            entry = all.next();
          }
          visitor.visit(robot, entry.getValue(), pose, radiusMm);
        });
  }

  /** What the run's first failure is, for pictures of it: null if none is known. */
  public void describe(@Nullable Failure newFailure) {
    failure = newFailure;
  }

  /** The failure to mark at the present time: from it on, for 10 s. */
  @Nullable Failure failure() {
    Failure known = failure;
    boolean isShown =
        known != null && nowNs >= known.atNs() && nowNs <= known.atNs() + FAILURE_SHOWN_NS;
    return isShown ? known : null;
  }

  /** Whether a robot's program has crashed and has not restarted. */
  public boolean isDown(RobotId robot) {
    return down.contains(robot);
  }

  /** The robots whose programs have crashed and have not restarted, sorted. */
  Set<RobotId> down() {
    return Collections.unmodifiableSet(down);
  }

  /** The last 64 bumps, oldest first. */
  public List<Bump> bumps() {
    return List.copyOf(bumps);
  }

  /** Bounding box of obstacles and of all positions of robots so far; grows with the scene. */
  BoundingBox extent() {
    return extent;
  }

  /**
   * Positions of a robot's body, every 100 ms while it moves; of a long trail, or if there are many
   * robots, fewer of the older ones.
   */
  public List<Point> trail(RobotId robot) {
    Trail trail = trails.get(robot);
    return trail == null ? Collections.emptyList() : trail;
  }

  /** For how many periods of 100 ms a robot's body has moved. */
  public int driven(RobotId robot) {
    Trail trail = trails.get(robot);
    return trail == null ? 0 : trail.steps();
  }

  /** Whether no robot has ever moved. */
  boolean isStill() {
    return trails.values().stream().allMatch(trail -> trail.steps() <= 1);
  }

  /** The latest value of a variable of the robot's app; null if it has none. */
  public <T> @Nullable T variable(RobotId robot, Var<T> declaration) {
    return variable(robot, Instance.APP, declaration);
  }

  /** The latest value of a variable of the robot; null if it has none. */
  public <T> @Nullable T variable(RobotId robot, Instance source, Var<T> declaration) {
    Variable latest = latest(robot, source, declaration.name());
    return latest == null ? null : latest.of(declaration);
  }

  /** The latest value of a variable, as people read it; empty if it has none. */
  public String text(RobotId robot, Instance source, String name) {
    Variable latest = latest(robot, source, name);
    return latest == null ? "" : latest.value().toString();
  }

  private @Nullable Variable latest(RobotId robot, Instance source, String name) {
    SortedMap<String, Variable> all = variables.get(robot);
    return all == null ? null : all.get(key(source, name));
  }

  /** The latest changes of all variables of a robot, sorted by source and name. */
  public List<Variable> variables(RobotId robot) {
    SortedMap<String, Variable> all = variables.get(robot);
    return all == null ? List.of() : List.copyOf(all.values());
  }

  private static String key(Instance source, String name) {
    return source + " " + name;
  }
}
