package org.starl.spec;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Variable;
import org.starl.trace.Var;

/** All robots at one time of a run: true bodies and traced variables. Read-only for requirements. */
public final class RunState {

  private record Key(RobotId robot, Instance source, String name) {}

  private final Bodies bodies = new Bodies();
  private final Map<Key, Variable> variables = new LinkedHashMap<>();
  private long timeNs;

  RunState() {}

  void observe(TraceEvent event) {
    bodies.observe(event);
    if (event instanceof Variable variable) {
      variables.put(new Key(variable.robot(), variable.source(), variable.name()), variable);
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

  /** The latest traced value of a variable of the robot's app; null before the first. */
  public <T> @Nullable T variable(RobotId robot, Var<T> declaration) {
    return variable(robot, Instance.APP, declaration);
  }

  /** The latest traced value of a variable of the robot; null before the first. */
  public <T> @Nullable T variable(RobotId robot, Instance source, Var<T> declaration) {
    Variable latest = variables.get(new Key(robot, source, declaration.name()));
    return latest == null ? null : latest.of(declaration);
  }
}
