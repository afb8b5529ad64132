package org.starl.comms;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.platform.DeploymentKey;
import org.starl.platform.Platform;
import org.starl.platform.Radio;
import org.starl.trace.TraceSink;

/**
 * {@code gvh.comms}: this robot's messages. Strand only.
 *
 * <p>What arrives and is no message for this robot is counted ({@link #dropped}), and logged once a
 * reason; it never throws. Plain messages are not de-duplicated; reliable ones are handled once by
 * each incarnation of the receiver, and acknowledged after their handler ran. Where the platform has a
 * key, every datagram is sealed with it, and what is not, or arrives again, is dropped.
 */
public final class Comms {

  private static final Spare<DatagramWriter> WRITERS = new Spare<>(DatagramWriter::new);

  private final Radio radio;
  private final RobotId self;
  private final int selfHash;
  private final byte[] selfName;
  private final int boot;
  private final LamportClock lamportClock = new LamportClock();
  private final TraceSink trace;
  private final @Nullable Seal seal;
  private @Nullable ReliableSender reliable;
  private long lastNumber;
  private long sent;

  // What a plain message does not need.
  private final Inbound inbound;
  private final Bookkeeping books;
  private final Platform platform;

  /**
   * @param boot how often this robot's program has started, from 1
   */
  public Comms(Platform platform, int boot) {
    if (boot <= 0) {
      throw new IllegalArgumentException("boot number " + boot + ": expected above 0");
    }
    this.platform = platform;
    this.self = platform.id();
    this.selfHash = self.hashCode();
    this.selfName = self.name().getBytes(StandardCharsets.US_ASCII);
    this.radio = platform.radio();
    this.boot = boot;
    this.trace = platform.trace();
    this.books = new Bookkeeping(platform);
    DeploymentKey key = platform.key();
    this.seal = key == null ? null : new Seal(key);
    this.inbound = new Inbound(this, selfName, platform.deployment(), lamportClock, trace, seal);
    radio.onReceive(inbound);
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
    if (inbound.isOpen(channel)) {
      throw new IllegalStateException("channel " + channel.name() + " is open already");
    }
    OpenEndpoint<T> endpoint = new OpenEndpoint<>(this, channel, handler);
    inbound.open(endpoint);
    return endpoint;
  }

  /** Datagrams sent: messages, repeated ones, acknowledgements; those to this robot as well. */
  public long sent() {
    return sent;
  }

  /** Datagrams that arrived, dropped ones included. */
  public long received() {
    return inbound.received();
  }

  /** Datagrams that arrived and were dropped for this reason. */
  public long dropped(DropReason reason) {
    return books.dropped(reason);
  }

  Bookkeeping books() {
    return books;
  }

  <T> void send(OpenEndpoint<T> endpoint, @Nullable RobotId to, T message) {
    long number = ++lastNumber;
    DatagramWriter writer = WRITERS.take();
    writer.begin(Header.PLAIN, selfName, boot, number, lamportClock.now(), to);
    int length = writer.message(endpoint, message, 0);
    if (trace.isOn()) {
      books.sent(to, endpoint.channel, number, length, message);
    }
    emit(to, writer.buffer(), length);
    WRITERS.giveBack(writer);
  }

  <T> Receipt sendReliably(
      OpenEndpoint<T> endpoint, RobotId to, T message, Reliability reliability) {
    if (reliable == null) {
      reliable = new ReliableSender(platform.clock(), platform.timers(), this::transmit);
    }
    long number = ++lastNumber;
    long order = reliable.nextOrder(to);
    DatagramWriter writer = WRITERS.take();
    writer.begin(Header.RELIABLE, selfName, boot, number, lamportClock.now(), to);
    int length = writer.message(endpoint, message, order);
    byte[] datagram = Arrays.copyOf(writer.buffer(), length);
    WRITERS.giveBack(writer);
    return reliable.send(to, new RetainedMessage(endpoint, message, number, datagram), reliability);
  }

  void close(OpenEndpoint<?> endpoint) {
    inbound.close(endpoint);
    if (reliable != null) {
      reliable.fail(endpoint);
    }
  }

  /** Acknowledges message {@code order} of the incarnation {@code ackedBoot} of {@code to}. */
  void acknowledge(RobotId to, int ackedBoot, long order) {
    if (isSelf(to)) {
      settle(to, ackedBoot, order);
      return;
    }
    long number = ++lastNumber;
    DatagramWriter writer = WRITERS.take();
    writer.begin(Header.ACK, selfName, boot, number, lamportClock.now(), to);
    int length = writer.acknowledgement(ackedBoot, order);
    if (trace.isOn()) {
      books.sentAcknowledgement(to, order, number, length);
    }
    emit(to, writer.buffer(), length);
    WRITERS.giveBack(writer);
  }

  /** {@code from} has handled message {@code order} of this robot's incarnation {@code ackedBoot}. */
  void settle(RobotId from, int ackedBoot, long order) {
    boolean isNews = ackedBoot == boot && reliable != null && reliable.acknowledged(from, order);
    if (!isNews) {
      books.dropped(DropReason.STALE_ACK, from, "");
    }
  }

  private void transmit(Outgoing<RetainedMessage> outgoing) {
    RetainedMessage retained = outgoing.content;
    byte[] datagram = retained.datagram;
    DatagramWriter.setClock(datagram, lamportClock.now());
    if (trace.isOn()) {
      books.sent(
          outgoing.to,
          retained.endpoint.channel,
          retained.number,
          datagram.length,
          retained.message);
    }
    emit(outgoing.to, datagram, datagram.length);
  }

  private void emit(@Nullable RobotId to, byte[] buffer, int length) {
    sent++;
    if (to != null && isSelf(to)) {
      byte[] datagram = Arrays.copyOf(buffer, length);
      platform.strand().post(() -> inbound.receivedFromSelf(datagram));
    } else if (seal == null) {
      radiate(to, buffer, length);
    } else {
      int sealedLength = seal.seal(buffer, length);
      radiate(to, seal.buffer(), sealedLength);
    }
  }

  // By the hash first: the robot's own id is mostly cold.
  private boolean isSelf(RobotId robot) {
    return robot.hashCode() == selfHash && robot.equals(self);
  }

  private void radiate(@Nullable RobotId to, byte[] buffer, int length) {
    if (to == null) {
      radio.broadcast(buffer, length);
    } else {
      radio.send(to, buffer, length);
    }
  }
}
