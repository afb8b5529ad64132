package org.starl.sim.net;

import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.platform.Radio;
import org.starl.sim.kernel.SimStrand;

/** One robot's radio in one incarnation. */
final class SimRadio implements Radio {

  private final SimNetwork network;
  private final RobotId id;
  private final int number;
  private final long key;
  private final SimStrand strand;
  private final @Nullable ArrivalGate gate;
  private long datagrams;
  private @Nullable Receiver receiver;
  private boolean closed;

  /**
   * @param number see {@link SimNetwork#number}
   * @param key seeds its random numbers
   * @param datagrams number of datagrams sent in the robot's earlier incarnations
   * @param strand the strand on which it receives
   * @param gate delays arrivals, or null
   */
  SimRadio(
      SimNetwork network,
      RobotId id,
      int number,
      long key,
      long datagrams,
      SimStrand strand,
      @Nullable ArrivalGate gate) {
    this.network = network;
    this.id = id;
    this.number = number;
    this.key = key;
    this.datagrams = datagrams;
    this.strand = strand;
    this.gate = gate;
  }

  @Override
  public void send(RobotId to, byte[] buffer, int length) {
    Radio.checkLength(buffer, length);
    if (!closed) {
      network.send(this, to, buffer, length);
    }
  }

  @Override
  public void broadcast(byte[] buffer, int length) {
    Radio.checkLength(buffer, length);
    if (!closed) {
      network.broadcast(this, buffer, length);
    }
  }

  @Override
  public void onReceive(Receiver newReceiver) {
    if (receiver != null) {
      throw new IllegalStateException(id + "'s radio already has a receiver");
    }
    receiver = newReceiver;
    strand.prefetch(this, newReceiver);
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

  int number() {
    return number;
  }

  /** The key of its random numbers. */
  long key() {
    return key;
  }

  SimStrand strand() {
    return strand;
  }

  @Nullable ArrivalGate gate() {
    return gate;
  }

  /** The number of the datagram being sent, from 0 in the robot's first incarnation. */
  long nextDatagram() {
    return datagrams++;
  }

  /** Number of datagrams that the robot has sent in this and earlier incarnations. */
  long datagrams() {
    return datagrams;
  }

  /** A function of sender, recipient and datagram only. The factors are odd, hence invertible. */
  long copySeed(long recipientKey, long datagram) {
    return key
        + Long.rotateLeft(recipientKey, 32) * 0xD1342543DE82EF95L
        + datagram * 0x2545F4914F6CDD1DL;
  }
}
