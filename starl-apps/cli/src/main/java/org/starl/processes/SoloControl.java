package org.starl.processes;

import java.util.List;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.motion.MotionFlag;
import org.starl.random.Rng;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimControl;
import org.starl.sim.net.SimNetwork;
import org.starl.sim.world.Unsynced;

/**
 * The hands of a scenario's director in the process of one robot: it directs that robot, and sees of
 * the others nothing but that they are somewhere else. Whether there is room on the floor is the
 * parent's to say. Strand only.
 */
public final class SoloControl implements SimControl {

  private static final Pose ELSEWHERE = Pose.of(new Point(1e9, 1e9), 0);

  /** The one robot that is here. */
  public interface Robot {
    RobotId id();

    long nowNs();

    void at(long atNs, Runnable action);

    boolean putOnFloor();

    void takeOffFloor();

    boolean isOnFloor();

    boolean isFree(Pose place);

    Pose truePose();

    MotionFlag motionflag();

    boolean isFinished();
  }

  private final Robot robot;
  private final List<RobotId> robots;
  private final Rng scenarioRng;

  /**
   * @param robots all of the deployment
   * @param scenarioRng forked for each name that the director asks for
   */
  public SoloControl(Robot robot, List<RobotId> robots, Rng scenarioRng) {
    this.robot = robot;
    this.robots = List.copyOf(robots);
    this.scenarioRng = scenarioRng;
  }

  private boolean isHere(RobotId id) {
    return id.equals(robot.id());
  }

  @Override
  public long nowNs() {
    return robot.nowNs();
  }

  @Override
  public long events() {
    return 0;
  }

  @Override
  public void at(long atNs, Runnable action) {
    robot.at(atNs, action);
  }

  @Override
  public Rng scenarioRng(String name) {
    return scenarioRng.fork(name);
  }

  @Override
  public List<RobotId> robots() {
    return robots;
  }

  @Override
  public boolean isUp(RobotId id) {
    return true;
  }

  @Override
  public boolean putOnFloor(RobotId id) {
    return !isHere(id) || robot.putOnFloor();
  }

  @Override
  public void takeOffFloor(RobotId id) {
    if (isHere(id)) {
      robot.takeOffFloor();
    }
  }

  @Override
  public boolean isOnFloor(RobotId id) {
    return !isHere(id) || robot.isOnFloor();
  }

  /** As far as this robot's own body and the obstacles go. */
  @Override
  public boolean isFree(Pose place) {
    return robot.isFree(place);
  }

  @Override
  public Pose truePose(RobotId id) {
    return isHere(id) ? robot.truePose() : ELSEWHERE;
  }

  @Override
  public MotionFlag motionflag(RobotId id) {
    return isHere(id) ? robot.motionflag() : MotionFlag.MOVING;
  }

  @Override
  public boolean isFinished(RobotId id) {
    return isHere(id) && robot.isFinished();
  }

  @Override
  public void join(RobotSpec newcomer) {
    throw noSuchPower("bring up " + newcomer.id());
  }

  @Override
  public void crash(RobotId id) {
    throw noSuchPower("crash " + id);
  }

  @Override
  public void crash(RobotId id, long downNs, Unsynced unsynced) {
    throw noSuchPower("crash " + id);
  }

  @Override
  public void restart(RobotId id, Unsynced unsynced) {
    throw noSuchPower("restart " + id);
  }

  @Override
  public void leave(RobotId id) {
    throw noSuchPower("take away " + id);
  }

  @Override
  public SimNetwork network() {
    throw noSuchPower("touch the network");
  }

  private static UnsupportedOperationException noSuchPower(String what) {
    return new UnsupportedOperationException(
        "a director cannot " + what + " where robots are processes");
  }
}
