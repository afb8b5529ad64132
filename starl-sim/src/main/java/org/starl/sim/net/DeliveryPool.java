package org.starl.sim.net;

import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.sim.kernel.Cache;
import org.starl.sim.kernel.Kernel;
import org.starl.sim.kernel.Prefetchable;

/**
 * A pool of deliveries and packets. A delivery that is dropped by a closed strand does not return
 * to the pool; the garbage collector frees it.
 */
final class DeliveryPool {

  /** The sender of injected datagrams, in the trace. */
  static final RobotId NO_SENDER = new RobotId("no-sender");

  private @Nullable Delivery freeDeliveries;
  private @Nullable Packet freePackets;
  private @Nullable BroadcastDelivery freeBroadcasts;

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

  /** A delivery of one broadcast, to which the caller adds the recipients. */
  BroadcastDelivery broadcast(Kernel kernel, RobotId from, Packet packet) {
    BroadcastDelivery delivery = freeBroadcasts;
    if (delivery == null) {
      delivery = new BroadcastDelivery(kernel, this);
    } else {
      freeBroadcasts = delivery.nextFree;
      delivery.nextFree = null;
    }
    delivery.begin(from, packet);
    return delivery;
  }

  void takeBack(BroadcastDelivery delivery) {
    delivery.nextFree = freeBroadcasts;
    freeBroadcasts = delivery;
  }

  void takeBack(Packet packet) {
    packet.nextFree = freePackets;
    freePackets = packet;
  }

  /** A delivery of one copy. */
  private final class Delivery implements Prefetchable {
    private RobotId from = NO_SENDER;
    private @Nullable SimRadio to;
    private Packet packet;
    // Cached from the packet.
    private byte[] data;
    private int length;
    private @Nullable Delivery nextFree;

    Delivery(Packet packet) {
      this.packet = packet;
      this.data = packet.data();
    }

    @Override
    public int prefetch() {
      return Cache.prefetch(data) + Cache.prefetch(packet);
    }

    @Override
    public void run() {
      SimRadio radio = radio();
      ArrivalGate gate = radio.gate();
      if (gate == null) {
        handOver(radio);
      } else {
        gate.pass(() -> handOver(radio));
      }
    }

    private SimRadio radio() {
      if (to == null) {
        throw new IllegalStateException("the delivery is in the pool already");
      }
      return to;
    }

    private void handOver(SimRadio radio) {
      radio.receive(from, data, length);
      packet.release();
      // A pooled delivery must not keep a robot that left in memory.
      from = NO_SENDER;
      to = null;
      nextFree = freeDeliveries;
      freeDeliveries = this;
    }
  }
}
