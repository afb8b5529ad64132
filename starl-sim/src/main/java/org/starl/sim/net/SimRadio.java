package org.starl.sim.net;

import org.jspecify.annotations.Nullable;
import org.starl.RobotId;
import org.starl.platform.Radio;

/** One robot's radio in one incarnation. */
final class SimRadio implements Radio {

  private final SimNetwork network;
  private final RobotId id;
  private final SimNetwork.Station station;
  private final Inbox inbox;
  private @Nullable Receiver receiver;
  private boolean closed;

  SimRadio(SimNetwork network, RobotId id, SimNetwork.Station station, Inbox inbox) {
    this.network = network;
    this.id = id;
    this.station = station;
    this.inbox = inbox;
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

  Inbox inbox() {
    return inbox;
  }

  private static void checkLength(byte[] buffer, int length) {
    if (length < 0 || length > MAX_BYTES || length > buffer.length) {
      throw new IllegalArgumentException(
          "datagram of " + length + " bytes: expected 0 to " + Math.min(MAX_BYTES, buffer.length));
    }
  }
}
