package org.starl.comms;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.starl.RobotId;
import org.starl.platform.DeploymentKey;
import org.starl.platform.Platform;
import org.starl.platform.Radio;

/**
 * {@code gvh.comms}: this robot's messages. Strand only.
 *
 * <p>What arrives and is no message for this robot is counted ({@link #dropped}), and logged once a
 * reason; it never throws. Plain messages are not de-duplicated; reliable ones are handled once by
 * each incarnation of the receiver, and acknowledged after their handler ran. Where the platform has a
 * key, every datagram is sealed with it, and what is not, or arrives again, is dropped.
 */
public final class Comms {

  private static final long UNSEALED = 0;
  private static final long FROM_SELF = -1;

  private final Platform platform;
  private final RobotId self;
  private final Radio radio;
  private final int boot;
  private final LamportClock lamportClock = new LamportClock();
  private final DatagramWriter writer;
  private final Header header;
  private final WireReader in;
  private final RobotNames robots;
  private final Endpoints endpoints = new Endpoints();
  private final InboundWindows inbound = new InboundWindows();
  private final Bookkeeping books;
  private final @Nullable Seal seal;
  private @Nullable ReliableSender reliable;
  private long lastNumber;

  /**
   * @param boot how often this robot's program has started, from 1
   * @param workspace not used by another robot at the same time
   */
  public Comms(Platform platform, int boot, Workspace workspace) {
    if (boot <= 0) {
      throw new IllegalArgumentException("boot number " + boot + ": expected above 0");
    }
    this.platform = platform;
    this.self = platform.id();
    this.radio = platform.radio();
    this.boot = boot;
    this.writer = new DatagramWriter(self, boot, workspace.out);
    this.header = workspace.header;
    this.in = workspace.in;
    this.robots = new RobotNames(platform.deployment());
    this.books = new Bookkeeping(platform);
    DeploymentKey key = platform.key();
    this.seal = key == null ? null : new Seal(key);
    Radio.Receiver receiver = this::arrived;
    radio.onReceive(receiver);
    platform
        .strand()
        .uses(
            radio,
            receiver,
            this,
            self,
            books,
            writer,
            writer.senderName(),
            lamportClock,
            robots,
            inbound);
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
    platform.strand().uses(endpoint, handler);
    return endpoint;
  }

  /** Datagrams sent: messages, repeated ones, acknowledgements; those to this robot as well. */
  public long sent() {
    return books.sent();
  }

  /** Datagrams that arrived, dropped ones included. */
  public long received() {
    return books.received();
  }

  /** Datagrams that arrived and were dropped for this reason. */
  public long dropped(DropReason reason) {
    return books.dropped(reason);
  }

  <T> void send(OpenEndpoint<T> endpoint, @Nullable RobotId to, T message) {
    long number = ++lastNumber;
    int length = writer.message(endpoint, to, message, number, 0, lamportClock.now());
    books.sent(to, endpoint.channel, number, length, message);
    emit(to, writer.buffer(), length);
  }

  <T> Receipt sendReliably(
      OpenEndpoint<T> endpoint, RobotId to, T message, Reliability reliability) {
    if (reliable == null) {
      reliable = new ReliableSender(platform.clock(), platform.timers(), this::transmit);
    }
    long number = ++lastNumber;
    long order = reliable.nextOrder(to);
    int length = writer.message(endpoint, to, message, number, order, lamportClock.now());
    byte[] datagram = Arrays.copyOf(writer.buffer(), length);
    return reliable.send(to, new RetainedMessage(endpoint, message, number, datagram), reliability);
  }

  void close(OpenEndpoint<?> endpoint) {
    endpoints.remove(endpoint);
    if (reliable != null) {
      reliable.fail(endpoint);
    }
  }

  private void transmit(Outgoing<RetainedMessage> outgoing) {
    RetainedMessage retained = outgoing.content;
    byte[] datagram = retained.datagram;
    DatagramWriter.setClock(datagram, lamportClock.now());
    books.sent(
        outgoing.to, retained.endpoint.channel, retained.number, datagram.length, retained.message);
    emit(outgoing.to, datagram, datagram.length);
  }

  private void emit(@Nullable RobotId to, byte[] buffer, int length) {
    if (self.equals(to)) {
      byte[] datagram = Arrays.copyOf(buffer, length);
      platform.strand().post(() -> received(datagram, datagram.length, FROM_SELF));
    } else if (seal == null) {
      radiate(to, buffer, length);
    } else {
      int sealedLength = seal.seal(buffer, length);
      radiate(to, seal.buffer(), sealedLength);
    }
  }

