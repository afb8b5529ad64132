package org.starl.apps.lightpaint.spec;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.starl.apps.lightpaint.logic.Light;
import org.starl.apps.lightpaint.logic.PaintTrace;
import org.starl.id.RobotId;
import org.starl.spec.Bodies;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

/**
 * What was truly painted: where bodies were while their lights were on. A light goes out when the
 * program crashes that keeps it on.
 */
public final class LightTrail {

  private static final long STEP_NS = 10_000_000;

  private final Bodies bodies;
  private final SortedMap<RobotId, Pass> open = new TreeMap<>();
  private final List<Pass> passes = new ArrayList<>();
  private final Consumer<Pass> listener;
  private long nextNs;

  public LightTrail() {
    this(pass -> {});
  }

  /**
   * @param listener is told of a pass whenever it has one more point
   */
  LightTrail(Consumer<Pass> listener) {
    this(listener, new Bodies());
  }

  private LightTrail(Consumer<Pass> listener, Bodies bodies) {
    this.listener = listener;
    this.bodies = bodies;
  }

  /** The same at this moment, from now on apart and without a listener. Passes that are over, are shared. */
  public LightTrail copy() {
    LightTrail copy = new LightTrail(pass -> {}, bodies.copy());
    for (Pass pass : passes) {
      boolean isOpen = open.get(pass.robot()) == pass;
      Pass same = isOpen ? pass.copy() : pass;
      copy.passes.add(same);
      if (isOpen) {
        copy.open.put(pass.robot(), same);
      }
    }
    copy.nextNs = nextNs;
    return copy;
  }

  /** All passes, in the order in which they began; the last ones may not be over. */
  public List<Pass> passes() {
    return Collections.unmodifiableList(passes);
  }

  /** Sees the next event. */
  public void observe(TraceEvent event) {
    advance(event.timeNs());
    switch (event) {
      case Variable variable -> {
        if (variable.source().equals(PaintTrace.SOURCE)
            && variable.name().equals(PaintTrace.LIGHT)) {
          close(variable.robot(), variable.timeNs());
          shine(variable.robot(), Light.parse(variable.value()), variable.timeNs());
        }
      }
      case Fault fault -> {
        if (fault.name().equals(Fault.CRASH)) {
          close(fault.robot(), fault.timeNs());
        }
      }
      case TraceEvent.Left left -> close(left.robot(), left.timeNs());
      case TraceEvent.Moved moved -> look(moved.robot(), moved.timeNs());
      default -> {
        // Neither moves nor shines.
      }
    }
    bodies.observe(event);
  }

  /** Time goes on to {@code timeNs}. */
  public void advance(long timeNs) {
    while (nextNs <= timeNs) {
      boolean isAnybodyMoving = false;
      for (RobotId robot : open.keySet()) {
        if (bodies.isMoving(robot)) {
          isAnybodyMoving = true;
          look(robot, nextNs);
        }
      }
      nextNs = isAnybodyMoving ? nextNs + STEP_NS : Math.max(nextNs, timeNs) + 1;
    }
  }

  private void shine(RobotId robot, Light light, long timeNs) {
    if (light.ink() != null && bodies.isOnFloor(robot)) {
      Pass pass = new Pass(robot, light.stroke(), light.ink());
      open.put(robot, pass);
      passes.add(pass);
      look(robot, timeNs);
    }
  }

  private void close(RobotId robot, long timeNs) {
    look(robot, timeNs);
    open.remove(robot);
  }

  private void look(RobotId robot, long timeNs) {
    Pass pass = open.get(robot);
    if (pass != null && bodies.isOnFloor(robot)) {
      pass.add(bodies.poseAt(robot, timeNs).at());
      listener.accept(pass);
    }
  }
}
