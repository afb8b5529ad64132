package org.starl.apps.hello.view;

import java.awt.Graphics2D;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.body.MotionParameters;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionFlag;
import org.starl.sim.record.Figures;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Look;
import org.starl.sim.record.Scene;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/** Draws each robot's goal as a ring with the goal radius, and a dotted line to it. */
public final class HelloLayer implements Layer {

  private static final String GOALS = "goals";

  private final SortedMap<RobotId, Point> goals = new TreeMap<>();

  @Override
  public HelloLayer copy() {
    HelloLayer copy = new HelloLayer();
    copy.goals.putAll(goals);
    return copy;
  }

  @Override
  public void observe(TraceEvent event) {
    if (event instanceof Action action && action.fact() instanceof MotionFact.doMove move) {
      goals.put(action.robot(), move.target().at());
    }
  }

  @Override
  public List<String> parts() {
    return List.of(GOALS);
  }

  @Override
  public void paintFloor(Graphics2D floor, Scene scene, Look look) {
    if (!look.shows(GOALS)) {
      return;
    }
    goals.forEach((robot, goal) -> {
      floor.setColor(look.robot(scene, robot));
      floor.setStroke(look.line(14));
      floor.draw(Figures.disc(goal, MotionParameters.DEFAULT.goalRadiusMm()));
      floor.setStroke(look.dots(16, 45));
      scene.pose(robot).ifPresent(pose -> floor.draw(Figures.line(pose.at(), goal)));
    });
  }

  @Override
  public String describe(RobotId robot, Scene scene) {
    MotionFlag flag = scene.variable(robot, MotionFact.SOURCE, MotionFact.FLAG);
    if (flag == null) {
      return "";
    }
    return switch (flag) {
      case IDLE -> "waits for its position";
      case MOVING -> "drives one metre to the right";
      case DONE -> "has arrived: DONE";
      case FAIL -> "was stopped: FAIL";
    };
  }

  /** Highest while some robots have arrived and others are moving. */
  @Override
  public double interest(Scene scene) {
    long done =
        scene.robots().stream()
            .filter(robot ->
                scene.variable(robot, MotionFact.SOURCE, MotionFact.FLAG) == MotionFlag.DONE)
            .count();
    long others = scene.robots().size() - done;
    return 1 + done * others + scene.nowNs() / 1e18;
  }
}
