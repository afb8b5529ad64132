package org.starl.robot.optitrack;

import static org.starl.robot.optitrack.NatNetProtocol.printable;
import static org.starl.time.Time.NS_PER_S;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Fix;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.platform.Positioning;
import org.starl.platform.Strand;
import org.starl.robot.realtime.Daemons;

/**
 * The robots' positions from one measuring system. From any thread.
 *
 * <p>It has one thread for each UDP socket, which reads datagrams and publishes their bodies. Its lock
 * guards the tally and the state of subclasses; bodies are published without it.
 */
public abstract class PoseFeed implements AutoCloseable {

  /** In place of the time of a fix: its absence has been told. */
  private static final long TOLD = Long.MAX_VALUE;

  private record Follower(Predicate<TrackedBody> body, StrandPositioning positioning) {}

  final Clock clock;
  final Tally tally;
  private final List<DatagramSocket> sockets = new CopyOnWriteArrayList<>();
  private final List<Thread> threads = new CopyOnWriteArrayList<>();
  private final List<Follower> followers = new CopyOnWriteArrayList<>();
  private final Map<String, Long> fixedNs = new TreeMap<>();
  private final SortedMap<String, Fix> newest = new ConcurrentSkipListMap<>();
  private final List<Consumer<List<TrackedBody>>> watchers = new CopyOnWriteArrayList<>();

  PoseFeed(Clock clock, LogSink log, String tag) {
    this.clock = clock;
    this.tally = new Tally(log, tag);
  }

  /**
   * Reads a datagram, with the feed's lock held.
   *
   * @param packet null if none arrived within the socket's waiting time
   * @return the bodies to publish
   */
  abstract List<TrackedBody> read(@Nullable DatagramPacket packet, long nowNs);

  /** A followed body without a fix for this time is told, with what to look at. */
  static final long SILENT_NS = 2 * NS_PER_S;

  /** Why there may be no fixes, with the feed's lock held. */
  String silence(long nowNs) {
    return tally.statistics().received() + " messages have come, but not its place; " + dropped();
  }

  /** If a body has no fix: what comes instead, and what to look at, for people. */
  public final synchronized String silence() {
    return silence(clock.nowNs());
  }

  static String text(InetSocketAddress address) {
    return address.getAddress().getHostAddress() + ":" + address.getPort();
  }

  /** What was dropped, for messages. */
  final String dropped() {
    return "dropped " + tally.statistics().dropped();
  }

  /** Starts a thread that reads from {@code socket} until it is closed. */
  final void receive(String threadName, DatagramSocket socket, int waitMs) {
    Thread thread = Daemons.of(threadName, () -> receiveAll(socket, waitMs));
    sockets.add(socket);
    threads.add(thread);
    thread.start();
  }

  /**
   * The fixes of the bodies that satisfy {@code body}, on {@code strand}.
   *
   * @param name of the body, for messages
   */
  final Positioning follow(Strand strand, String name, Predicate<TrackedBody> body) {
    StrandPositioning positioning = new StrandPositioning(strand, name);
    followers.add(new Follower(body, positioning));
    return positioning;
  }

  /** The fixes of the body {@code name}, on {@code strand}; only the newest if the strand is late. */
  public Positioning positioning(Strand strand, String name) {
    synchronized (this) {
      fixedNs.put(name, clock.nowNs());
    }
    return follow(strand, name, body -> body.name().equals(name));
  }

  /**
   * Passes all bodies of each message to {@code watcher} from now on, on the feed's own thread; the
   * watcher must not block.
   */
  public void onBodies(Consumer<List<TrackedBody>> watcher) {
    watchers.add(watcher);
  }

  /**
   * Judges the fixes of the body {@code name}, a robot, by its wheels, too.
   *
   * @param onDoubt called on the feed's own thread as soon as two streams of its poses contradict each
   *     other, or its wheels: it must stop until its next fix, and the call must not block
   */
  public synchronized void own(String name, WheelPath path, Runnable onDoubt) {
    tally.own(name, path, onDoubt);
  }

  /** The newest fix of each body, by its name; a copy. */
  public SortedMap<String, Fix> newest() {
    return new TreeMap<>(newest);
  }

  public synchronized FeedStatistics statistics() {
    return tally.statistics();
  }

  /** Receives nothing more. */
  @Override
  public void close() {
    sockets.forEach(DatagramSocket::close);
    threads.forEach(thread -> Daemons.join(thread, 0));
  }

  private void receiveAll(DatagramSocket socket, int waitMs) {
    DatagramReceiver receiver = new DatagramReceiver(socket);
    while (!socket.isClosed()) {
      try {
        DatagramPacket packet = receiver.receive(waitMs);
        publish(lockedRead(packet));
      } catch (IOException | RuntimeException e) {
        if (!socket.isClosed()) {
          sockets.forEach(DatagramSocket::close);
          fail(e);
        }
      }
    }
  }

  private synchronized List<TrackedBody> lockedRead(@Nullable DatagramPacket packet) {
    if (packet != null) {
      tally.received();
    }
    long nowNs = clock.nowNs();
    List<TrackedBody> bodies = read(packet, nowNs);
    for (TrackedBody body : bodies) {
      if (body.fix() != null) {
        fixedNs.replace(body.name(), nowNs);
      }
    }
    for (Map.Entry<String, Long> each : fixedNs.entrySet()) {
      if (each.getValue() != TOLD && nowNs - each.getValue() > SILENT_NS) {
        tally.warn(
            String.format(
                "no position of %s for %s s: %s",
                printable(each.getKey()), SILENT_NS / NS_PER_S, silence(nowNs)),
            nowNs);
        each.setValue(TOLD);
      }
    }
    return bodies;
  }

  private synchronized void fail(Exception e) {
    tally.warnOnce("failed", "no more fixes: " + e, clock.nowNs());
  }

  /** Gives bodies to those that follow them. */
  final void publish(List<TrackedBody> bodies) {
    if (bodies.isEmpty()) {
      return;
    }
    for (TrackedBody tracked : bodies) {
      if (tracked.fix() != null) {
        newest.put(tracked.name(), tracked.fix());
      }
    }
    for (Follower follower : followers) {
      for (TrackedBody tracked : bodies) {
        if (tracked.fix() != null && follower.body().test(tracked)) {
          follower.positioning().offer(tracked.fix());
        }
      }
    }
    watchers.forEach(watcher -> watcher.accept(bodies));
  }
}
