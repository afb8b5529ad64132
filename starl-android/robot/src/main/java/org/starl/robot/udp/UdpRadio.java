package org.starl.robot.udp;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.SocketException;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicLongArray;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.platform.Radio;
import org.starl.platform.Strand;

/**
 * Datagrams over UDP between peers whose addresses are known. A broadcast is one datagram to each
 * peer: wireless networks lose true broadcasts far more often. What comes from elsewhere is dropped.
 */
public final class UdpRadio implements Radio, AutoCloseable {

  /** So many datagrams may wait for the strand; a flood beyond that is dropped. */
  static final int MAX_WAITING = 1024;

  private final RobotId self;
  private final Strand strand;
  private final DatagramSocket socket;
  private final Consumer<Exception> onFailure;
  private final Thread thread;
  private final Map<RobotId, InetSocketAddress> peers = new ConcurrentSkipListMap<>();
  private final AtomicInteger waiting = new AtomicInteger();
  private final AtomicLong sent = new AtomicLong();
  private final AtomicLong unsent = new AtomicLong();
  private final AtomicLong received = new AtomicLong();
  private final AtomicLongArray dropped = new AtomicLongArray(UdpDrop.values().length);

  // Set by who has opened it, while its thread receives already.
  private volatile Consumer<String> log = line -> {};
  private volatile Consumer<DatagramPacket> beacons =
      packet -> dropped(UdpDrop.UNEXPECTED_BEACON, packet.getSocketAddress());

  // Strand only.
  private @Nullable Receiver receiver;

  private UdpRadio(
      RobotId self, Strand strand, DatagramSocket socket, Consumer<Exception> onFailure) {
    this.self = self;
    this.strand = strand;
    this.socket = socket;
    this.onFailure = onFailure;
    this.thread = new Thread(this::receiveAll, self + " radio");
    thread.setDaemon(true);
  }

  /**
   * Opens {@code self}'s radio.
   *
   * @param address to listen at; port 0 for any free one
   * @param onFailure is told, on a thread of the radio, why it cannot go on; once
   * @throws SocketException if the address is not to be had
   */
  public static UdpRadio open(
      RobotId self, Strand strand, InetSocketAddress address, Consumer<Exception> onFailure)
      throws SocketException {
    DatagramSocket socket;
    try {
      socket = new DatagramSocket(address);
    } catch (SocketException e) {
      SocketException named = new SocketException("radio at " + address + ": " + e.getMessage());
      named.initCause(e);
      throw named;
    }
    UdpRadio radio = new UdpRadio(self, strand, socket, onFailure);
    radio.thread.start();
    return radio;
  }

  /** Where this radio listens. */
  public InetSocketAddress address() {
    return new InetSocketAddress(socket.getLocalAddress(), socket.getLocalPort());
  }

  /** From now on {@code id} is there, and heard. An entry for this robot itself means nothing. */
  public void setPeer(RobotId id, InetSocketAddress address) {
    if (!id.equals(self)) {
      peers.put(id, address);
    }
  }

  /** From now on takes a line for people when a datagram is dropped for a reason the first time. */
  public void onDrop(Consumer<String> newLog) {
    log = newLog;
  }

  /** From now on takes what means to be a beacon, on the radio's thread. */
  void onBeacon(Consumer<DatagramPacket> taker) {
    beacons = taker;
  }

  /** It cannot go on: sends and hears nothing more, and tells why. */
  void fail(Exception why) {
    if (!socket.isClosed()) {
      socket.close();
      onFailure.accept(why);
    }
  }

  boolean isClosed() {
    return socket.isClosed();
  }

  @Override
  public void send(RobotId to, byte[] buffer, int length) {
    checkLength(buffer, length);
    InetSocketAddress address = peers.get(to);
    if (address == null) {
      unsent.incrementAndGet();
    } else {
      transmit(address, buffer, length);
    }
  }

  @Override
  public void broadcast(byte[] buffer, int length) {
    checkLength(buffer, length);
    for (InetSocketAddress address : peers.values()) {
      transmit(address, buffer, length);
    }
  }

  @Override
  public void onReceive(Receiver newReceiver) {
    if (receiver != null) {
      throw new IllegalStateException(self + "'s radio has a receiver already");
    }
    receiver = newReceiver;
  }

  public UdpStatistics statistics() {
    Map<UdpDrop, Long> drops = new EnumMap<>(UdpDrop.class);
    for (UdpDrop reason : UdpDrop.values()) {
      if (dropped.get(reason.ordinal()) > 0) {
        drops.put(reason, dropped.get(reason.ordinal()));
      }
    }
    return new UdpStatistics(sent.get(), unsent.get(), received.get(), drops);
  }

  /** Sends and hears nothing more. */
  @Override
  public void close() {
    socket.close();
    if (Thread.currentThread() == thread) {
      return;
    }
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  // A network that refuses a datagram has lost it, which the layers above expect of a radio.
  void transmit(InetSocketAddress address, byte[] buffer, int length) {
    try {
      socket.send(new DatagramPacket(buffer, length, address));
      sent.incrementAndGet();
    } catch (IOException e) {
      unsent.incrementAndGet();
    }
  }

  private void receiveAll() {
    // One byte more than is allowed, since a longer datagram is cut off without a word.
    DatagramPacket packet = new DatagramPacket(new byte[MAX_BYTES + 1], MAX_BYTES + 1);
    while (!socket.isClosed()) {
      try {
        packet.setLength(MAX_BYTES + 1);
        socket.receive(packet);
        judge(packet);
      } catch (IOException | RuntimeException e) {
        fail(e);
      }
    }
  }

  /** On the radio's thread: decides what becomes of a datagram that has come. */
  void judge(DatagramPacket packet) {
    SocketAddress source = packet.getSocketAddress();
    if (packet.getLength() > MAX_BYTES) {
      dropped(UdpDrop.OVERSIZE, source);
    } else if (Beacon.isOne(packet.getData(), packet.getLength())) {
      beacons.accept(packet);
    } else if (!isFromPeer(source)) {
      dropped(UdpDrop.FOREIGN, source);
    } else if (waiting.get() >= MAX_WAITING) {
      dropped(UdpDrop.OVERFLOW, source);
    } else {
      received.incrementAndGet();
      waiting.incrementAndGet();
      byte[] datagram = Arrays.copyOf(packet.getData(), packet.getLength());
      strand.post(() -> hand(datagram));
    }
  }

  /** Counts a datagram that came to nothing; the first of its kind is told to people. */
  void dropped(UdpDrop reason, SocketAddress source) {
    if (dropped.incrementAndGet(reason.ordinal()) == 1 && reason.isSuspicious()) {
      log.accept(
          "dropped a datagram from "
              + source
              + ": "
              + reason.what()
              + "; more of these are only counted");
    }
  }

  private boolean isFromPeer(SocketAddress address) {
    return peers.containsValue(address);
  }

  private void hand(byte[] datagram) {
    waiting.decrementAndGet();
    if (receiver != null && !socket.isClosed()) {
      receiver.received(datagram, datagram.length);
    }
  }

  private static void checkLength(byte[] buffer, int length) {
    if (length < 0 || length > MAX_BYTES || length > buffer.length) {
      throw new IllegalArgumentException(
          "datagram of " + length + " bytes: expected 0 to " + Math.min(MAX_BYTES, buffer.length));
    }
  }
}
