package org.starl.robot.optitrack;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketException;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.robot.realtime.RealClock;

/**
 * Poses from any measuring system that can send UDP: each datagram is one JSON line for one robot.
 *
 * <pre>{"robot":"bot0","xMm":1200,"yMm":-350.5,"headingRad":1.57,"errorMm":4,"atNs":81234000}</pre>
 *
 * <p>{@code atNs} is the time of measurement on a clock of the sender that never jumps back; its
 * origin is arbitrary. {@code "errorRad"} is optional. Other keys are refused.
 *
 * <p>With a key each line is followed by a space and the hexadecimal HMAC-SHA256 of the line. Then {@code
 * atNs} counts from 1970: each robot's first line must be within {@link JsonProtocol#MOST_DATE_ERROR_NS}
 * of the feed's date, and each other one later than the one before it. So a recording of another run
 * does not count, and none of this run a second time.
 */
public final class JsonFeed extends PoseFeed {

  private static final int WAIT_MS = 500;

  private final @Nullable InetAddress sender;
  private final DatagramSocket socket;
  private final JsonProtocol protocol;

  private JsonFeed(JsonFeedSettings settings, Clock clock, LogSink log, DatagramSocket socket) {
    super(clock, log, "json feed");
    this.sender = settings.sender();
    this.socket = socket;
    this.protocol = new JsonProtocol(settings.bounds(), settings.key(), tally);
  }

  /**
   * Opens a feed, which listens until {@link #close}.
   *
   * @param clock the robot's, for the fixes' times; read by another thread. With a key it is
   *     one of {@link RealClock#ofDate}
   * @param log takes a line from the feed's thread for the first error of each kind
   * @throws IOException if the address is not available
   */
  public static JsonFeed open(JsonFeedSettings settings, Clock clock, LogSink log)
      throws IOException {
    try {
      JsonFeed feed = new JsonFeed(settings, clock, log, new DatagramSocket(settings.address()));
      feed.receive("json feed", feed.socket, WAIT_MS);
      return feed;
    } catch (SocketException e) {
      throw new IOException("JSON feed at " + settings.address() + ": " + e.getMessage(), e);
    }
  }

  /** The address at which it listens. */
  public InetSocketAddress address() {
    return new InetSocketAddress(socket.getLocalAddress(), socket.getLocalPort());
  }

  @Override
  String silence(long nowNs) {
    return tally.statistics().received() == 0
        ? "no line has come to "
            + text(address())
            + "; look at the sender's address and port, and at this machine's firewall"
        : super.silence(nowNs) + "; look at the names in the lines";
  }

  @Override
  List<TrackedBody> read(@Nullable DatagramPacket packet, long nowNs) {
    if (packet == null) {
      return List.of();
    }
    if (sender != null && !packet.getAddress().equals(sender)) {
      tally.drop(FeedDrop.FOREIGN, "a datagram from " + packet.getAddress(), nowNs);
      return List.of();
    }
    TrackedBody body = protocol.received(packet.getData(), packet.getLength(), nowNs);
    return body == null ? List.of() : List.of(body);
  }
}
