package org.starl.apps.lightpaint.spec;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.starl.apps.lightpaint.logic.Light;
import org.starl.apps.lightpaint.logic.PaintFact;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.id.RobotId;
import org.starl.spec.Bodies;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

/**
 * What was painted: the true positions of bodies while their lights were on. A light goes out when
 * the program crashes that switched it on.
 */
public final class LightTrail {

  private static final long STEP_NS = 10 * Time.NS_PER_MS;

  private final Bodies bodies;
  private final Consumer<Pass> listener;
  private final SortedMap<RobotId, Pass> open = new TreeMap<>();
  private final List<Pass> passes = new ArrayList<>();
  private long nextNs;

  public LightTrail() {
    this(new Bodies(), pass -> {});
  }

  /**
   * @param listener called with a pass after each point that is added to it
   */
  LightTrail(Bodies bodies, Consumer<Pass> listener) {
    this.bodies = bodies;
    this.listener = listener;
  }

  /** An independent copy of the present state, without a listener; finished passes are shared. */
  public LightTrail copy() {
    LightTrail copy = new LightTrail(bodies.copy(), pass -> {});
    copy.passes.addAll(passes);
    copy.open.putAll(open);
    copy.open.replaceAll((robot, pass) -> {
      Pass same = new Pass(robot, pass.stroke(), pass.ink(), pass.points());
      copy.passes.set(passes.indexOf(pass), same);
      return same;
    });
    copy.nextNs = nextNs;
    return copy;
  }

  /** All passes, in the order in which they began; some may be unfinished. */
  public List<Pass> passes() {
    return Collections.unmodifiableList(passes);
  }

  /** The length, in mm, of what {@code robot} has painted. */
  public double paintedMm(RobotId robot) {
    return passes.stream()
        .filter(pass -> pass.robot().equals(robot))
        .mapToDouble(pass -> Polyline.lengthMm(pass.points()))
        .sum();
  }

  /** Processes the next event. */
  public void observe(TraceEvent event) {
    advance(event.timeNs());
    switch (event) {
      case Variable variable -> {
        Light light = variable.of(PaintFact.LIGHT);
        if (light != null) {
          end(variable.robot(), variable.timeNs());
          begin(variable.robot(), light, variable.timeNs());
        }
      }
      case Fault fault when fault.name().equals(Fault.CRASH) -> end(fault.robot(), fault.timeNs());
      case TraceEvent.Left left -> end(left.robot(), left.timeNs());
      case TraceEvent.Moved moved -> addPoint(moved.robot(), moved.timeNs());
      default -> {
        // Changes no light and no movement.
      }
    }
    bodies.observe(event);
  }

  /** Advances time to {@code timeNs}. */
  public void advance(long timeNs) {
    while (nextNs <= timeNs) {
      boolean isMoving = false;
      for (RobotId robot : open.keySet()) {
        if (bodies.isMoving(robot)) {
          isMoving = true;
          addPoint(robot, nextNs);
        }
      }
      nextNs = isMoving ? nextNs + STEP_NS : Math.max(nextNs, timeNs) + 1;
    }
  }

  private void begin(RobotId robot, Light light, long timeNs) {
    if (light.ink() != null && bodies.isOnFloor(robot)) {
      Pass pass = new Pass(robot, light.stroke(), light.ink(), List.of());
      open.put(robot, pass);
      passes.add(pass);
      addPoint(robot, timeNs);
    }
  }

  private void end(RobotId robot, long timeNs) {
    addPoint(robot, timeNs);
    open.remove(robot);
  }

  private void addPoint(RobotId robot, long timeNs) {
    Pass pass = open.get(robot);
    if (pass != null && bodies.isOnFloor(robot)) {
      pass.add(bodies.poseAt(robot, timeNs).at());
      listener.accept(pass);
    }
  }
}
