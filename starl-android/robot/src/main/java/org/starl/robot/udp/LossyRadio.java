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
 * A lossy radio: each copy that its robot sends to a recipient is lost or delayed by the random
 * generator of that link. Receiving is passed through to the radio below.
 *
 * <p>A copy leaves in a later piece of the strand, after the sending action has ended and its trace is
 * written. So, on one clock, every effect of a message comes after all events of the sending action.
 * Strand only.
 */
public final class LossyRadio implements Radio {

  /** The delay of a lost copy. */
  public static final long LOST = -1;

  /** Decides whether a copy is lost, and its delay. */
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
  private long copies;
  private long lost;

  /**
   * @param self the radio's robot
   * @param robots the recipients of a broadcast, except {@code self}
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
    transmit(to, datagram);
  }

  @Override
  public void broadcast(byte[] buffer, int length) {
    byte[] datagram = copy(buffer, length);
    for (RobotId peer : peers) {
      transmit(peer, datagram);
    }
  }

  @Override
  public void onReceive(Receiver receiver) {
    below.onReceive(receiver);
  }

  /** Number of copies of the robot's datagrams, one for each recipient. */
  public long copies() {
    return copies;
  }

  /** Number of lost copies. */
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
    Radio.checkLength(buffer, length);
    return Arrays.copyOf(buffer, length);
  }
}
