package org.starl.comms;

import org.jspecify.annotations.Nullable;
import org.starl.RobotId;
import org.starl.platform.LogSink;
import org.starl.platform.Platform;
import org.starl.trace.TraceEvent;

/** Counts what is dropped, by reason; logs each reason once. */
final class Drops {

  private final Platform platform;
  private final long[] counts = new long[DropReason.values().length];

  Drops(Platform platform) {
    this.platform = platform;
  }

  long count(DropReason reason) {
    return counts[reason.ordinal()];
  }

  void add(DropReason reason, @Nullable RobotId from, String detail) {
    counts[reason.ordinal()]++;
    String sender = from == null ? "?" : from.name();
    if (counts[reason.ordinal()] == 1) {
      LogSink.Level level = reason.isSuspicious() ? LogSink.Level.WARN : LogSink.Level.DEBUG;
      String line =
          "dropped a datagram from "
              + sender
              + ": "
              + reason
              + (detail.isEmpty() ? "" : " (" + detail + ")")
              + "; more of these are only counted";
      platform.log().log(platform.clock().nowNs(), level, "comms", line);
    }
    if (platform.trace().isOn()) {
      platform
          .trace()
          .record(
              new TraceEvent.Dropped(
                  platform.clock().nowNs(), platform.id(), sender, reason.toString()));
    }
  }
}
