package org.starl.robot.udp;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.SocketException;
import java.util.Arrays;
import java.util.Map;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.platform.Radio;
import org.starl.platform.Strand;
import org.starl.robot.realtime.Daemons;

/**
 * Datagrams over UDP between peers with known addresses. A broadcast is one datagram to each peer,
 * because wireless networks lose true broadcasts far more often. Datagrams from other addresses are
 * dropped.
 */
public final class UdpRadio implements Radio, AutoCloseable {

  /** Datagrams that may wait for the strand; more are dropped. */
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
  private final DropCounts<UdpDrop> drops = new DropCounts<>(UdpDrop.class);

  // Set after the thread has started to receive.
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
    this.thread = Daemons.of(self + " radio", this::receiveAll);
  }

  /**
   * Opens {@code self}'s radio.
   *
   * @param address to listen at; port 0 for any free one
   * @param onFailure is called once, on a thread of the radio, if it cannot continue
   * @throws SocketException if the address is not available
   */
  public static UdpRadio open(
      RobotId self, Strand strand, InetSocketAddress address, Consumer<Exception> onFailure)
      throws SocketException {
    DatagramSocket socket;
    try {
      socket = new DatagramSocket(address);
    } catch (SocketException e) {
      String at = address.getHostString() + ":" + address.getPort();
      SocketException named = new SocketException("radio at " + at + ": " + e.getMessage());
      named.initCause(e);
      throw named;
    }
    UdpRadio radio = new UdpRadio(self, strand, socket, onFailure);
    radio.thread.start();
    return radio;
  }

  /** This radio's own address. */
  public InetSocketAddress address() {
    return new InetSocketAddress(socket.getLocalAddress(), socket.getLocalPort());
  }

  /** Sets the address of another robot: to send to, and to accept datagrams from. */
  public void setPeer(RobotId id, InetSocketAddress address) {
    if (!id.equals(self)) {
      peers.put(id, address);
    }
  }

  /** Sets the receiver of a log line for the first dropped datagram of each reason. */
  public void onDrop(Consumer<String> newLog) {
    log = newLog;
  }

  /** Sets the receiver of beacons, on the radio's thread. */
  void onBeacon(Consumer<DatagramPacket> taker) {
    beacons = taker;
  }

  /** Closes the radio because of a failure, and reports it. */
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
    Radio.checkLength(buffer, length);
    InetSocketAddress address = peers.get(to);
    if (address == null) {
      unsent.incrementAndGet();
    } else {
      transmit(address, buffer, length);
    }
  }

  @Override
  public void broadcast(byte[] buffer, int length) {
    Radio.checkLength(buffer, length);
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
    return new UdpStatistics(sent.get(), unsent.get(), received.get(), drops.counts());
  }

  /** Sends and receives nothing more. */
  @Override
  public void close() {
    socket.close();
    Daemons.join(thread, 0);
  }

  // A datagram that the network refuses counts as lost; the layers above expect loss.
  void transmit(InetSocketAddress address, byte[] buffer, int length) {
    try {
      socket.send(new DatagramPacket(buffer, length, address));
      sent.incrementAndGet();
    } catch (IOException e) {
      unsent.incrementAndGet();
    }
  }

  private void receiveAll() {
    // One byte more than is allowed, because a longer datagram is cut silently.
    DatagramPacket packet = new DatagramPacket(new byte[MAX_BYTES + 1], MAX_BYTES + 1);
    while (!socket.isClosed()) {
      try {
        packet.setLength(MAX_BYTES + 1);
        socket.receive(packet);
        accept(packet);
      } catch (IOException | RuntimeException e) {
        fail(e);
      }
    }
  }

  /** Passes a received datagram to the strand, or drops it. On the radio's thread. */
  void accept(DatagramPacket packet) {
    SocketAddress source = packet.getSocketAddress();
    if (packet.getLength() > MAX_BYTES) {
      dropped(UdpDrop.OVERSIZE, source);
    } else if (Beacon.isBeacon(packet.getData(), packet.getLength())) {
      beacons.accept(packet);
    } else if (!peers.containsValue(source)) {
      dropped(UdpDrop.FOREIGN, source);
    } else if (waiting.get() >= MAX_WAITING) {
      dropped(UdpDrop.OVERFLOW, source);
    } else {
      received.incrementAndGet();
      waiting.incrementAndGet();
      byte[] datagram = Arrays.copyOf(packet.getData(), packet.getLength());
      strand.post(() -> deliver(datagram));
    }
  }

  /** Counts a dropped datagram; the first for each suspicious reason is logged. */
  void dropped(UdpDrop reason, SocketAddress source) {
    if (drops.add(reason) && reason.isSuspicious()) {
      log.accept(
          String.format(
              "dropped a datagram from %s: %s; more of these are only counted",
              source, reason.description()));
    }
  }

  private void deliver(byte[] datagram) {
    waiting.decrementAndGet();
    if (receiver != null && !socket.isClosed()) {
      receiver.received(datagram, datagram.length);
    }
  }
}
