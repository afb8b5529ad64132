package org.starl.robot.create;

import java.util.List;

/**
 * The present state of driver and robot, for people and tests. Immutable.
 *
 * @param holds the reasons for which the wheels are held, worst first; empty if they obey
 * @param sensors the robot's last sensor frame, however old
 * @param frames good sensor frames since the driver started
 * @param badFrames frames with a wrong checksum
 * @param droppedBytes bytes that were in no good frame
 * @param starts how often the robot was started: once for each link, and after each silence
 * @param recoveries how often it was brought back into its mode
 * @param linksLost how often the link broke
 */
public record CreateStatus(
    List<CreateHold> holds,
    CreateSensors sensors,
    long frames,
    long badFrames,
    long droppedBytes,
    long starts,
    long recoveries,
    long linksLost) {

  public CreateStatus {
    holds = List.copyOf(holds);
  }

  /** Whether the wheels may turn. */
  public boolean mayDrive() {
    return holds.stream().noneMatch(CreateHold::isWhole);
  }
}
