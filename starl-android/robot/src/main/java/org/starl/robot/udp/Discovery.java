package org.starl.robot.udp;

import static org.starl.time.Time.NS_PER_MS;

import java.net.DatagramPacket;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.InterfaceAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.Clock;
import org.starl.platform.DeploymentKey;
import org.starl.robot.realtime.Daemons;

/**
 * Finds the other robots and suspects silent ones, by beacons over the radio's own socket; it gives
 * the radio the addresses of its peers. Beacons go to known addresses and, if configured, as broadcasts
 * out of every interface. It has its own thread below the strand, so that a robot that computes for
 * long still sends beacons.
 *
 * <p>Beacons that are not signed with the deployment's key are dropped. A beacon that is recorded and
 * sent again is old; one that is forwarded does not come from the address that it contains.
 */
public final class Discovery implements AutoCloseable {

  /**
   * Settings of the beacons.
   *
   * @param everyMs time between two beacons
   * @param suspectAfterMs a robot that was not heard for this time is suspected
   * @param broadcastPort UDP port of broadcast beacons; 0: none are broadcast
   */
  public record Settings(long everyMs, long suspectAfterMs, int broadcastPort) {}

  /** Called on threads of the radio; must not block. */
  public interface Listener {

    /** A robot was heard for the first time, or again after a silence. */
    void appeared(RobotId robot, InetSocketAddress address);

    /**
     * A robot was not heard for too long; it may be alive all the same.
     *
     * @param lastHeardNs by this robot's clock; null if it was never heard
     */
    void suspected(RobotId robot, @Nullable Long lastHeardNs);
  }

  private final UdpRadio radio;
  private final RobotId self;
  private final SortedMap<RobotId, InetSocketAddress> known;
  private final Settings settings;
  private final long start;
  private final Clock clock;
  private final Listener listener;
  private final ScheduledExecutorService worker;

  private final InetSocketAddress bound;
  private @Nullable Future<?> ticks;

  // Guarded by this.
  private final Beacon.Codec codec;
  private final Neighbours neighbours;
  private long count;

  private Discovery(
      UdpRadio radio,
      RobotId self,
      Participants deployment,
      SortedMap<RobotId, InetSocketAddress> known,
      @Nullable DeploymentKey key,
      Settings settings,
      long start,
      Clock clock,
      Listener listener) {
    this.radio = radio;
    this.self = self;
    this.known = Collections.unmodifiableSortedMap(new TreeMap<>(known));
    this.settings = settings;
    this.start = start;
    this.clock = clock;
    this.listener = listener;
    bound = radio.address();
    codec = new Beacon.Codec(key);
    neighbours =
        new Neighbours(self, deployment, settings.suspectAfterMs() * NS_PER_MS, clock.nowNs());
    worker = Executors.newSingleThreadScheduledExecutor(Daemons.factory(self + " beacons"));
  }

  /**
   * Begins.
   *
   * @param known the fixed addresses; these robots are the radio's peers at once, and their beacons
   *     are accepted from these addresses only
   * @param key signs beacons; null: any host could send them, so robots outside {@code known} are not
   *     accepted
   * @param start larger at each start of this robot's program: {@link StartNumber}
   * @param clock read by several threads
   */
  public static Discovery open(
      UdpRadio radio,
      RobotId self,
      Participants deployment,
      SortedMap<RobotId, InetSocketAddress> known,
      @Nullable DeploymentKey key,
      Settings settings,
      long start,
      Clock clock,
      Listener listener) {
    Discovery discovery =
        new Discovery(radio, self, deployment, known, key, settings, start, clock, listener);
    discovery.known.forEach(radio::setPeer);
    radio.onBeacon(discovery::received);
    discovery.ticks =
        discovery.worker.scheduleAtFixedRate(
            discovery::tickOrFail, 0, settings.everyMs(), TimeUnit.MILLISECONDS);
    return discovery;
  }

  /** The time of a robot's last beacon; null if it was never heard. From any thread. */
  public synchronized @Nullable Long lastHeardNs(RobotId robot) {
    return neighbours.lastHeardNs(robot);
  }

