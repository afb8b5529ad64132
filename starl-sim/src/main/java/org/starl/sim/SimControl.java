package org.starl.sim;

import java.util.List;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.motion.MotionFlag;
import org.starl.random.Rng;
import org.starl.sim.net.SimNetwork;
import org.starl.sim.world.Unsynced;

/** What a {@link Director} can do. Times in ns from the start of the run. */
public interface SimControl {

  long nowNs();

  /** Number of events that the kernel has run. */
  long events();

  /** Runs {@code action} at {@code atNs}; if that is past, now, after the events of this time. */
  void at(long atNs, Runnable action);

  /** A generator of the scenario's seed for {@code name}. */
  Rng scenarioRng(String name);

  /** Adds a robot in mid-run and starts its program. */
  void join(RobotSpec robot);

  /** The robots that have joined and not left, crashed ones included, in the order of joining. */
  List<RobotId> robots();

  /** Whether the robot's program runs: it has joined, and neither left nor crashed. */
  boolean isUp(RobotId robot);

  /**
   * Crashes the program of a robot that is up, for good unless {@link #restart} is called: it runs
   * nothing and sends nothing more. Datagrams that it has sent may still arrive. Its body stays where
   * it is, wheels stopped. The run does not wait for it.
   */
  void crash(RobotId robot);

  /**
   * The same, and {@link #restart} after {@code downNs}, unless the robot was restarted or left
   * meanwhile. The run waits for the restart.
   */
  void crash(RobotId robot, long downNs, Unsynced unsynced);

  /**
   * Starts the program of a crashed robot again: another incarnation of the same app with the same body
   * and the same stable storage.
   *
   * @param unsynced what the crash did to writes that were not flushed
   */
  void restart(RobotId robot, Unsynced unsynced);

  /** Ends a robot's program at once and removes its body: it sends nothing more. */
  void leave(RobotId robot);

  /**
   * Puts a robot's body on the floor at its start pose, if that place is free.
   *
   * @return whether it was put there
   */
  boolean putOnFloor(RobotId robot);

  /** Whether a robot's body would touch nothing there. */
  boolean isFree(Pose pose);

  /** Takes a robot's body off the floor; its program continues. */
  void takeOffFloor(RobotId robot);

  boolean isOnFloor(RobotId robot);

  /** The true pose of the body, which must be on the floor. */
  Pose truePose(RobotId robot);

  /** The state of the robot's latest motion, as the robot knows it. */
  MotionFlag motionflag(RobotId robot);

  /** Whether the robot's app has ended. */
  boolean isFinished(RobotId robot);

  /** The network, to install rules. */
  SimNetwork network();
}
