package org.starl.robot.create;

import java.util.List;

/**
 * How driver and robot are now, for people and for tests. Immutable.
 *
 * @param holds what holds the wheels, worst first; none where they do as they are told
 * @param sensors what the robot said last, however long ago
 * @param frames good frames of sensors, since the driver began
 * @param badFrames frames with a wrong checksum
 * @param droppedBytes bytes that were in no good frame
 * @param starts how often the robot was started: once a link, and when it had fallen silent
 * @param recoveries how often it was brought back from another mode
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
    for (CreateHold hold : holds) {
      if (hold.isWhole()) {
        return false;
      }
    }
    return true;
  }
}
