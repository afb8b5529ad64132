package org.starl.robot.udp;

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
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.Clock;
import org.starl.platform.DeploymentKey;

/**
 * Who is where, and who has fallen silent: says by beacons that this robot is here, over its radio's own
 * socket, and tells the radio where the others are. Beacons go to the robots whose addresses are known
 * and, if wanted, as broadcasts out of every interface. It has a thread of its own, below the strand: a
 * robot that computes for long is not silent.
 *
 * <p>Who has not got the key is not believed. A beacon that is recorded and sent again is old; one that
 * is passed on does not come from where it says.
 */
public final class Discovery implements AutoCloseable {

  /**
   * How beacons go.
   *
   * @param everyMs one goes out so often
   * @param suspectAfterMs who has not been heard for so long is suspected
   * @param broadcastPort where the others' radios listen to broadcasts; 0: there are none
   */
  public record Settings(long everyMs, long suspectAfterMs, int broadcastPort) {}

  /** Is told, on threads of the radio, and must not wait. */
  public interface Listener {

    /** A robot is heard, for the first time or after a silence. */
    void appeared(RobotId robot, InetSocketAddress address);

    /**
     * A robot has not been heard for too long; it may live all the same.
     *
     * @param lastHeardNs on the clock given, or null if it was never heard
     */
    void suspected(RobotId robot, @Nullable Long lastHeardNs);
  }

  private static final long NS_PER_MS = 1_000_000;

  private final UdpRadio radio;
  private final RobotId self;
  private final SortedMap<RobotId, InetSocketAddress> known;
  private final Settings settings;
  private final long start;
  private final Clock clock;
  private final Listener listener;
  private final ScheduledExecutorService worker;
  private final ReentrantLock lock = new ReentrantLock();

  private final InetSocketAddress bound;
  private @Nullable Future<?> ticks;

  // Guarded by the lock.
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
    worker =
        Executors.newSingleThreadScheduledExecutor(work -> {
          Thread thread = new Thread(work, self + " beacons");
          thread.setDaemon(true);
          return thread;
        });
  }

  /**
   * Begins.
   *
   * @param known where robots with fixed addresses listen; they are the radio's peers at once, and
   *     their beacons are taken from nowhere else
   * @param key signs; null: anybody may say that he is one of the robots, so none is looked for
   *     outside {@code known}
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

  /** When a robot was heard last, on the clock given; null if it never was. From any thread. */
  public @Nullable Long lastHeardNs(RobotId robot) {
    lock.lock();
    try {
      return neighbours.lastHeardNs(robot);
    } finally {
      lock.unlock();
    }
  }

  /** Says and tells nothing more. */
  @Override
  public void close() {
    if (ticks != null) {
      ticks.cancel(false);
    }
    worker.shutdown();
  }

  // What comes out of a piece of work ends all later ones without a word.
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
    lock.lock();
    try {
      suspected = neighbours.newlySuspected(nowNs);
      count++;
    } finally {
      lock.unlock();
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

  // Interfaces come and go: they are looked at each time.
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
      // A machine that cannot tell its interfaces now has none to use; it is asked again.
      return found;
    }
    return found;
  }

  private void emit(@Nullable InetAddress mine, InetSocketAddress to) {
    byte[] bytes;
    lock.lock();
    try {
      bytes = codec.write(new Beacon(self, start, count, mine, bound.getPort()));
    } finally {
      lock.unlock();
    }
    radio.transmit(to, bytes, bytes.length);
  }

  // On the radio's thread.
  private void received(DatagramPacket packet) {
    InetSocketAddress source = (InetSocketAddress) packet.getSocketAddress();
    Neighbours.Verdict verdict;
    Beacon beacon;
    lock.lock();
    try {
      beacon = codec.readOrNull(packet.getData(), packet.getLength());
      if (beacon == null) {
        radio.dropped(UdpDrop.FORGED_BEACON, source);
        return;
      }
      if (beacon.robot().equals(self)) {
        // A broadcast comes back to who sent it.
        radio.dropped(UdpDrop.OWN_BEACON, source);
        return;
      }
      if (!comesFromWhereItSays(beacon, source)) {
        radio.dropped(UdpDrop.PASSED_ON_BEACON, source);
        return;
      }
      verdict = neighbours.hear(beacon, clock.nowNs());
    } finally {
      lock.unlock();
    }
    switch (verdict) {
      case APPEARED -> {
        radio.setPeer(beacon.robot(), source);
        listener.appeared(beacon.robot(), source);
      }
      case HEARD -> radio.setPeer(beacon.robot(), source);
      // Over two interfaces each beacon comes twice.
      case OLD -> radio.dropped(UdpDrop.OLD_BEACON, source);
      case STRANGE -> radio.dropped(UdpDrop.STRANGE_BEACON, source);
    }
  }

  private boolean comesFromWhereItSays(Beacon beacon, InetSocketAddress source) {
    InetSocketAddress fixed = known.get(beacon.robot());
    if (fixed != null) {
      return fixed.equals(source);
    }
    // Without a signature anybody may be anybody.
    return codec.isSigned() && beacon.address() != null && beacon.reachedFrom(source) != null;
  }
}
