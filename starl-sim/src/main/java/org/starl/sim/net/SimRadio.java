package org.starl.sim.net;

import org.jspecify.annotations.Nullable;
import org.starl.RobotId;
import org.starl.platform.Radio;

/** One robot's radio in one incarnation. */
final class SimRadio implements Radio {

  private final SimNetwork network;
  private final RobotId id;
  private final long key;
  private final SimNetwork.Station station;
  private long datagrams;
  private @Nullable Receiver receiver;
  private boolean closed;

  SimRadio(SimNetwork network, RobotId id, SimNetwork.Station station) {
    this.network = network;
    this.id = id;
    this.station = station;
    this.key = station.key();
    this.datagrams = station.datagrams();
  }

  @Override
  public void send(RobotId to, byte[] buffer, int length) {
    checkLength(buffer, length);
    if (!closed) {
      network.send(this, to, buffer, length);
    }
  }

  @Override
  public void broadcast(byte[] buffer, int length) {
    checkLength(buffer, length);
    if (!closed) {
      network.broadcast(this, buffer, length);
    }
  }

  @Override
  public void onReceive(Receiver newReceiver) {
    if (receiver != null) {
      throw new IllegalStateException(id + "'s radio has a receiver already");
    }
    receiver = newReceiver;
  }

  void receive(RobotId from, byte[] data, int length) {
    if (closed) {
      network.dropped(from, id, "gone");
    } else if (receiver == null) {
      network.dropped(from, id, "no-receiver");
    } else {
      network.delivered();
      receiver.received(data, length);
    }
  }

  void close() {
    closed = true;
  }

  RobotId id() {
    return id;
  }

  SimNetwork.Station station() {
    return station;
  }

  /** The number of the datagram that it sends now, from 0 in the robot's first incarnation. */
  long nextDatagram() {
    return datagrams++;
  }

  /** How many datagrams the robot has sent in this and earlier incarnations. */
  long datagrams() {
    return datagrams;
  }

  /** A function of sender, recipient and datagram alone. The factors are odd: nothing is lost. */
  long copySeed(SimNetwork.Station recipient, long datagram) {
    return key
        + Long.rotateLeft(recipient.key(), 32) * 0xD1342543DE82EF95L
        + datagram * 0x2545F4914F6CDD1DL;
  }

  private static void checkLength(byte[] buffer, int length) {
    if (length < 0 || length > MAX_BYTES || length > buffer.length) {
      throw new IllegalArgumentException(
          "datagram of " + length + " bytes: expected 0 to " + Math.min(MAX_BYTES, buffer.length));
    }
  }
}
