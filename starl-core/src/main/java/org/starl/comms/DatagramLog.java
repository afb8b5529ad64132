package org.starl.comms;

import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.platform.LogSink;
import org.starl.platform.Platform;
import org.starl.shape.Shape;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceSink;

/** Traces and logs datagrams, and counts dropped ones. */
final class DatagramLog {

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
    String receiver = to == null ? TraceEvent.Sent.ALL : to.name();
    traceSent(receiver, channel.instance(), number, bytes, channel.shape(), message);
  }

  /** Traces a sent acknowledgement of message {@code order} of {@code to}. */
  void sentAcknowledgement(RobotId to, long order, long number, int bytes) {
    traceSent(to.name(), Ack.CHANNEL, number, bytes, Ack.SHAPE, new Ack(order));
  }

  private void traceSent(
      String to, Instance channel, long number, int bytes, Shape<?> shape, Object message) {
    trace.record(
        new TraceEvent.Sent(now(), platform.id(), to, channel, number, bytes, shape, message));
  }

  /** Traces a message that is passed to its handler. */
  void delivered(RobotId from, Channel<?> channel, long number, Object message) {
    trace.record(
        new TraceEvent.Delivered(
            now(), platform.id(), from, channel.instance(), number, channel.shape(), message));
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