  private void radiate(@Nullable RobotId to, byte[] buffer, int length) {
    if (to == null) {
      radio.broadcast(buffer, length);
    } else {
      radio.send(to, buffer, length);
    }
  }

  private void arrived(byte[] buffer, int length) {
    if (seal == null) {
      received(buffer, length, UNSEALED);
      return;
    }
    // Counts begin with 1: what says less was not sealed by this code.
    long count = seal.isGenuine(buffer, length) ? Seal.count(buffer, length) : 0;
    if (count > 0) {
      received(buffer, length - Seal.BYTES, count);
    } else {
      books.countReceived();
      books.dropped(DropReason.FORGED, null, length + " bytes");
    }
  }

  /**
   * @param count the transmission's under its seal; or {@link #UNSEALED}, or {@link #FROM_SELF}
   */
  private void received(byte[] buffer, int length, long count) {
    books.countReceived();
    DropReason malformed = header.parse(buffer, length, in);
    if (malformed != null) {
      books.dropped(malformed, null, length + " bytes");
      return;
    }
    RobotId from = robots.find(buffer, header.senderAt, header.senderLength);
    if (from == null) {
      books.dropped(DropReason.BAD_NAME, null, "sender");
      return;
    }
    DropReason refused = refusal(buffer, from, count);
    if (refused != null) {
      books.dropped(refused, from, "");
      return;
    }
    lamportClock.witness(header.clock);
    if (header.kind == Header.ACK) {
      acknowledged(from);
    } else {
      message(buffer, from);
    }
  }

  private @Nullable DropReason refusal(byte[] buffer, RobotId from, long count) {
    if (count != FROM_SELF && from.equals(self)) {
      return DropReason.OWN;
    }
    boolean isForUs =
        header.addresseeLength == 0
            || ByteNames.equal(
                writer.senderName(), buffer, header.addresseeAt, header.addresseeLength);
    if (!isForUs) {
      return DropReason.NOT_FOR_US;
    }
    DropReason replayed =
        seal == null || count == FROM_SELF ? null : seal.admit(from, header.boot, count);
    return replayed != null ? replayed : inbound.admit(from, header.boot);
  }

  private void acknowledged(RobotId from) {
    int ackedBoot;
    long order;
    try {
      ackedBoot = in.i32();
      order = in.i64();
      in.expectEnd();
    } catch (WireFormatException e) {
      books.dropped(DropReason.BAD_PAYLOAD, from, "acknowledgement: " + e.getMessage());
      return;
    }
    settle(from, ackedBoot, order);
  }

  private void settle(RobotId from, int ackedBoot, long order) {
    boolean isNews = ackedBoot == boot && reliable != null && reliable.acknowledged(from, order);
    if (!isNews) {
      books.dropped(DropReason.STALE_ACK, from, "");
    }
  }

  private void message(byte[] buffer, RobotId from) {
    long order = 0;
    if (header.kind == Header.RELIABLE) {
      if (in.remaining() < Long.BYTES) {
        books.dropped(DropReason.TRUNCATED, from, "no order");
        return;
      }
      order = in.i64();
      DropReason refused = order <= 0 ? DropReason.BAD_FIELD : inbound.refusal(from, order);
      if (refused != null) {
        books.dropped(refused, from, "");
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
      books.dropped(DropReason.NO_LISTENER, from, name);
    } else {
      books.dropped(DropReason.BAD_NAME, from, "channel");
    }
  }

  private <T> void deliver(OpenEndpoint<T> endpoint, RobotId from, long order) {
    T message;
    try {
      message = endpoint.channel.codec().read(in);
      in.expectEnd();
    } catch (WireFormatException | IllegalArgumentException e) {
      books.dropped(DropReason.BAD_PAYLOAD, from, endpoint.channel.name() + ": " + e.getMessage());
      return;
    }
    int senderBoot = header.boot;
    if (order > 0) {
      inbound.handle(from, senderBoot, order);
    }
    books.delivered(from, endpoint.channel, header.number, message);
    endpoint.handler.received(from, message);
    if (order > 0) {
      acknowledge(from, senderBoot, order);
    }
  }

  private void acknowledge(RobotId to, int ackedBoot, long order) {
    if (to.equals(self)) {
      settle(to, ackedBoot, order);
      return;
    }
    long number = ++lastNumber;
    int length = writer.acknowledgement(to, ackedBoot, order, number, lamportClock.now());
    books.sentAcknowledgement(to, order, number, length);
    emit(to, writer.buffer(), length);
  }
}
