package org.starl.processes;

import java.util.List;
import java.util.SortedMap;
import org.starl.id.RobotId;
import org.starl.sim.SimResult;

/**
 * What came of a fleet's run.
 *
 * @param run as of a simulation, over the merged trace; {@code unfinished} are those who live
 * @param rounds how often each robot's app came to its end
 * @param deaths processes that ended before the run did, in that order
 * @param errors bugs that ended a process, with their stack traces
 * @param longestSilenceNs the longest that a strand was kept from running by whatever else the machine
 *     did
 */
public record FleetResult(
    SimResult run,
    SortedMap<RobotId, Integer> rounds,
    List<Death> deaths,
    List<String> errors,
    long longestSilenceNs) {

  /**
   * A process that ended early.
   *
   * @param atNs its last sign of life, or when it was killed
   * @param wasAsked whether it was killed as the settings said
   * @param status of the process, 128 and the signal's number if one ended it
   */
  public record Death(RobotId robot, long pid, long atNs, boolean wasAsked, int status) {

    private static final int SIGNALLED = 128;

    /** Whether somebody killed it; else it ended by itself. */
    public boolean wasKilled() {
      return wasAsked || status > SIGNALLED;
    }
  }

  /** Whether nothing that must not happen has happened. */
  public boolean isSafe() {
    return run.spec().holds() && errors.isEmpty() && deaths.stream().allMatch(Death::wasKilled);
  }

  /** Safe, and everybody came to the end, but for what somebody's death explains. */
  public boolean isGood() {
    return isSafe() && (run.isFinished() || !deaths.isEmpty());
  }
}
