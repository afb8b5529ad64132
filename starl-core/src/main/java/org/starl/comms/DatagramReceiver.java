package org.starl.comms;

import java.nio.charset.StandardCharsets;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.Radio;
import org.starl.session.Session;
import org.starl.shape.WireFormatException;
import org.starl.trace.TraceSink;

/** Receives datagrams: checks and counts them, and passes messages to their endpoints. */
final class DatagramReceiver implements Radio.Receiver {

  private static final Spare<Header> HEADERS = new Spare<>(Header::new);

  private static final int FIRST_BOOT = 1;

  private final Comms comms;
  private final byte[] selfName;
  private final Participants deployment;
  private final LamportClock lamportClock;
  private final TraceSink trace;
  private final @Nullable Seal seal;
  private long received;

  /**
   * The open endpoints as a linked list. The one that received last is first, because it is usually
   * the next to receive.
   */
  private @Nullable OpenEndpoint<?> endpoints;

  // Created on first use.
  private @Nullable InboundWindows windows;
  private @Nullable UnknownSenders unknownSenders;

  /**
   * @param selfName this robot's name as on the wire
   * @param seal null if datagrams are not sealed
   */
  DatagramReceiver(
      Comms comms,
      byte[] selfName,
      Participants deployment,
      LamportClock lamportClock,
      TraceSink trace,
      @Nullable Seal seal) {
    this.comms = comms;
    this.selfName = selfName;
    this.deployment = deployment;
    this.lamportClock = lamportClock;
    this.trace = trace;
    this.seal = seal;
  }

  /** Number of datagrams received, including dropped ones. */
  long received() {
    return received;
  }

  boolean isOpen(Channel<?> channel) {
    return listener(channel.wireName, 0, channel.wireName.length) != null;
  }

  void open(OpenEndpoint<?> endpoint) {
    endpoint.next = endpoints;
    endpoints = endpoint;
  }

  void close(OpenEndpoint<?> endpoint) {
    // The search moves it to the front.
    if (listener(endpoint.name, 0, endpoint.name.length) == endpoint) {
      endpoints = endpoint.next;
      endpoint.next = null;
    }
  }

  private @Nullable OpenEndpoint<?> listener(byte[] bytes, int from, int length) {
    OpenEndpoint<?> before = null;
    OpenEndpoint<?> endpoint = endpoints;
    while (endpoint != null && !ByteNames.equal(endpoint.name, bytes, from, length)) {
      before = endpoint;
      endpoint = endpoint.next;
    }
    if (endpoint != null && before != null) {
      before.next = endpoint.next;
      endpoint.next = endpoints;
      endpoints = endpoint;
    }
    return endpoint;
  }

  @Override
  public void received(byte[] buffer, int length) {
    received++;
    Header header = HEADERS.take();
    DropReason malformed =
        seal == null ? header.parse(buffer, length) : header.parse(buffer, length - Session.BYTES);
    if (malformed == null) {
      handle(header, seal, length);
    } else {
      drop(seal == null ? malformed : DropReason.FORGED, null, length + " bytes");
    }
    HEADERS.giveBack(header);
  }

  /** Receives a datagram that this robot sent to itself. */
  void receivedFromSelf(byte[] datagram) {
    received++;
    Header header = HEADERS.take();
    DropReason malformed = header.parse(datagram, datagram.length);
    if (malformed == null) {
      accept(header, comms.self());
    } else {
      drop(malformed, null, datagram.length + " bytes");
    }
    HEADERS.giveBack(header);
  }

  /**
   * @param opening opens the datagram; null if datagrams are not sealed
   * @param length of the datagram, with its seal
   */
  private void handle(Header header, @Nullable Seal opening, int length) {
    RobotId from = sender(header);
    if (from == null) {
      drop(opening == null ? DropReason.BAD_NAME : DropReason.FORGED, null, "sender");
      return;
    }
    DropReason refused = refusal(header);
    if (refused == null && opening != null) {
      refused = opening.open(from, header, length);
    }
    if (refused == null) {
      accept(header, from);
    } else {
      drop(refused, from, "");
    }
  }

