package org.starl.robot.optitrack;

import static org.starl.time.Time.NS_PER_S;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Clock;
import org.starl.platform.DeploymentKey;
import org.starl.robot.realtime.Daemons;
import org.starl.robot.realtime.RealClock;

/**
 * Sends the poses of a {@link PoseSource} as JSON lines to {@link JsonFeed}s, in place of a measuring
 * system. It has one thread, and receives nothing.
 */
public final class JsonServer implements AutoCloseable {

  private static final double LEAST_ERROR_MM = 0.01;

  private final List<InetSocketAddress> robots;
  private final @Nullable JsonSeal seal;
  private final PoseSource source;
  private final Clock clock;
  private final long periodNs;
  private final Consumer<Exception> onFailure;
  private final DatagramSocket socket;
  private final Thread thread;
  private final AtomicLong unsent = new AtomicLong();

  private JsonServer(
      List<InetSocketAddress> robots,
      @Nullable JsonSeal seal,
      PoseSource source,
      Clock clock,
      int linesPerS,
      Consumer<Exception> onFailure,
      DatagramSocket socket) {
    this.robots = List.copyOf(robots);
    this.seal = seal;
    this.source = source;
    this.clock = clock;
    this.periodNs = NS_PER_S / linesPerS;
    this.onFailure = onFailure;
    this.socket = socket;
    this.thread = Daemons.of("json server", this::run);
  }

  /**
   * Sends from now on.
   *
   * @param from the address to send from; port 0 for any free one
   * @param robots the feeds' addresses; each gets the lines of all bodies
   * @param key of the feed; null for lines without authentication
   * @param clock of the snapshots' times; with a key it is one of {@link RealClock#ofDate}
   * @param linesPerS for each body, from 1 to 1000
   * @param onFailure is called, on the server's thread, if it cannot continue
   * @throws IOException if the address is not available
   */
  public static JsonServer open(
      InetSocketAddress from,
      List<InetSocketAddress> robots,
      @Nullable DeploymentKey key,
      PoseSource source,
      Clock clock,
      int linesPerS,
      Consumer<Exception> onFailure)
      throws IOException {
    JsonServer server =
        new JsonServer(
            robots,
            key == null ? null : new JsonSeal(key),
            source,
            clock,
            linesPerS,
            onFailure,
            new DatagramSocket(from));
    server.thread.start();
    return server;
  }

  /** Number of datagrams that could not be sent. */
  public long unsent() {
    return unsent.get();
  }

  /** Sends nothing more. */
  @Override
  public void close() {
    socket.close();
    LockSupport.unpark(thread);
    Daemons.join(thread, 0);
  }

  private void run() {
    long nextNs = clock.nowNs();
    try {
      while (!socket.isClosed()) {
        long nowNs = clock.nowNs();
        if (nowNs < nextNs) {
          LockSupport.parkNanos(nextNs - nowNs);
        } else {
          nextNs = Math.max(nextNs + periodNs, nowNs);
          send(source.snapshot());
        }
      }
    } catch (RuntimeException e) {
      socket.close();
      onFailure.accept(e);
    }
  }

  private void send(PoseSource.Snapshot snapshot) {
    for (PoseSource.Body body : snapshot.bodies()) {
      if (body.isTracked()) {
        byte[] line = line(body, snapshot.atNs()).getBytes(StandardCharsets.US_ASCII);
        byte[] datagram = seal == null ? line : seal.seal(line);
        robots.forEach(robot -> send(datagram, robot));
      }
    }
  }

  private void send(byte[] datagram, InetSocketAddress robot) {
    try {
      socket.send(new DatagramPacket(datagram, datagram.length, robot));
    } catch (IOException e) {
      unsent.incrementAndGet();
    }
  }

  /** One line of the feed; {@code atNs} as a clock of {@link RealClock#ofDate} shows it. */
  static String line(PoseSource.Body body, long atNs) {
    return String.format(
        Locale.ROOT,
        "{\"robot\":\"%s\",\"xMm\":%.3f,\"yMm\":%.3f,\"headingRad\":%.5f,\"errorMm\":%.2f,"
            + "\"atNs\":%d}",
        body.name(),
        body.pose().xMm(),
        body.pose().yMm(),
        body.pose().headingRad(),
        body.meanErrorMm() + LEAST_ERROR_MM,
        atNs + RealClock.DATE_ORIGIN_UNIX_NS);
  }
}
