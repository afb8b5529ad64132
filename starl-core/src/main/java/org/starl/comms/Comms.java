package org.starl.comms;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.platform.Platform;
import org.starl.platform.Radio;
import org.starl.session.Sessions;
import org.starl.trace.TraceSink;

/**
 * {@code gvh.comms}: sends and receives this robot's messages. Strand only.
 *
 * <p>A datagram that is not a valid message for this robot is counted ({@link #dropped}) and logged
 * once per reason; it never causes an exception. Plain messages are not de-duplicated. Each
 * incarnation of the receiver handles a reliable message once, and acknowledges it after the
 * handler has run. If the platform has sessions, every datagram is sealed for its receiver; forged
 * and replayed datagrams are dropped, and a broadcast is one datagram to each robot.
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

  // Not used by plain messages.
  private final DatagramReceiver receiver;
  private final DatagramLog log;
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
    this.log = new DatagramLog(platform);
    Sessions sessions = platform.sessions();
    this.seal = sessions == null ? null : new Seal(sessions);
    this.receiver =
        new DatagramReceiver(this, selfName, platform.deployment(), lamportClock, trace, seal);
    radio.onReceive(receiver);
  }

  /**
   * The robot's logical clock: every datagram sent carries its value, and every datagram received
   * advances it.
   */
  public LamportClock lamportClock() {
    return lamportClock;
  }

  /**
   * Opens this robot's endpoint of a channel. Messages that arrive before are dropped and not
   * acknowledged.
   *
   * @throws IllegalStateException if it is open already
   */
  public <T> Endpoint<T> open(Channel<T> channel, Endpoint.Handler<T> handler) {
    if (receiver.isOpen(channel)) {
      throw new IllegalStateException("channel " + channel.name() + " is open already");
    }
    OpenEndpoint<T> endpoint = new OpenEndpoint<>(this, channel, handler);
    receiver.open(endpoint);
    return endpoint;
  }

  /**
   * Number of datagrams sent: messages, retransmissions and acknowledgements, including those to
   * this robot.
   */
  public long sent() {
    return sent;
  }

  /** Number of datagrams received, including dropped ones. */
  public long received() {
    return receiver.received();
  }

  /** Number of received datagrams that were dropped for this reason. */
  public long dropped(DropReason reason) {
    return log.dropped(reason);
  }

  RobotId self() {
    return self;
  }

  DatagramLog log() {
    return log;
  }

  <T> void send(OpenEndpoint<T> endpoint, @Nullable RobotId to, T message) {
    long number = ++lastNumber;
    DatagramWriter writer = WRITERS.take();
    writer.begin(Header.PLAIN, selfName, boot, number, lamportClock.now(), to);
    int length = writer.message(endpoint, message, 0);
    if (trace.isOn()) {
      log.sent(to, endpoint.channel, number, length, message);
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
    receiver.close(endpoint);
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
      log.sentAcknowledgement(to, order, number, length);
    }
    emit(to, writer.buffer(), length);
    WRITERS.giveBack(writer);
  }

  /**
   * Handles an acknowledgement: {@code from} has handled message {@code order} of this robot's
   * incarnation {@code ackedBoot}.
   */
  void settle(RobotId from, int ackedBoot, long order) {
    boolean isNew = ackedBoot == boot && reliable != null && reliable.acknowledged(from, order);
    if (!isNew) {
      log.dropped(DropReason.STALE_ACK, from, "");
    }
  }

  private void transmit(Outgoing<RetainedMessage> outgoing) {
    RetainedMessage retained = outgoing.content;
    byte[] datagram = retained.datagram;
    DatagramWriter.setClock(datagram, lamportClock.now());
    if (trace.isOn()) {
      log.sent(
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
      platform.strand().post(() -> receiver.receivedFromSelf(datagram));
    } else if (seal == null) {
      radiate(to, buffer, length);
    } else {
      emitSealed(seal, to, buffer, length);
    }
  }

  // Only this robot and the receiver can read or make a sealed datagram, so a broadcast is sealed
  // for each robot.
  private void emitSealed(Seal seal, @Nullable RobotId to, byte[] buffer, int length) {
    if (to != null) {
      int sealedLength = seal.seal(to, buffer, length);
      if (sealedLength > 0) {
        radio.send(to, seal.buffer(), sealedLength);
      }
      return;
    }
    for (RobotId robot : seal.peers()) {
      if (!isSelf(robot)) {
        emitSealed(seal, robot, buffer, length);
      }
    }
  }

  // Compares hashes first: the robot's own id is usually not in the cache.
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