  private void accept(Header header, RobotId from) {
    // A first incarnation has no dead predecessor to tell apart.
    DropReason refused =
        windows == null && header.boot == FIRST_BOOT ? null : windows().admit(from, header.boot);
    if (refused != null) {
      drop(refused, from, "");
      return;
    }
    lamportClock.advanceTo(header.clock);
    if (header.kind == Header.ACK) {
      acknowledged(header, from);
    } else {
      message(header, from);
    }
  }

  private @Nullable RobotId sender(Header header) {
    RobotId known = deployment.find(header.bytes, header.senderAt, header.senderLength);
    if (known != null) {
      return known;
    }
    if (unknownSenders == null) {
      unknownSenders = new UnknownSenders();
    }
    return unknownSenders.find(header.bytes, header.senderAt, header.senderLength);
  }

  // Compares names as bytes, without reading the sender's object, which is usually not in the
  // cache.
  private @Nullable DropReason refusal(Header header) {
    if (ByteNames.equal(selfName, header.bytes, header.senderAt, header.senderLength)) {
      return DropReason.OWN;
    }
    boolean isForUs =
        header.addresseeLength == 0
            || ByteNames.equal(selfName, header.bytes, header.addresseeAt, header.addresseeLength);
    return isForUs ? null : DropReason.NOT_FOR_US;
  }

  private InboundWindows windows() {
    if (windows == null) {
      windows = new InboundWindows();
    }
    return windows;
  }

  private void acknowledged(Header header, RobotId from) {
    int ackedBoot;
    long order;
    try {
      ackedBoot = header.in.i32();
      order = header.in.i64();
      header.in.expectEnd();
    } catch (WireFormatException e) {
      drop(DropReason.BAD_PAYLOAD, from, "acknowledgement: " + e.getMessage());
      return;
    }
    comms.settle(from, ackedBoot, order);
  }

  private void message(Header header, RobotId from) {
    long order = 0;
    if (header.kind == Header.RELIABLE) {
      if (header.in.remaining() < Long.BYTES) {
        drop(DropReason.TRUNCATED, from, "no order");
        return;
      }
      order = header.in.i64();
      DropReason refused = order <= 0 ? DropReason.BAD_FIELD : windows().refusal(from, order);
      if (refused != null) {
        drop(refused, from, "");
        if (refused == DropReason.DUPLICATE) {
          comms.acknowledge(from, header.boot, order);
        }
        return;
      }
    }
    OpenEndpoint<?> endpoint = listener(header.bytes, header.channelAt, header.channelLength);
    if (endpoint == null) {
      dropWithoutListener(header, from);
    } else {
      deliver(endpoint, header, from, order);
    }
  }

  private void dropWithoutListener(Header header, RobotId from) {
    String name =
        new String(
            header.bytes, header.channelAt, header.channelLength, StandardCharsets.ISO_8859_1);
    if (Channel.isName(name)) {
      drop(DropReason.NO_LISTENER, from, name);
    } else {
      drop(DropReason.BAD_NAME, from, "channel");
    }
  }

  private <T> void deliver(OpenEndpoint<T> endpoint, Header header, RobotId from, long order) {
    T message;
    try {
      message = endpoint.channel.shape().read(header.in);
      header.in.expectEnd();
    } catch (WireFormatException | IllegalArgumentException e) {
      drop(DropReason.BAD_PAYLOAD, from, endpoint.channel.name() + ": " + e.getMessage());
      return;
    }
    if (order > 0) {
      windows().handle(from, header.boot, order);
    }
    if (trace.isOn()) {
      comms.log().delivered(from, endpoint.channel, header.number, message);
    }
    endpoint.handler.received(from, message);
    if (order > 0) {
      comms.acknowledge(from, header.boot, order);
    }
  }

  private void drop(DropReason reason, @Nullable RobotId from, String detail) {
    comms.log().dropped(reason, from, detail);
  }
}
