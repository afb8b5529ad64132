package org.starl.sim.fault;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.sim.net.SimNetwork;
import org.starl.sim.world.Body;
import org.starl.sim.world.Unsynced;
import org.starl.sim.world.World;

/** What faults can do to a run: its levers. Times in ns from the start of the run. */
public interface Ward {

  long nowNs();

  /** Runs {@code action} at {@code atNs}, or now, later in order, if that is past. */
  void at(long atNs, Runnable action);

  /** The robots that are there, crashed ones included, in the order in which they came. */
  List<RobotId> robots();

  /** Whether the robot is or was there. */
  boolean isKnown(RobotId robot);

  /** Whether the robot is there, and has not crashed. */
  boolean isUp(RobotId robot);

  /** Ends the program of a robot that is up, for good. */
  void crash(RobotId robot);

  /** Ends the program of a robot that is up, and restarts it after {@code downNs}. */
  void crash(RobotId robot, long downNs, Unsynced unsynced);

  SimNetwork network();

  World world();

  /** The robot's body, or null while it has none on the floor. */
  @Nullable Body body(RobotId robot);

  /**
   * Impairs a robot in this and every later incarnation, or all robots and those that are to come,
   * until the returned cure runs.
   *
   * @param robot null for all
   */
  Runnable impair(@Nullable RobotId robot, Impairment impairment);

  /** Tells everybody who watches: an event of kind {@code fault}. */
  void tell(RobotId robot, String name, String detail);
}
