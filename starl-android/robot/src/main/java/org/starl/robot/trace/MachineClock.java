package org.starl.robot.trace;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import org.starl.robot.realtime.RealClock;

/** Which clock a trace's times are on, for those who merge it with others. */
public final class MachineClock {

  /** Where Linux names the start of the machine, which its monotonic clock counts from. */
  private static final Path BOOT_ID = Paths.get("/proc/sys/kernel/random/boot_id");

  /** What a machine is called that does not say which it is. */
  public static final String UNKNOWN = "?";

  private MachineClock() {}

  /** Says what time 0 of a trace is, which {@code clock} shows as {@code startNs}. */
  public static void tell(Outbox trace, RealClock clock, long startNs) {
    long machineNs = clock.originNs() + startNs;
    trace.say(() -> 0, Word.CLOCK, machine(), machineNs, startNs);
  }

  private static String machine() {
    try {
      return Files.exists(BOOT_ID)
          ? new String(Files.readAllBytes(BOOT_ID), StandardCharsets.US_ASCII).trim()
          : UNKNOWN;
    } catch (IOException e) {
      return UNKNOWN;
    }
  }
}
