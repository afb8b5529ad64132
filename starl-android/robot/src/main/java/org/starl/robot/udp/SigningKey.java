package org.starl.robot.udp;

import javax.crypto.Mac;
import org.starl.session.PairKey;

/** Signs the beacons between two robots. For one thread at a time. */
final class SigningKey {

  private final PairKey pair;
  private final Mac mac;

  SigningKey(PairKey pair) {
    this.pair = pair;
    mac = pair.newMac("beacon");
  }

  PairKey pair() {
    return pair;
  }

  /** Its public number, not 0. */
  int id() {
    return pair.id() == 0 ? 1 : pair.id();
  }

  /** The code over the first {@code length} bytes. */
  byte[] sign(byte[] bytes, int length) {
    mac.update(bytes, 0, length);
    return mac.doFinal();
  }
}
