package org.starl.robot.trace;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import org.starl.robot.realtime.RealClock;

/** Records the clock of a trace's times, so that the trace can be merged with others. */
public final class MachineClock {

  /** Linux's id of the machine's present boot, from which its monotonic clock counts. */
  private static final Path BOOT_ID = Paths.get("/proc/sys/kernel/random/boot_id");

  /** The name of a machine that has no such id. */
  public static final String UNKNOWN = "?";

  private MachineClock() {}

  /** Records the machine's time at the trace's time 0, when {@code clock} shows {@code startNs}. */
  public static void tell(ProcessTrace trace, RealClock clock, long startNs) {
    long machineNs = clock.originNs() + startNs;
    trace.report(() -> 0, new ProcessFact.Clock(machine(), machineNs, startNs));
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
