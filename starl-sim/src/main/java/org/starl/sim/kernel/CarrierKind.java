package org.starl.sim.kernel;

import org.jspecify.annotations.Nullable;

/** Thread type for blocking apps. The order of events is the same on both. */
public enum CarrierKind {

  /** A virtual thread whose scheduler is the kernel: fast and small. */
  VIRTUAL,

  /** A platform thread that takes turns with the kernel: runs everywhere. */
  PLATFORM;

  private static final int FIRST_GOOD_JDK = 24;

  /** The best kind that this Java runtime allows. */
  public static CarrierKind best() {
    return fallbackReason() == null ? VIRTUAL : PLATFORM;
  }

  /** One line that says why {@link #best} is not {@link #VIRTUAL}, or null if it is. */
  public static @Nullable String fallbackReason() {
    String obstacle;
    if (Runtime.version().feature() < FIRST_GOOD_JDK) {
      // Before, a virtual thread that waits inside synchronized blocks the kernel's own thread.
      obstacle = "need Java 24 or later, and this is Java " + Runtime.version().feature();
    } else if (!Object.class.getModule().isOpen("java.lang", CarrierKind.class.getModule())) {
      obstacle = "need the option --add-opens java.base/java.lang=ALL-UNNAMED";
    } else if (!VirtualCarrier.isSupported()) {
      obstacle = "cannot be had from Java " + Runtime.version();
    } else {
      return null;
    }
    return "virtual threads on the kernel "
        + obstacle
        + ": robots run on platform threads, slower but with the same results";
  }
}
