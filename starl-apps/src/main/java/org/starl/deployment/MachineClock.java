package org.starl.deployment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.starl.deploy.realtime.RealClock;
import org.starl.processes.Outbox;
import org.starl.processes.Word;

/** Which clock a trace's times are on, for {@link Merge}. */
final class MachineClock {

  /** Where Linux names the start of the machine, which its monotonic clock counts from. */
  private static final Path BOOT_ID = Path.of("/proc/sys/kernel/random/boot_id");

  /** What a machine is called that does not say which it is. */
  static final String UNKNOWN = "?";

  private MachineClock() {}

  /** Says what time 0 of a trace is, which {@code clock} shows as {@code startNs}. */
  static void tell(Outbox trace, RealClock clock, long startNs) {
    long machineNs = clock.originNs() + startNs;
    trace.say(() -> 0, Word.CLOCK, machine(), machineNs, startNs);
  }

  private static String machine() {
    try {
      return Files.exists(BOOT_ID) ? Files.readString(BOOT_ID).strip() : UNKNOWN;
    } catch (IOException e) {
      return UNKNOWN;
    }
  }
}
