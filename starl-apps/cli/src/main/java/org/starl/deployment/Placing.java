package org.starl.deployment;

import java.io.IOException;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.motion.MotionFlag;
import org.starl.platform.Clock;
import org.starl.processes.SoloControl;
import org.starl.random.Rng;
import org.starl.robot.DeployedRobot;
import org.starl.sim.Blueprint;
import org.starl.sim.RobotSpec;

/**
 * The scenario's director for one robot whose body is in a {@link WorldProcess}: asks the world to put it
 * on the floor and to take it off when the director says so. What it sees is what the robot sees. Strand
 * only, but for {@link #heard}.
 */
final class Placing implements SoloControl.Robot {

  private static final long RETRY_NS = 100_000_000;

  private final RobotSpec spec;
  private final DeployedRobot robot;
  private final Hands hands;
  private final Clock clock;
  private boolean isAsked;
  private boolean isPlaced;

  /** @param clock the robot's own, for the strand */
  Placing(RobotSpec spec, DeployedRobot robot, Hands hands, Clock clock) {
    this.spec = spec;
    this.robot = robot;
    this.hands = hands;
    this.clock = clock;
  }

  /** Begins to direct, before the robot starts. */
  void begin(Blueprint blueprint, List<RobotId> robots) {
    robot
        .strand()
        .post(() -> {
          if (spec.onFloor()) {
            appearSoon();
          }
          if (blueprint.director() != null) {
            Rng scenarioRng = new Rng(blueprint.header().scenarioSeed());
            blueprint.director().direct(new SoloControl(this, robots, scenarioRng));
          }
        });
  }

  /** The world says something; from any thread. */
  void heard(Hands.Word word) {
    robot.strand().post(() -> isPlaced = word == Hands.Word.PLACED);
  }

  private void appearSoon() {
    if (!putOnFloor()) {
      at(clock.nowNs() + RETRY_NS, this::appearSoon);
    }
  }

  @Override
  public RobotId id() {
    return spec.id();
  }

  @Override
  public long nowNs() {
    return clock.nowNs();
  }

  @Override
  public void at(long atNs, Runnable action) {
    robot.strand().timer(action).set(atNs);
  }

  @Override
  public boolean putOnFloor() {
    if (!isAsked) {
      isAsked = true;
      say(Hands.Word.PLACE);
    }
    return isPlaced;
  }

  @Override
  public void takeOffFloor() {
    if (isAsked) {
      isAsked = false;
      isPlaced = false;
      say(Hands.Word.LIFT);
    }
  }

  @Override
  public boolean isOnFloor() {
    return isPlaced;
  }

  /** The world sees to that. */
  @Override
  public boolean isFree(Pose place) {
    return true;
  }

  /** As far as the robot knows. */
  @Override
  public Pose truePose() {
    GlobalVarHolder gvh = robot.gvh();
    return gvh == null || !gvh.gps.hasFix() ? spec.start() : gvh.gps.pose();
  }

  @Override
  public MotionFlag motionflag() {
    @Nullable GlobalVarHolder gvh = robot.gvh();
    return gvh == null ? MotionFlag.IDLE : gvh.plat.moat.motionflag().get();
  }

  @Override
  public boolean isFinished() {
    return robot.isFinished();
  }

  // A world that is gone is told by the hands' own reader.
  private void say(Hands.Word word) {
    try {
      hands.say(word);
    } catch (IOException e) {
      isAsked = false;
    }
  }
}
