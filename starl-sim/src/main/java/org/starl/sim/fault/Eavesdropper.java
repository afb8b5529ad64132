package org.starl.sim.fault;

import java.util.Arrays;
import org.starl.id.RobotId;
import org.starl.platform.Radio;
import org.starl.random.Rng;
import org.starl.sim.net.NetworkTap;

/**
 * Records datagrams and forges plausible ones from them. It knows only that names and numbers have
 * fixed places in the wire format.
 */
final class Eavesdropper implements NetworkTap {

  private static final int RECORDINGS = 256;
  private static final byte[] NOTHING = new byte[0];

  private final byte[][] latest = new byte[RECORDINGS][];

  /** Of all since the attack began, each with the same probability (Vitter's algorithm R). */
  private final byte[][] sample = new byte[RECORDINGS][];

  private final Rng rng;
  private int recorded;

  Eavesdropper(Rng rng) {
    this.rng = rng;
  }

  @Override
  public void sent(RobotId from, byte[] buffer, int length) {
    byte[] datagram = Arrays.copyOf(buffer, length);
    latest[recorded % RECORDINGS] = datagram;
    int place = recorded < RECORDINGS ? recorded : rng.nextInt(recorded + 1);
    if (place < RECORDINGS) {
      sample[place] = datagram;
    }
    recorded++;
  }

  /**
   * One of the latest datagrams or, half of the time, of all: older ones are of ended sessions, and
   * below a session's window of counts. Empty before the first one.
   */
  byte[] recorded() {
    int available = Math.min(recorded, RECORDINGS);
    if (available == 0) {
      return NOTHING;
    }
    return (rng.nextBoolean(0.5) ? latest : sample)[rng.nextInt(available)].clone();
  }

  /** A recorded datagram with some bytes changed. */
  byte[] changed() {
    byte[] datagram = recorded();
    if (datagram.length == 0) {
      return datagram;
    }
    int changes = 1 + rng.nextInt(3);
    for (int i = 0; i < changes; i++) {
      datagram = rng.nextBoolean(0.8) ? withOtherBytes(datagram) : crossed(datagram);
    }
    return datagram;
  }

  /** Random bytes, of any length that a radio can send. */
  byte[] noise() {
    byte[] datagram = new byte[1 + rng.nextInt(Radio.MAX_BYTES)];
    for (int i = 0; i < datagram.length; i++) {
      datagram[i] = (byte) rng.nextInt(256);
    }
    return datagram;
  }

  // Small changes keep numbers plausible and change, for example, bot1 to bot2.
  private byte[] withOtherBytes(byte[] datagram) {
    int at = rng.nextInt(datagram.length);
    int step = rng.nextBoolean(0.7) ? 1 + rng.nextInt(3) : rng.nextInt(256);
    datagram[at] = (byte) (rng.nextBoolean(0.5) ? datagram[at] + step : datagram[at] - step);
    return datagram;
  }

  // Joins the head of one datagram and a tail of random length of another one.
  private byte[] crossed(byte[] datagram) {
    byte[] other = recorded();
    int cut = rng.nextInt(Math.min(datagram.length, other.length));
    byte[] crossed = other.clone();
    System.arraycopy(datagram, 0, crossed, 0, cut);
    return crossed;
  }
}
