package org.starl.comms;

import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.platform.LogSink;
import org.starl.platform.Platform;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceSink;

/** Traces and logs datagrams, and counts dropped ones. */
final class DatagramLog {

  /** The channel of acknowledgements in the trace. Without a slash, it is not a channel's name. */
  private static final String ACK = "ack";

  private final Platform platform;
  private final TraceSink trace;
  private long @Nullable [] drops;

  DatagramLog(Platform platform) {
    this.platform = platform;
    this.trace = platform.trace();
  }

  long dropped(DropReason reason) {
    return drops == null ? 0 : drops[reason.ordinal()];
  }

  /** Traces a sent message; {@code to} is null for a broadcast. */
  void sent(@Nullable RobotId to, Channel<?> channel, long number, int bytes, Object message) {
    traceSent(to == null ? "*" : to.name(), channel.name(), number, bytes, message.toString());
  }

  /** Traces a sent acknowledgement of message {@code order} of {@code to}. */
  void sentAcknowledgement(RobotId to, long order, long number, int bytes) {
    traceSent(to.name(), ACK, number, bytes, ACK + " " + order);
  }

  private void traceSent(String to, String channel, long number, int bytes, String message) {
    trace.record(new TraceEvent.Sent(now(), platform.id(), to, channel, number, bytes, message));
  }

  /** Traces a message that is passed to its handler. */
  void delivered(RobotId from, Channel<?> channel, long number, Object message) {
    trace.record(
        new TraceEvent.Delivered(
            now(), platform.id(), from, channel.name(), number, message.toString()));
  }

  /**
   * Counts a dropped datagram, traces it, and logs the first one for each reason; {@code from} is
   * null for an unknown sender.
   */
  void dropped(DropReason reason, @Nullable RobotId from, String detail) {
    if (drops == null) {
      drops = new long[DropReason.values().length];
    }
    drops[reason.ordinal()]++;
    String sender = from == null ? "?" : from.name();
    if (drops[reason.ordinal()] == 1) {
      log(reason, "from " + sender + ": " + reason + (detail.isEmpty() ? "" : " (" + detail + ")"));
    }
    if (trace.isOn()) {
      trace.record(new TraceEvent.Dropped(now(), platform.id(), sender, reason.toString()));
    }
  }

  private void log(DropReason reason, String what) {
    LogSink.Level level = reason.isSuspicious() ? LogSink.Level.WARN : LogSink.Level.DEBUG;
    String line = "dropped a datagram " + what + "; more of these are only counted";
    platform.log().log(now(), level, "comms", line);
  }

  private long now() {
    return platform.clock().nowNs();
  }
}
