package org.starl.robot.udp;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.id.RobotId;
import org.starl.platform.Clock;
import org.starl.platform.Radio;
import org.starl.platform.Timers;
import org.starl.random.Rng;

/**
 * A radio in bad air: of what its robot sends, each copy to each recipient is lost, or late, by a
 * generator of its own link. What it receives is the radio's below.
 *
 * <p>A copy leaves as a piece of the strand of its own, never inside the call that sends it: by then
 * the action that sent it is over, and its trace is written. So whatever others do because of a
 * message comes, on one clock, after all that its sender did in the same action. Strand only.
 */
public final class LossyRadio implements Radio {

  /** What {@link Air} says of a copy that is lost. */
  public static final long LOST = -1;

  /** What becomes of a copy. */
  @FunctionalInterface
  public interface Air {
    /**
     * The copy's delay in ns from 0, or {@link #LOST}.
     *
     * @param rng the link's
     */
    long delayNsOrLost(Rng rng);
  }

  private final Radio below;
  private final List<RobotId> peers = new ArrayList<>();
  private final Clock clock;
  private final Timers timers;
  private final Rng rng;
  private final Air air;
  private final Map<RobotId, Rng> links = new TreeMap<>();
  private long sent;
  private long copies;
  private long lost;

  /**
   * @param self whose radio it is
   * @param robots whom a broadcast goes to, itself aside
   * @param timers the strand's, on {@code clock}
   * @param rng forked for each link by the recipient's name
   */
  public LossyRadio(
      Radio below,
      RobotId self,
      Iterable<RobotId> robots,
      Clock clock,
      Timers timers,
      Rng rng,
      Air air) {
    this.below = below;
    this.clock = clock;
    this.timers = timers;
    this.rng = rng;
    this.air = air;
    for (RobotId robot : robots) {
      if (!robot.equals(self)) {
        peers.add(robot);
      }
    }
  }

  @Override
  public void send(RobotId to, byte[] buffer, int length) {
    byte[] datagram = copy(buffer, length);
    sent++;
    transmit(to, datagram);
  }

  @Override
  public void broadcast(byte[] buffer, int length) {
    byte[] datagram = copy(buffer, length);
    sent++;
    for (RobotId peer : peers) {
      transmit(peer, datagram);
    }
  }

  @Override
  public void onReceive(Receiver receiver) {
    below.onReceive(receiver);
  }

  /** Datagrams that the robot has sent; a broadcast is one. */
  public long sent() {
    return sent;
  }

  /** Copies of them, one for each recipient. */
  public long copies() {
    return copies;
  }

  /** Copies that the air has lost. */
  public long lost() {
    return lost;
  }

  private void transmit(RobotId to, byte[] datagram) {
    copies++;
    long delayNs = air.delayNsOrLost(links.computeIfAbsent(to, id -> rng.fork(id.name())));
    if (delayNs == LOST) {
      lost++;
    } else {
      timers.timer(() -> below.send(to, datagram, datagram.length)).set(clock.nowNs() + delayNs);
    }
  }

  private static byte[] copy(byte[] buffer, int length) {
    if (length < 0 || length > MAX_BYTES || length > buffer.length) {
      throw new IllegalArgumentException(
          "datagram of " + length + " bytes: expected 0 to " + Math.min(MAX_BYTES, buffer.length));
    }
    return Arrays.copyOf(buffer, length);
  }
}
