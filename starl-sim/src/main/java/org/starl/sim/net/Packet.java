package org.starl.sim.net;

import org.jspecify.annotations.Nullable;

/** A sender's bytes, shared by all their deliveries, returned to the pool by the last one. */
final class Packet {

  private static final int LEAST_CAPACITY = 64;

  private final DeliveryPool pool;
  private byte[] data = new byte[LEAST_CAPACITY];
  private int length;
  private int holders;
  @Nullable Packet nextFree;

  Packet(DeliveryPool pool) {
    this.pool = pool;
  }

  void fill(byte[] buffer, int newLength) {
    if (data.length < newLength) {
      data = new byte[newLength];
    }
    System.arraycopy(buffer, 0, data, 0, newLength);
    length = newLength;
    holders = 1;
  }

  void hold() {
    holders++;
  }

  void release() {
    holders--;
    if (holders == 0) {
      pool.takeBack(this);
    }
  }

  byte[] data() {
    return data;
  }

  int length() {
    return length;
  }
}
