package org.starl.sim.net;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.sim.kernel.Cache;
import org.starl.sim.kernel.Kernel;

/**
 * The delivery of one broadcast to all robots in range: one event of the world, which runs one piece
 * on the strand of each. Pooled, as {@link DeliveryPool}'s deliveries are.
 */
final class BroadcastDelivery implements Runnable {

  private final Kernel kernel;
  private final DeliveryPool pool;
  private final Runnable receiveOne = this::receiveOne;
  private RobotId from = DeliveryPool.NO_SENDER;
  private @Nullable Packet packet;
  private @Nullable SimRadio[] to = new SimRadio[16];
  private int size;
  private int current;

  @SuppressWarnings("UnusedVariable") // kept, or the compiler would leave the reading out (Cache)
  private int read;

  @Nullable BroadcastDelivery nextFree;

  BroadcastDelivery(Kernel kernel, DeliveryPool pool) {
    this.kernel = kernel;
    this.pool = pool;
  }

  void begin(RobotId newFrom, Packet newPacket) {
    from = newFrom;
    packet = newPacket;
    newPacket.hold();
  }

  void add(SimRadio radio) {
    if (size == to.length) {
      to = Arrays.copyOf(to, 2 * size);
    }
    to[size] = radio;
    size++;
  }

  boolean isEmpty() {
    return size == 0;
  }

  @Override
  public void run() {
    // In two rounds, as the kernel's queue does for events of one strand.
    int sum = 0;
    for (int i = 0; i < size; i++) {
      sum += Cache.prefetch(to[i]);
    }
    for (current = 0; current < size; current++) {
      sum += Kernel.prefetch(radio().strand());
    }
    read = sum;
    for (current = 0; current < size; current++) {
      kernel.runNow(radio().strand(), receiveOne);
    }
    end();
  }

  /** Returns it to the pool. */
  void end() {
    // A pooled delivery must not keep a robot that left in memory.
    Arrays.fill(to, 0, size, null);
    size = 0;
    from = DeliveryPool.NO_SENDER;
    packet().release();
    packet = null;
    pool.takeBack(this);
  }

  private void receiveOne() {
    SimRadio radio = radio();
    Packet held = packet();
    ArrivalGate gate = radio.gate();
    if (gate == null) {
      radio.receive(from, held.data(), held.length());
    } else {
      held.hold();
      RobotId sender = from;
      gate.pass(() -> {
        radio.receive(sender, held.data(), held.length());
        held.release();
      });
    }
  }

  private SimRadio radio() {
    SimRadio radio = to[current];
    if (radio == null) {
      throw inPool();
    }
    return radio;
  }

  private Packet packet() {
    if (packet == null) {
      throw inPool();
    }
    return packet;
  }

  private static IllegalStateException inPool() {
    return new IllegalStateException("the delivery is in the pool already");
  }
}
