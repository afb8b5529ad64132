package org.starl.sim.record;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.RobotId;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.spec.Bodies;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Variable;

/**
 * What a run looks like at one moment, put together from its events. Of the robots that have left the
 * floor only the last ones are kept.
 */
public final class Scene {

  private static final long TRAIL_STEP_NS = 100_000_000;
  private static final int KEPT_GONE = 12;

  private final Obstacles obstacles;
  private final Bodies bodies = new Bodies();
  private final SortedMap<RobotId, List<Point>> trails = new TreeMap<>();
  private final Map<RobotId, Map<String, String>> variables = new TreeMap<>();
  private final Map<RobotId, Integer> numbers = new TreeMap<>();
  private final Set<RobotId> gone = new LinkedHashSet<>();
  private int came;
  private long nowNs;
  private long trailNs;

  /**
   * @param obstacles of the world, hidden ones included
   */
  public Scene(Obstacles obstacles) {
    this.obstacles = obstacles;
  }

  /** Sees the next event. */
  public void observe(TraceEvent event) {
    advance(event.timeNs());
    bodies.observe(event);
    if (event instanceof Variable variable) {
      variables
          .computeIfAbsent(variable.robot(), robot -> new TreeMap<>())
          .put(key(variable.source(), variable.name()), variable.value());
    } else if (event instanceof TraceEvent.Joined joined) {
      gone.remove(joined.robot());
      numbers.computeIfAbsent(joined.robot(), robot -> came++);
      trails.computeIfAbsent(joined.robot(), robot -> new ArrayList<>()).add(joined.pose().at());
    } else if (event instanceof TraceEvent.Left left) {
      gone.add(left.robot());
      if (gone.size() > KEPT_GONE) {
        forget(gone.iterator().next());
      }
    }
  }

  private void forget(RobotId robot) {
    gone.remove(robot);
    trails.remove(robot);
    variables.remove(robot);
    numbers.remove(robot);
  }

  /** Time goes on to {@code timeNs}. */
  public void advance(long timeNs) {
    while (trailNs <= timeNs) {
      for (RobotId robot : bodies.robots()) {
        if (bodies.isMoving(robot)) {
          trail(robot).add(bodies.poseAt(robot, trailNs).at());
        }
      }
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

  /** The robots that are on the floor, and the last twelve that have left it, in order. */
  public List<RobotId> robots() {
    return List.copyOf(trails.keySet());
  }

  /** How many robots had come onto the floor before one of {@link #robots}: good for a colour. */
  public int number(RobotId robot) {
    return numbers.getOrDefault(robot, 0);
  }

  /** Where a robot's body is; empty if it is not on the floor. */
  public Optional<Pose> pose(RobotId robot) {
    return bodies.isOnFloor(robot) ? Optional.of(bodies.poseAt(robot, nowNs)) : Optional.empty();
  }

  /** Radius of a body that is on the floor. */
  public double radiusMm(RobotId robot) {
    return bodies.radiusMm(robot);
  }

  /** Where a robot's body has been, every 100 ms of its movement. */
  public List<Point> trail(RobotId robot) {
    List<Point> trail = trails.get(robot);
    return trail == null ? Collections.emptyList() : trail;
  }

  /** The latest value of a variable as text; empty if it never had one. */
  public String variable(RobotId robot, String source, String name) {
    return variables.getOrDefault(robot, Map.of()).getOrDefault(key(source, name), "");
  }

  private static String key(String source, String name) {
    return source + " " + name;
  }
}
