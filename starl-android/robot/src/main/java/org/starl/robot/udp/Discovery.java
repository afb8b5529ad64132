package org.starl.robot.udp;

import static org.starl.time.Time.NS_PER_MS;

import java.net.DatagramPacket;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.InterfaceAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.starl.StorageEpoch;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.Clock;
import org.starl.platform.StableStorage;
import org.starl.platform.Strand;
import org.starl.robot.realtime.Daemons;
import org.starl.robot.udp.Beacon.Answer;
import org.starl.robot.udp.Neighbours.Verdict;
import org.starl.session.Nonce;
import org.starl.session.PairKey;
import org.starl.session.Session;
import org.starl.session.Start;

/**
 * Finds the other robots, proves to them that this robot has started and learns the same of them, and
 * suspects silent ones; by beacons over the radio's own socket. It gives the radio the addresses of its
 * peers, and opens the sessions with them. Beacons go to known addresses and, if configured, as
 * broadcasts out of every interface. It has its own thread below the strand, so that a robot that
 * computes for long still sends beacons.
 *
 * <p>A beacon that is recorded and sent again proves nothing, since it has not the nonce of this start
 * ({@link Neighbours}); one that is forwarded does not come from the address that it contains.
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

    /** This robot refuses a start of another robot, and has told it; once for each start. */
    void refused(RobotId robot, InetSocketAddress address, boolean isOtherStorage);

    /**
     * The robot's storage is new, and too few other robots know it yet: see {@link #storage}. Called
     * again with each robot that is suspected.
     *
     * @param knownTo those that do, in order
     */
    void unknown(List<RobotId> knownTo);

    /**
     * This machine must not run this robot: another one does, or this one has lost its storage. With
     * keys, this is proven.
     *
     * @param why one line for people
     */
    void disowned(String why);
  }

  private final UdpRadio radio;
  private final RobotId self;
  private final Participants deployment;
  private final SortedMap<RobotId, InetSocketAddress> known;
  private final @Nullable PeerKeys keys;
  private final OpenSessions sessions;
  private final Strand strand;
  private final StableStorage stable;
  private final KnownStorage storage;
  private final long epoch;
  private final Settings settings;
  private final Clock clock;
  private final Listener listener;
  private final ScheduledExecutorService worker;
  private final InetSocketAddress bound;
  private @Nullable Future<?> ticks;

  private final SecureRandom random = new SecureRandom();

  // Guarded by this.
  private final Map<RobotId, List<SigningKey>> signing = new TreeMap<>();
  private final Map<RobotId, SigningKey> genuine = new TreeMap<>();
  private final Map<RobotId, Start> refused = new TreeMap<>();
  private Start mine = new Start(0, 1, Nonce.NONE);
  private @Nullable Neighbours neighbours;
  private long count;

  /**
   * Sends nothing before {@link #begin}.
   *
   * @param known the fixed addresses; these robots are the radio's peers at once, and their beacons
   *     are accepted from these addresses only
   * @param keys sign beacons; null: any host could send them, so robots outside {@code known} are not
   *     accepted
   * @param sessions receives a session with each robot, if there are keys
   * @param stable the robot's; its strand does not use it yet. It receives the storage's epoch and
   *     the latest start of each other robot
   * @param clock read by several threads
   */
  public Discovery(
      UdpRadio radio,
      RobotId self,
      Participants deployment,
      SortedMap<RobotId, InetSocketAddress> known,
      @Nullable PeerKeys keys,
      OpenSessions sessions,
      Strand strand,
      StableStorage stable,
      Settings settings,
      Clock clock,
      Listener listener) {
    this.radio = radio;
    this.self = self;
    this.deployment = deployment;
    this.known = Collections.unmodifiableSortedMap(new TreeMap<>(known));
    this.keys = keys;
    this.sessions = sessions;
    this.strand = strand;
    this.stable = stable;
    storage = new KnownStorage(stable, strand, deployment.size() == 1);
    epoch = StorageEpoch.ofOrNew(stable, random);
    this.settings = settings;
    this.clock = clock;
    this.listener = listener;
    bound = radio.address();
    if (keys != null) {
      for (RobotId robot : deployment) {
        List<SigningKey> list = new ArrayList<>();
        keys.with(robot).forEach(pair -> list.add(new SigningKey(pair)));
        signing.put(robot, list);
      }
    }
    worker = Executors.newSingleThreadScheduledExecutor(Daemons.factory(self + " beacons"));
    this.known.forEach(radio::setPeer);
  }

  /**
   * Begins. Strand only.
   *
   * @param boot number of this start of the robot's program, in stable storage
   */
  public synchronized void begin(int boot) {
    storage.begin();
    mine = new Start(epoch, boot, Nonce.draw(random));
    Neighbours all =
        new Neighbours(
            self, mine, deployment, settings.suspectAfterMs() * NS_PER_MS, clock.nowNs());
    LatestStarts.of(stable, deployment).forEach(all::remember);
    neighbours = all;
    radio.onBeacon(packet -> received(all, packet));
    ticks =
        worker.scheduleAtFixedRate(
            () -> tickOrFail(all), 0, settings.everyMs(), TimeUnit.MILLISECONDS);
  }

  /** The robot's storage as its program uses it: what it promises must not be lost unnoticed. */
  public StableStorage storage() {
    return storage;
  }

  /** The time of a robot's last beacon; null if it was never heard. From any thread. */
  public synchronized @Nullable Long lastHeardNs(RobotId robot) {
    return neighbours == null ? null : neighbours.lastHeardNs(robot);
  }

  /** Sends no more beacons and reports nothing more. */
  @Override
  public synchronized void close() {
    if (ticks != null) {
      ticks.cancel(false);
    }
    worker.shutdown();
  }

  // An exception would silently cancel all later runs.
  private void tickOrFail(Neighbours all) {
    try {
      tick(all);
    } catch (RuntimeException bug) {
      radio.fail(bug);
    }
  }

  private void tick(Neighbours all) {
    if (radio.isClosed()) {
      return;
    }
    List<RobotId> suspected;
    synchronized (this) {
      suspected = all.newlySuspected(clock.nowNs());
    }
    for (RobotId robot : suspected) {
      listener.suspected(robot, lastHeardNs(robot));
    }
    if (!suspected.isEmpty() && !storage.isKnown()) {
      listener.unknown(knownTo(all));
    }
    for (RobotId robot : deployment) {
      InetSocketAddress address = addressOf(all, robot);
      if (!robot.equals(self) && address != null) {
        proveAgain(all, robot, address);
      }
    }
    if (settings.broadcastPort() > 0) {
      broadcast(bound.getAddress());
    }
  }

  private synchronized List<RobotId> knownTo(Neighbours all) {
    return all.knownTo();
  }

  private synchronized @Nullable InetSocketAddress addressOf(Neighbours all, RobotId robot) {
    InetSocketAddress fixed = known.get(robot);
    return fixed == null ? all.addressOf(robot) : fixed;
  }

  private synchronized void proveAgain(Neighbours all, RobotId robot, InetSocketAddress at) {
    prove(robot, all.echoTo(robot), all.answerTo(robot), at);
  }

  private void broadcast(InetAddress here) {
    for (InterfaceAddress interfaceAddress : broadcasting()) {
      InetAddress address = interfaceAddress.getAddress();
      if (here.isAnyLocalAddress() || here.equals(address)) {
        announce(
            address,
            new InetSocketAddress(interfaceAddress.getBroadcast(), settings.broadcastPort()));
      }
    }
  }

  /** Sends a beacon for all robots, which proves nothing. */
  void announce(InetAddress here, InetSocketAddress to) {
    emit(beacon(here, null, Nonce.NONE, Answer.NOT_STORED).write(null), to);
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

  /** Sends a beacon that proves this start to one robot, which has sent that nonce. */
  private void prove(RobotId to, Nonce echo, Answer answer, InetSocketAddress at) {
    InetAddress here = bound.getAddress();
    byte[] bytes;
    synchronized (this) {
      Beacon beacon = beacon(here.isAnyLocalAddress() ? null : here, to, echo, answer);
      SigningKey key = keyTo(to);
      if (keys != null && key == null) {
        return;
      }
      bytes = beacon.write(key);
    }
    emit(bytes, at);
  }

  // While a key is replaced two are listed for a robot. It is unknown which one it has until its
  // first beacon, so that each is tried.
  private @Nullable SigningKey keyTo(RobotId robot) {
    SigningKey used = genuine.get(robot);
    List<SigningKey> list = signing.getOrDefault(robot, List.of());
    return used != null || list.isEmpty() ? used : list.get(random.nextInt(list.size()));
  }

  private synchronized Beacon beacon(
      @Nullable InetAddress here, @Nullable RobotId to, Nonce echo, Answer answer) {
    count++;
    return new Beacon(self, mine, count, here, bound.getPort(), to, echo, answer);
  }

  private void emit(byte[] bytes, InetSocketAddress to) {
    radio.transmit(to, bytes, bytes.length);
  }

  // On the radio's thread.
  private void received(Neighbours all, DatagramPacket packet) {
    InetSocketAddress source = (InetSocketAddress) packet.getSocketAddress();
    Beacon beacon = Beacon.readOrNull(packet.getData(), packet.getLength());
    if (beacon == null) {
      radio.dropped(UdpDrop.FORGED_BEACON, source);
      return;
    }
    Verdict verdict;
    PairKey pair = null;
    synchronized (this) {
      if (keys != null && beacon.to() != null) {
        SigningKey key = keyOrNull(beacon.robot(), Beacon.keyId(packet.getData()));
        if (key == null) {
          radio.dropped(UdpDrop.UNKNOWN_KEY_BEACON, source);
          return;
        }
        if (!Beacon.isSignedWith(key, packet.getData(), packet.getLength())) {
          radio.dropped(UdpDrop.FORGED_BEACON, source);
          return;
        }
        genuine.put(beacon.robot(), key);
        pair = key.pair();
      }
      if (!isFromItsAddress(beacon, source)) {
        radio.dropped(UdpDrop.PASSED_ON_BEACON, source);
        return;
      }
      verdict = all.hear(beacon, source, clock.nowNs());
      if (all.isKnown()) {
        storage.becomeKnown();
      }
    }
    act(all, verdict, beacon, source, pair);
  }

  private void act(
      Neighbours all,
      Verdict verdict,
      Beacon beacon,
      InetSocketAddress source,
      @Nullable PairKey pair) {
    RobotId robot = beacon.robot();
    Nonce echo = beacon.start().nonce();
    switch (verdict) {
      case STARTED -> {
        radio.setPeer(robot, source);
        strand.post(() -> started(all, robot, beacon.start(), pair, source));
        listener.appeared(robot, source);
      }
      case APPEARED -> {
        radio.setPeer(robot, source);
        listener.appeared(robot, source);
      }
      case HEARD -> radio.setPeer(robot, source);
      case UNPROVEN -> {
        radio.dropped(UdpDrop.UNPROVEN_BEACON, source);
        prove(robot, echo, Answer.NOT_STORED, source);
      }
      case REFUSED -> refuse(all, beacon, source);
      case TWIN -> {
        prove(robot, echo, Answer.NOT_STORED, source);
        listener.disowned(
            String.format(
                "another machine runs %s too, at %s; both stop: start one of them", robot, source));
      }
      case REFUSES_US ->
          listener.disowned(
              beacon.answer() == Answer.OTHER_STORAGE
                  ? robot
                      + " knows another storage of "
                      + self
                      + ": the promises in it are lost. Bring it back, or start all robots with"
                      + " empty storage"
                  : robot
                      + " knows a later start of "
                      + self
                      + ": another machine runs it, or this storage is an old copy");
      // Over two interfaces each beacon arrives twice.
      case OLD -> radio.dropped(UdpDrop.OLD_BEACON, source);
      // A broadcast comes back to its sender.
      case OWN -> radio.dropped(UdpDrop.OWN_BEACON, source);
      case STRANGE -> radio.dropped(UdpDrop.STRANGE_BEACON, source);
    }
  }

  // First the storage: an older start must not be accepted after this robot has started again.
  private void started(
      Neighbours all,
      RobotId robot,
      Start start,
      @Nullable PairKey pair,
      InetSocketAddress source) {
    LatestStarts.put(
        stable,
        robot,
        start,
        () -> {
          if (pair != null) {
            sessions.open(robot, new Session(pair, self, mine(), robot, start));
          }
          synchronized (this) {
            all.stored(robot, start);
          }
          // Now this robot accepts what the other one sends when it hears this.
          prove(robot, start.nonce(), Answer.ACCEPTED, source);
        });
  }

  private synchronized Start mine() {
    return mine;
  }

  private void refuse(Neighbours all, Beacon beacon, InetSocketAddress source) {
    Answer answer;
    boolean isNew;
    synchronized (this) {
      answer = all.answerTo(beacon.robot(), beacon.start());
      isNew = !beacon.start().equals(refused.put(beacon.robot(), beacon.start()));
    }
    if (isNew) {
      listener.refused(beacon.robot(), source, answer == Answer.OTHER_STORAGE);
    }
    prove(beacon.robot(), beacon.start().nonce(), answer, source);
  }

  private @Nullable SigningKey keyOrNull(RobotId robot, int id) {
    for (SigningKey key : signing.getOrDefault(robot, List.of())) {
      if (key.id() == id) {
        return key;
      }
    }
    return null;
  }

  private boolean isFromItsAddress(Beacon beacon, InetSocketAddress source) {
    InetSocketAddress fixed = known.get(beacon.robot());
    if (fixed != null && !beacon.robot().equals(self)) {
      return fixed.equals(source);
    }
    // Without a signature any sender could use any robot's name.
    return keys != null && beacon.isFrom(source);
  }
}
