package org.starl.sim;

import java.util.List;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.motion.MotionFlag;
import org.starl.random.Rng;
import org.starl.sim.net.SimNetwork;
import org.starl.sim.world.Unsynced;

/** A {@link Director}'s hands. Times in ns from the start of the run. */
public interface SimControl {

  long nowNs();

  /** How many events the kernel has run so far. */
  long events();

  /** Runs {@code action} at {@code atNs}, or now, later in order, if that is past. */
  void at(long atNs, Runnable action);

  /** A generator of the scenario's seed for {@code name}. */
  Rng scenarioRng(String name);

  /** Brings a robot up in mid-run. */
  void join(RobotSpec robot);

  /** The robots that are there, crashed ones included, in the order in which they came. */
  List<RobotId> robots();

  /** Whether the robot's program runs: it is there, and has not crashed. */
  boolean isUp(RobotId robot);

  /**
   * Ends the program of a robot that is up, for good unless {@link #restart} is called: nothing of
   * it runs any more, and it says nothing more. What it had sent may still arrive. Its body stays
   * where it is, wheels stopped. The run does not wait for it.
   */
  void crash(RobotId robot);

  /**
   * The same, and {@link #restart} after {@code downNs}, for which the run waits; unless somebody
   * has restarted it, or made it leave, meanwhile.
   */
  void crash(RobotId robot, long downNs, Unsynced unsynced);

  /**
   * Starts a crashed robot's program anew: another incarnation of the same app with the same body
   * and the same stable storage.
   *
   * @param unsynced what the crash did to writes that were not flushed
   */
  void restart(RobotId robot, Unsynced unsynced);

  /** Ends a robot's program at once and takes its body away: it says nothing more. */
  void leave(RobotId robot);

  /**
   * Puts a robot's body on the floor at its start, if nothing is in its way there.
   *
   * @return whether it stands there now
   */
  boolean putOnFloor(RobotId robot);

  /** Whether a robot's body would touch nothing there. */
  boolean isFree(Pose pose);

  /** Takes a robot's body off the floor; its program goes on. */
  void takeOffFloor(RobotId robot);

  boolean isOnFloor(RobotId robot);

  /** Where the body truly is now; it must be on the floor. */
  Pose truePose(RobotId robot);

  /** How the robot's latest motion stands, by its own account. */
  MotionFlag motionflag(RobotId robot);

  /** Whether the robot's app has come to its end. */
  boolean isFinished(RobotId robot);

  /** The radio, for rules that come and go. */
  SimNetwork network();
}
