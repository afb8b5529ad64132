package org.starl.robot.udp;

import java.nio.ByteBuffer;
import org.starl.platform.Stable;

/**
 * Numbers the starts of one robot's program, for its beacons: each number is above those before, also on
 * a machine whose date goes back when its power does (small boards have no clock of their own). By the
 * date alone such a robot would be taken for a recording until its date is again what it was.
 */
public final class StartNumber {

  private static final String KEY = "starl.start";

  private StartNumber() {}

  /**
   * The number of a start.
   *
   * @param stable the robot's; its strand does not use it yet
   * @param dateNs by this machine; it counts where it is above all numbers before, and where the robot's
   *     storage was lost
   */
  public static long next(Stable stable, long dateNs) {
    byte[] last = stable.get(KEY);
    long number =
        last == null || last.length != Long.BYTES
            ? dateNs
            : Math.max(dateNs, ByteBuffer.wrap(last).getLong() + 1);
    // A crash before it is on the disk leaves the one before, and a date that goes on from here.
    stable.put(KEY, ByteBuffer.allocate(Long.BYTES).putLong(number).array(), () -> {});
    return number;
  }
}
