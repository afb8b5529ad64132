package org.starl.spec;

import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Variable;

/** All robots at one time of a run: true bodies and traced variables. Read-only for requirements. */
public final class RunState {

  private record Key(RobotId robot, String source, String name) implements Comparable<Key> {
    @Override
    public int compareTo(Key other) {
      int order = robot.compareTo(other.robot);
      order = order == 0 ? source.compareTo(other.source) : order;
      return order == 0 ? name.compareTo(other.name) : order;
    }
  }

  private final Bodies bodies = new Bodies();
  private final Map<Key, String> variables = new TreeMap<>();
  private long timeNs;

  RunState() {}

  void observe(TraceEvent event) {
    bodies.observe(event);
    if (event instanceof Variable variable) {
      variables.put(
          new Key(variable.robot(), variable.source(), variable.name()), variable.value());
    }
  }

  void advance(long newTimeNs) {
    timeNs = newTimeNs;
  }

  /** The time, in ns from the start of the run. */
  public long timeNs() {
    return timeNs;
  }

  /** The robots whose bodies are on the floor, sorted. */
  public Set<RobotId> robots() {
    return bodies.robots();
  }

  /** The true pose of a robot on the floor. */
  public Pose pose(RobotId robot) {
    return bodies.poseAt(robot, timeNs);
  }

  /** The radius of the body of a robot on the floor, in mm. */
  public double radiusMm(RobotId robot) {
    return bodies.radiusMm(robot);
  }

  /**
   * The latest traced value of a robot's variable, as text; empty before the first.
   *
   * @param source {@code app}, or a primitive and its instance: {@code mutex/crossing}
   */
  public String variable(RobotId robot, String source, String name) {
    return variables.getOrDefault(new Key(robot, source, name), "");
  }
}
