package org.starl.robot.create;

import java.util.List;

/**
 * The current state of driver and robot. Immutable.
 *
 * @param holds the reasons that stop or limit the wheels, worst first; empty if they obey
 * @param sensors the robot's last sensor frame, however old
 * @param frames good sensor frames since the driver started
 * @param badFrames frames with a wrong checksum
 * @param droppedBytes bytes that were in no good frame
 * @param starts number of starts of the robot: one for each link, and one after each silence
 * @param recoveries number of times that the driver restored the mode
 * @param linksLost number of broken links
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
