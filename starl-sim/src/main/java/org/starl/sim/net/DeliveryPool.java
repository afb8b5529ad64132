package org.starl.sim.net;

import org.jspecify.annotations.Nullable;
import org.starl.RobotId;

/**
 * Deliveries and packets, used again and again. One that a closed strand never ran is never taken
 * back: it is garbage, nothing waits for it.
 */
final class DeliveryPool {

  private static final RobotId NOBODY = new RobotId("nobody");

  private final SimRadio nowhere;
  private @Nullable Delivery freeDeliveries;
  private @Nullable Packet freePackets;

  DeliveryPool(SimNetwork network) {
    nowhere = new SimRadio(network, NOBODY, new SimNetwork.Station(NOBODY, 0));
  }

  Packet packet(byte[] buffer, int length) {
    Packet packet = freePackets;
    if (packet == null) {
      packet = new Packet(this);
    } else {
      freePackets = packet.nextFree;
      packet.nextFree = null;
    }
    packet.fill(buffer, length);
    return packet;
  }

  Runnable delivery(RobotId from, SimRadio to, Packet packet) {
    Delivery delivery = freeDeliveries;
    if (delivery == null) {
      delivery = new Delivery(packet);
    } else {
      freeDeliveries = delivery.nextFree;
      delivery.nextFree = null;
    }
    packet.hold();
    delivery.packet = packet;
    delivery.data = packet.data();
    delivery.length = packet.length();
    delivery.from = from;
    delivery.to = to;
    return delivery;
  }

  void takeBack(Packet packet) {
    packet.nextFree = freePackets;
    freePackets = packet;
  }

  /** One copy on its way. */
  private final class Delivery implements Runnable {
    private RobotId from = NOBODY;
    private SimRadio to = nowhere;
    private Packet packet;
    // The packet's: whoever receives them need not wait until the packet, too, is in the cache.
    private byte[] data;
    private int length;
    private @Nullable Delivery nextFree;

    Delivery(Packet packet) {
      this.packet = packet;
      this.data = packet.data();
    }

    @Override
    public void run() {
      to.receive(from, data, length);
      packet.release();
      // A pooled delivery must not keep a robot that left in memory.
      from = NOBODY;
      to = nowhere;
      nextFree = freeDeliveries;
      freeDeliveries = this;
    }
  }
}
