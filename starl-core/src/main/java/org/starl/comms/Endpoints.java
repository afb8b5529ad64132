package org.starl.comms;

import org.jspecify.annotations.Nullable;

/** The open endpoints, found by the bytes of their channels' names: open addressing, no removal. */
final class Endpoints {

  private @Nullable OpenEndpoint<?>[] slots = table(4);
  private int size;

  @Nullable OpenEndpoint<?> find(byte[] bytes, int from, int length) {
    int mask = slots.length - 1;
    int slot = ByteNames.hash(bytes, from, length) & mask;
    OpenEndpoint<?> endpoint = slots[slot];
    while (endpoint != null && !ByteNames.equal(endpoint.name, bytes, from, length)) {
      slot = (slot + 1) & mask;
      endpoint = slots[slot];
    }
    return endpoint;
  }

  void add(OpenEndpoint<?> endpoint) {
    rebuild(2 * (size + 1), null);
    insert(endpoint);
  }

  void remove(OpenEndpoint<?> endpoint) {
    rebuild(2 * size, endpoint);
  }

  private void rebuild(int atLeast, @Nullable OpenEndpoint<?> without) {
    @Nullable OpenEndpoint<?>[] old = slots;
    int length = Math.max(4, Integer.highestOneBit(2 * atLeast - 1));
    slots = table(length);
    size = 0;
    for (OpenEndpoint<?> endpoint : old) {
      if (endpoint != null && endpoint != without) {
        insert(endpoint);
      }
    }
  }

  private static @Nullable OpenEndpoint<?>[] table(int length) {
    return new OpenEndpoint<?>[length];
  }

  private void insert(OpenEndpoint<?> endpoint) {
    int mask = slots.length - 1;
    int slot = ByteNames.hash(endpoint.name, 0, endpoint.name.length) & mask;
    while (slots[slot] != null) {
      slot = (slot + 1) & mask;
    }
    slots[slot] = endpoint;
    size++;
  }
}
