package org.starl.robot.udp;

import java.nio.ByteBuffer;
import org.starl.platform.StableStorage;

/**
 * Numbers the starts of one robot's program, for its beacons. Each number is larger than all before,
 * even if the machine's date jumps back when it loses power (small boards have no battery clock). By
 * the date alone such a robot's beacons would be dropped as old ones until its date has caught up.
 */
public final class StartNumber {

  private static final String KEY = "starl.start";

  private StartNumber() {}

  /**
   * The number of a start.
   *
   * @param stable the robot's; its strand does not use it yet
   * @param dateNs this machine's date; used if it is larger than all numbers before, or if the robot's
   *     storage was lost
   */
  public static long next(StableStorage stable, long dateNs) {
    byte[] last = stable.get(KEY);
    long number =
        last == null || last.length != Long.BYTES
            ? dateNs
            : Math.max(dateNs, ByteBuffer.wrap(last).getLong() + 1);
    // After a crash before this write the old number is read, and the date is then later than now.
    stable.put(KEY, ByteBuffer.allocate(Long.BYTES).putLong(number).array(), () -> {});
    return number;
  }
}
