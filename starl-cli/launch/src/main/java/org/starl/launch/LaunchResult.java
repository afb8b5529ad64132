package org.starl.launch;

import java.util.List;
import java.util.SortedMap;
import org.starl.id.RobotId;
import org.starl.sim.SimResult;

/**
 * The result of robots that ran as processes.
 *
 * @param run as of a simulation, over the merged trace; {@code unfinished} has only live robots
 * @param rounds number of times that each robot's app has finished
 * @param deaths processes that ended before the run did, in order of time
 * @param errors bugs that ended a process, with their stack traces
 * @param longestPauseNs the longest time in which a robot's program did not run
 */
public record LaunchResult(
    SimResult run,
    SortedMap<RobotId, Integer> rounds,
    List<Death> deaths,
    List<String> errors,
    long longestPauseNs) {

  /**
   * A process that ended early.
   *
   * @param atNs the time of its last message, or of the kill
   * @param isPlanned whether the settings asked to kill it
   * @param status exit status; 128 plus the number of the signal that ended it
   */
  public record Death(RobotId robot, long pid, long atNs, boolean isPlanned, int status) {

    private static final int SIGNALLED = 128;

    /** Whether a signal ended it; else it ended by itself. */
    public boolean isKill() {
      return isPlanned || status > SIGNALLED;
    }
  }

  /** Whether all specifications held and no process ended by a bug. */
  public boolean isSafe() {
    return run.spec().holds() && errors.isEmpty() && deaths.stream().allMatch(Death::isKill);
  }

  /** Safe, and each app has finished, unless a robot has died. */
  public boolean isGood() {
    return isSafe() && (run.isFinished() || !deaths.isEmpty());
  }
}
