package org.starl.robot.optitrack;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketException;
import java.util.List;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.platform.Positioning;
import org.starl.platform.Strand;

/**
 * Poses from any measuring system that can send UDP: each datagram is one JSON line for one robot.
 *
 * <pre>{"robot":"bot0","xMm":1200,"yMm":-350.5,"headingRad":1.57,"errorMm":4,"atNs":81234000}</pre>
 *
 * <p>{@code atNs} is the time of measurement on a clock of the sender that never jumps back and has
 * any origin. {@code "errorRad"} is optional. Other keys are refused.
 */
public final class JsonFeed implements PoseFeed {

  private static final int WAIT_MS = 1000;

  private final JsonFeedSettings settings;
  private final Clock clock;
  private final DatagramSocket socket;
  private final Reception reception;
  private final Followers followers = new Followers();
  private final ReentrantLock lock = new ReentrantLock();

  // Guarded by the lock.
  private final Tally tally;
  private final JsonProtocol protocol;

  private JsonFeed(JsonFeedSettings settings, Clock clock, LogSink log, DatagramSocket socket) {
    this.settings = settings;
    this.clock = clock;
    this.socket = socket;
    this.tally = new Tally(log, "json feed");
    this.protocol = new JsonProtocol(settings.bounds(), tally);
    this.reception = Reception.start("json feed", socket, WAIT_MS, this::take, this::fail);
  }

  /**
   * Listens from now on.
   *
   * @param clock the robot's, for the fixes' times; read by another thread
   * @param log takes a line from the feed's thread for the first error of each kind
   * @throws IOException if the address is not available
   */
  public static JsonFeed open(JsonFeedSettings settings, Clock clock, LogSink log)
      throws IOException {
    try {
      return new JsonFeed(settings, clock, log, new DatagramSocket(settings.address()));
    } catch (SocketException e) {
      throw new IOException("JSON feed at " + settings.address() + ": " + e.getMessage(), e);
    }
  }

  /** Where it listens. */
  public InetSocketAddress address() {
    return new InetSocketAddress(socket.getLocalAddress(), socket.getLocalPort());
  }

  @Override
  public Positioning positioning(Strand strand, String name) {
    return followers.follow(strand, name, body -> body.name().equals(name));
  }

  @Override
  public void onBodies(Consumer<List<TrackedBody>> watcher) {
    followers.watch(watcher);
  }

  @Override
  public FeedStatistics statistics() {
    lock.lock();
    try {
      return tally.statistics();
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void close() {
    reception.close();
  }

  private void take(@Nullable DatagramPacket packet) {
    TrackedBody body = packet == null ? null : judge(packet, clock.nowNs());
    if (body != null) {
      followers.publish(List.of(body));
    }
  }

  private @Nullable TrackedBody judge(DatagramPacket packet, long nowNs) {
    InetAddress sender = settings.sender();
    lock.lock();
    try {
      tally.received();
      if (sender != null && !packet.getAddress().equals(sender)) {
        tally.drop(FeedDrop.FOREIGN, "a datagram from " + packet.getAddress(), nowNs);
        return null;
      }
      return protocol.received(packet.getData(), packet.getLength(), nowNs);
    } finally {
      lock.unlock();
    }
  }

  private void fail(Exception e) {
    lock.lock();
    try {
      tally.warnOnce("failed", "no more fixes: " + e, clock.nowNs());
    } finally {
      lock.unlock();
    }
  }
}
