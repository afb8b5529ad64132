package org.starl.comms;

/** Hashes and compares names as bytes inside a datagram, without creating strings. */
final class ByteNames {

  private ByteNames() {}

  static int hash(byte[] bytes, int from, int length) {
    int hash = length;
    for (int i = from; i < from + length; i++) {
      hash = hash * 31 + bytes[i];
    }
    // Names differ in their last letters: mix those bits into the low bits, which tables use.
    return hash ^ (hash >>> 15) ^ (hash >>> 7);
  }

  static boolean equal(byte[] name, byte[] bytes, int from, int length) {
    if (name.length != length) {
      return false;
    }
    for (int i = length - 1; i >= 0; i--) {
      if (name[i] != bytes[from + i]) {
        return false;
      }
    }
    return true;
  }
}