  /** Sends no more beacons and reports nothing more. */
  @Override
  public void close() {
    if (ticks != null) {
      ticks.cancel(false);
    }
    worker.shutdown();
  }

  // An exception would silently cancel all later runs.
  private void tickOrFail() {
    try {
      tick();
    } catch (RuntimeException bug) {
      radio.fail(bug);
    }
  }

  private void tick() {
    if (radio.isClosed()) {
      return;
    }
    long nowNs = clock.nowNs();
    List<RobotId> suspected;
    synchronized (this) {
      suspected = neighbours.newlySuspected(nowNs);
      count++;
    }
    for (RobotId robot : suspected) {
      listener.suspected(robot, lastHeardNs(robot));
    }
    InetAddress here = bound.getAddress();
    InetAddress mine = here.isAnyLocalAddress() ? null : here;
    known.forEach((robot, address) -> {
      if (!robot.equals(self)) {
        emit(mine, address);
      }
    });
    if (settings.broadcastPort() > 0) {
      broadcast(here);
    }
  }

  private void broadcast(InetAddress here) {
    for (InterfaceAddress interfaceAddress : broadcasting()) {
      InetAddress address = interfaceAddress.getAddress();
      if (here.isAnyLocalAddress() || here.equals(address)) {
        emit(
            address,
            new InetSocketAddress(interfaceAddress.getBroadcast(), settings.broadcastPort()));
      }
    }
  }

  // Interfaces come and go: they are listed anew each time.
  private static List<InterfaceAddress> broadcasting() {
    List<InterfaceAddress> found = new ArrayList<>();
    try {
      for (NetworkInterface each : Collections.list(NetworkInterface.getNetworkInterfaces())) {
        if (!each.isUp() || each.isLoopback()) {
          continue;
        }
        for (InterfaceAddress address : each.getInterfaceAddresses()) {
          if (address.getAddress() instanceof Inet4Address && address.getBroadcast() != null) {
            found.add(address);
          }
        }
      }
    } catch (SocketException e) {
      // Without a list of interfaces none can be used now; the next beacon tries again.
      return found;
    }
    return found;
  }

  private void emit(@Nullable InetAddress mine, InetSocketAddress to) {
    byte[] bytes;
    synchronized (this) {
      bytes = codec.write(new Beacon(self, start, count, mine, bound.getPort()));
    }
    radio.transmit(to, bytes, bytes.length);
  }

  // On the radio's thread.
  private void received(DatagramPacket packet) {
    InetSocketAddress source = (InetSocketAddress) packet.getSocketAddress();
    Beacon beacon;
    Neighbours.Verdict verdict;
    synchronized (this) {
      beacon = codec.readOrNull(packet.getData(), packet.getLength());
      if (beacon == null) {
        radio.dropped(UdpDrop.FORGED_BEACON, source);
        return;
      }
      if (beacon.robot().equals(self)) {
        // A broadcast comes back to its sender.
        radio.dropped(UdpDrop.OWN_BEACON, source);
        return;
      }
      if (!isFromItsAddress(beacon, source)) {
        radio.dropped(UdpDrop.PASSED_ON_BEACON, source);
        return;
      }
      verdict = neighbours.hear(beacon, clock.nowNs());
    }
    switch (verdict) {
      case APPEARED -> {
        radio.setPeer(beacon.robot(), source);
        listener.appeared(beacon.robot(), source);
      }
      case HEARD -> radio.setPeer(beacon.robot(), source);
      // Over two interfaces each beacon arrives twice.
      case OLD -> radio.dropped(UdpDrop.OLD_BEACON, source);
      case STRANGE -> radio.dropped(UdpDrop.STRANGE_BEACON, source);
    }
  }

  private boolean isFromItsAddress(Beacon beacon, InetSocketAddress source) {
    InetSocketAddress fixed = known.get(beacon.robot());
    if (fixed != null) {
      return fixed.equals(source);
    }
    // Without a signature any sender could use any robot's name.
    return codec.isSigned() && beacon.address() != null && beacon.reachedFrom(source) != null;
  }
}
