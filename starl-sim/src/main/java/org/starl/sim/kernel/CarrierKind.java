package org.starl.sim.kernel;

import org.jspecify.annotations.Nullable;

/** Thread type for blocking apps. The order of events is the same on both. */
public enum CarrierKind {

  /** A virtual thread that is scheduled by the kernel: fast and small. */
  VIRTUAL,

  /** A platform thread that alternates with the kernel: works on every Java runtime. */
  PLATFORM;

  private static final int FIRST_GOOD_JDK = 24;

  /** The fastest kind that this Java runtime supports. */
  public static CarrierKind best() {
    return fallbackReason() == null ? VIRTUAL : PLATFORM;
  }

  /** A line with the reason if {@link #best} is not {@link #VIRTUAL}; otherwise null. */
  public static @Nullable String fallbackReason() {
    String obstacle;
    if (Runtime.version().feature() < FIRST_GOOD_JDK) {
      // Before Java 24, a virtual thread that waits inside synchronized blocks the kernel's thread.
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
