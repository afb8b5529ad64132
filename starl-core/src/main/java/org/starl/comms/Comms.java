package org.starl.comms;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.starl.RobotId;
import org.starl.platform.Platform;
import org.starl.platform.Timer;
import org.starl.trace.TraceEvent;

/**
 * {@code gvh.comms}: this robot's messages. Strand only.
 *
 * <p>What arrives and is no message for this robot is counted ({@link #dropped}), and logged once a
 * reason; it never throws. Plain messages are not de-duplicated; reliable ones are handled once by
 * each incarnation of the receiver, and acknowledged after their handler ran.
 */
public final class Comms {

  private static final String ACK = "ack";

  private final Platform platform;
  private final int boot;
  private final LamportClock lamportClock = new LamportClock();
  private final DatagramWriter writer;
  private final Header header = new Header();
  private final WireReader body = new WireReader();
  private final RobotNames robots = new RobotNames();
  private final Endpoints endpoints = new Endpoints();
  private final InboundWindows inbound = new InboundWindows();
  private final OutboundQueue<RetainedMessage> outbound = new OutboundQueue<>(this::transmit);
  private final Drops drops;
  private @Nullable Timer timer;
  private long timerNs = Long.MAX_VALUE;
  private long lastNumber;
  private long sent;
  private long received;

  /**
   * @param boot how often this robot's program has started, from 1
   */
  public Comms(Platform platform, int boot) {
    if (boot <= 0) {
      throw new IllegalArgumentException("boot number " + boot + ": expected above 0");
    }
    this.platform = platform;
    this.boot = boot;
    this.writer = new DatagramWriter(platform.id(), boot);
    this.drops = new Drops(platform);
    platform.radio().onReceive((buffer, length) -> received(buffer, length, false));
  }

  /** The robot's logical clock; every datagram carries and witnesses it. */
  public LamportClock lamportClock() {
    return lamportClock;
  }

  /**
   * Opens this robot's end of a channel; messages that come before are not acknowledged.
   *
   * @throws IllegalStateException if it is open already
   */
  public <T> Endpoint<T> open(Channel<T> channel, Endpoint.Handler<T> handler) {
    OpenEndpoint<T> endpoint = new OpenEndpoint<>(this, channel, handler);
    if (endpoints.find(endpoint.name, 0, endpoint.name.length) != null) {
      throw new IllegalStateException("channel " + channel.name() + " is open already");
    }
    endpoints.add(endpoint);
    return endpoint;
  }

  /** Datagrams sent: messages, repeated ones, acknowledgements; those to this robot as well. */
  public long sent() {
    return sent;
  }

  /** Datagrams that arrived, dropped ones included. */
  public long received() {
    return received;
  }

  /** Datagrams that arrived and were dropped for this reason. */
  public long dropped(DropReason reason) {
    return drops.count(reason);
  }

  <T> void send(OpenEndpoint<T> endpoint, @Nullable RobotId to, T message) {
    long number = ++lastNumber;
    int length = writer.message(endpoint, to, message, number, 0, lamportClock.now());
    if (platform.trace().isOn()) {
      traceSent(to, endpoint.channel.name(), number, length, message);
    }
    emit(to, writer.buffer(), length);
  }

  <T> Receipt sendReliably(
      OpenEndpoint<T> endpoint, RobotId to, T message, Reliability reliability) {
    long number = ++lastNumber;
    long order = outbound.nextOrder(to);
    int length = writer.message(endpoint, to, message, number, order, lamportClock.now());
    byte[] datagram = Arrays.copyOf(writer.buffer(), length);
    RetainedMessage retained = new RetainedMessage(endpoint, message, number, datagram);
    Receipt receipt = outbound.send(to, retained, reliability, now());
    setTimer();
    return receipt;
  }

  void close(OpenEndpoint<?> endpoint) {
    endpoints.remove(endpoint);
    outbound.fail(retained -> retained.endpoint == endpoint, now());
    setTimer();
  }

  private void transmit(Outgoing<RetainedMessage> outgoing) {
    RetainedMessage retained = outgoing.content;
    byte[] datagram = retained.datagram;
    DatagramWriter.setClock(datagram, lamportClock.now());
    if (platform.trace().isOn()) {
      String channel = retained.endpoint.channel.name();
      traceSent(outgoing.to, channel, retained.number, datagram.length, retained.message);
    }
    emit(outgoing.to, datagram, datagram.length);
  }

  private void emit(@Nullable RobotId to, byte[] buffer, int length) {
    sent++;
    if (to == null) {
      platform.radio().broadcast(buffer, length);
    } else if (to.equals(platform.id())) {
      byte[] datagram = Arrays.copyOf(buffer, length);
      platform.strand().post(() -> received(datagram, datagram.length, true));
    } else {
      platform.radio().send(to, buffer, length);
    }
  }

  private void advance() {
    timerNs = Long.MAX_VALUE;
    outbound.advance(now());
    setTimer();
  }

