package org.starl.sim;

import java.util.List;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.sim.net.SimNetwork;
import org.starl.sim.world.Unsynced;

/** The operations of a {@link Director}. Times are in ns from the start of the run. */
public interface SimControl {

  long nowNs();

  /** Number of events that the kernel has run. */
  long events();

  /**
   * Runs {@code action} at {@code atNs} or, if that is in the past, now, after the events of this
   * time.
   */
  void at(long atNs, Runnable action);

  /** A generator for {@code name}, forked from the scenario's seed. */
  Rng scenarioRng(String name);

  /** Adds a robot during the run and starts its program. */
  void join(RobotSpec robot);

  /** The robots that have joined and not left, crashed ones included, in joining order. */
  List<RobotId> robots();

  /** Whether the robot's program runs: it has joined, and neither left nor crashed. */
  boolean isUp(RobotId robot);

  /**
   * Crashes the program of a robot that is up, permanently unless {@link #restart} is called: the
   * program runs no more code and sends no more datagrams. Datagrams already sent may still arrive.
   * The body stays in place with stopped wheels. The run does not wait for the robot.
   */
  void crash(RobotId robot);

  /**
   * Crashes the program likewise, and calls {@link #restart} after {@code downNs} unless the robot
   * was restarted or left before. The run waits for the restart.
   */
  void crash(RobotId robot, long downNs, Unsynced unsynced);

  /**
   * Restarts the program of a crashed robot: a new incarnation of the same app with the same body
   * and the same stable storage.
   *
   * @param unsynced the effect of the crash on unflushed writes
   */
  void restart(RobotId robot, Unsynced unsynced);

  /** Ends a robot's program at once and removes its body; it sends no more datagrams. */
  void leave(RobotId robot);

  /**
   * Puts a robot's body on the floor at its start pose if that place is free.
   *
   * @return whether the body was put on the floor
   */
  boolean putOnFloor(RobotId robot);

  /** Whether a robot's body would touch no obstacle and no body at this pose. */
  boolean isFree(Pose pose);

  /** Takes a robot's body off the floor; its program continues. */
  void takeOffFloor(RobotId robot);

  boolean isOnFloor(RobotId robot);

  /** The true pose of the body, which must be on the floor. */
  Pose truePose(RobotId robot);

  /** Whether the robot's app has ended. */
  boolean isFinished(RobotId robot);

  /** The network, on which rules can be installed. */
  SimNetwork network();
}
