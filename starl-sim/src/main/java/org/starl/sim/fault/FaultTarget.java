package org.starl.sim.fault;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.sim.net.SimNetwork;
import org.starl.sim.world.Body;
import org.starl.sim.world.Unsynced;
import org.starl.sim.world.World;

/** The operations on a run that faults use. Times are in ns from the start of the run. */
public interface FaultTarget {

  long nowNs();

  /**
   * Runs {@code action} at {@code atNs} or, if that is in the past, now, after the events of this
   * time.
   */
  void at(long atNs, Runnable action);

  /** The robots that have joined and not left, crashed ones included, in joining order. */
  List<RobotId> robots();

  /** Whether the robot has ever joined. */
  boolean isKnown(RobotId robot);

  /** Whether the robot has joined and neither left nor crashed. */
  boolean isUp(RobotId robot);

  /** The number of the robot's writes to stable storage that a crash would lose now. */
  int unflushed(RobotId robot);

  /** Whether one of these is to a variable that the robot writes no more often than half of them. */
  boolean isRareUnflushed(RobotId robot);

  /** Crashes the program of a robot that is up, without restart. */
  void crash(RobotId robot);

  /** Crashes the program of a robot that is up, and restarts it after {@code downNs}. */
  void crash(RobotId robot, long downNs, Unsynced unsynced);

  SimNetwork network();

  World world();

  /** The robot's body, or null while it is off the floor. */
  @Nullable Body body(RobotId robot);

  /**
   * Impairs a robot in this and every later incarnation, or all robots including later ones, until
   * the returned action runs.
   *
   * @param robot null for all robots
   */
  Runnable impair(@Nullable RobotId robot, Impairment impairment);

  /** Records an event of kind {@code fault} in the trace. */
  void recordFault(RobotId robot, String name, String effect, String detail);
}