  private void setTimer() {
    long dueNs = outbound.nextDueNs();
    if (dueNs == timerNs) {
      return;
    }
    if (timer == null) {
      timer = platform.timers().timer(this::advance);
    }
    timerNs = dueNs;
    if (dueNs == Long.MAX_VALUE) {
      timer.cancel();
    } else {
      timer.set(dueNs);
    }
  }

  private void received(byte[] buffer, int length, boolean fromSelf) {
    received++;
    DropReason malformed = header.parse(buffer, length);
    if (malformed != null) {
      drops.add(malformed, null, length + " bytes");
      return;
    }
    RobotId from = robots.find(buffer, header.senderAt, header.senderLength);
    if (from == null) {
      drops.add(DropReason.BAD_NAME, null, "sender");
      return;
    }
    DropReason refused = refusal(buffer, from, fromSelf);
    if (refused != null) {
      drops.add(refused, from, "");
      return;
    }
    lamportClock.witness(header.clock);
    body.reset(buffer, header.bodyAt, length);
    if (header.kind == Header.ACK) {
      acknowledged(from);
    } else {
      message(buffer, from);
    }
  }

  private @Nullable DropReason refusal(byte[] buffer, RobotId from, boolean fromSelf) {
    if (!fromSelf && from.equals(platform.id())) {
      return DropReason.OWN;
    }
    boolean isForUs =
        header.addresseeLength == 0
            || ByteNames.equal(
                writer.senderName(), buffer, header.addresseeAt, header.addresseeLength);
    return isForUs ? inbound.admit(from, header.boot) : DropReason.NOT_FOR_US;
  }

  private void acknowledged(RobotId from) {
    int ackedBoot;
    long order;
    try {
      ackedBoot = body.i32();
      order = body.i64();
      body.expectEnd();
    } catch (WireFormatException e) {
      drops.add(DropReason.BAD_PAYLOAD, from, "acknowledgement: " + e.getMessage());
      return;
    }
    settle(from, ackedBoot, order);
  }

  private void settle(RobotId from, int ackedBoot, long order) {
    if (ackedBoot == boot && outbound.acknowledged(from, order, now())) {
      setTimer();
    } else {
      drops.add(DropReason.STALE_ACK, from, "");
    }
  }

  private void message(byte[] buffer, RobotId from) {
    long order = 0;
    if (header.kind == Header.RELIABLE) {
      if (body.remaining() < Long.BYTES) {
        drops.add(DropReason.TRUNCATED, from, "no order");
        return;
      }
      order = body.i64();
      DropReason refused = order <= 0 ? DropReason.BAD_FIELD : inbound.refusal(from, order);
      if (refused != null) {
        drops.add(refused, from, "");
        if (refused == DropReason.DUPLICATE) {
          acknowledge(from, header.boot, order);
        }
        return;
      }
    }
    OpenEndpoint<?> endpoint = endpoints.find(buffer, header.channelAt, header.channelLength);
    if (endpoint == null) {
      dropUnheard(buffer, from);
    } else {
      deliver(endpoint, from, order);
    }
  }

  private void dropUnheard(byte[] buffer, RobotId from) {
    String name =
        new String(buffer, header.channelAt, header.channelLength, StandardCharsets.ISO_8859_1);
    if (Channel.isName(name)) {
      drops.add(DropReason.NO_LISTENER, from, name);
    } else {
      drops.add(DropReason.BAD_NAME, from, "channel");
    }
  }

  private <T> void deliver(OpenEndpoint<T> endpoint, RobotId from, long order) {
    T message;
    try {
      message = endpoint.channel.codec().read(body);
      body.expectEnd();
    } catch (WireFormatException | IllegalArgumentException e) {
      drops.add(DropReason.BAD_PAYLOAD, from, endpoint.channel.name() + ": " + e.getMessage());
      return;
    }
    int senderBoot = header.boot;
    if (order > 0) {
      inbound.handle(from, senderBoot, order);
    }
    if (platform.trace().isOn()) {
      String channel = endpoint.channel.name();
      String text = String.valueOf(message);
      platform
          .trace()
          .record(
              new TraceEvent.Delivered(now(), platform.id(), from, channel, header.number, text));
    }
    endpoint.handler.received(from, message);
    if (order > 0) {
      acknowledge(from, senderBoot, order);
    }
  }

  private void acknowledge(RobotId to, int ackedBoot, long order) {
    if (to.equals(platform.id())) {
      settle(to, ackedBoot, order);
      return;
    }
    long number = ++lastNumber;
    int length = writer.acknowledgement(to, ackedBoot, order, number, lamportClock.now());
    if (platform.trace().isOn()) {
      traceSent(to, ACK, number, length, ACK + " " + order);
    }
    emit(to, writer.buffer(), length);
  }

  private void traceSent(
      @Nullable RobotId to, String channel, long number, int bytes, Object message) {
    String addressee = to == null ? "*" : to.name();
    platform
        .trace()
        .record(
            new TraceEvent.Sent(
                now(), platform.id(), addressee, channel, number, bytes, String.valueOf(message)));
  }

  private long now() {
    return platform.clock().nowNs();
  }
}
