package org.starl.robot.optitrack;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.MulticastSocket;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.platform.Positioning;
import org.starl.platform.Strand;

/**
 * A client of one OptiTrack server (Motive, or {@link NatNetServer}) over NatNet 3.0 to 4.2; of later
 * versions it reads the sections whose sizes are given. It connects automatically, and again after
 * each silence.
 *
 * <pre>{@code
 * NatNetClient client = NatNetClient.open(NatNetSettings.unicast(server), clock, log);
 * Positioning positioning = client.positioning(strand, "bot0");
 * }</pre>
 */
public final class NatNetClient extends PoseFeed {

  private static final int TICK_MS = 20;

  private final NatNetSettings settings;
  private final DatagramSocket command;

  // Guarded by the feed's lock.
  private final NatNetProtocol protocol;
  private List<TrackedBody> newBodies = List.of();

  private NatNetClient(NatNetSettings settings, Clock clock, LogSink log, DatagramSocket command) {
    super(clock, log, "natnet");
    this.settings = settings;
    this.command = command;
    this.protocol = new NatNetProtocol(settings, tally, this::send, bodies -> newBodies = bodies);
  }

  /**
   * Opens a client, which connects in the background.
   *
   * @param clock the robot's, for the fixes' times; read by other threads
   * @param log takes a line from the client's threads for the first error of each kind
   * @throws IOException if no socket is available, or the group cannot be joined
   */
  public static NatNetClient open(NatNetSettings settings, Clock clock, LogSink log)
      throws IOException {
    InetAddress given = settings.local();
    InetAddress local =
        given == null && settings.group() != null ? towards(settings.server(), null) : given;
    InetSocketAddress group = settings.group();
    DatagramSocket command =
        new DatagramSocket(
            local == null ? new InetSocketAddress(0) : new InetSocketAddress(local, 0));
    NatNetClient client = new NatNetClient(settings, clock, log, command);
    try {
      if (group != null) {
        client.receive("natnet data", join(group, local), TICK_MS);
      }
    } catch (IOException e) {
      command.close();
      throw new IOException("NatNet group " + group + " at " + local + ": " + e.getMessage(), e);
    }
    client.receive("natnet command", command, TICK_MS);
    return client;
  }

  @Override
  public Positioning positioning(Strand strand, String name) {
    synchronized (this) {
      protocol.want(name, clock.nowNs());
    }
    return super.positioning(strand, name);
  }

  /** The fixes of the rigid body whose streaming number is {@code id}. */
  public Positioning positioning(Strand strand, int id) {
    return follow(strand, "rigid body " + id, body -> body.id() == id);
  }

  /** Whether a server has answered and has not been silent since. */
  public synchronized boolean isConnected() {
    return protocol.isConnected();
  }

  @Override
  public void close() {
    if (!command.isClosed()) {
      send(new LittleEndianWriter().begin(Message.DISCONNECT).end());
    }
    super.close();
  }

  @Override
  String silence(long nowNs) {
    if (!protocol.isConnected()) {
      return text(settings.server())
          + " does not answer; look at this address, at 'Local Interface' in Motive's streaming"
          + " settings, at the firewall there (UDP), and at positions.interface"
          + (settings.local() == null ? "" : ", here " + settings.local().getHostAddress());
    }
    if (protocol.hasFrames(nowNs)) {
      return "frames come, but without its place; look at the rigid bodies in Motive; " + dropped();
    }
    return text(settings.server())
        + " answers, but no usable frames come "
        + (settings.group() == null
            ? "to this machine; look at 'Transmission Type' in Motive's streaming settings (unicast)"
            : "to the group "
                + text(settings.group())
                + (settings.local() == null ? "" : " at " + settings.local().getHostAddress())
                + "; look at 'Transmission Type' in Motive's streaming settings (multicast), and at"
                + " positions.interface, the network of the cameras")
        + ", and at the firewall; "
        + dropped();
  }

  /**
   * The address of this machine's interface that reaches {@code server}.
   *
   * @param own this robot's address, which is preferred if that interface has it; null for none
   */
  public static InetAddress towards(InetSocketAddress server, @Nullable InetAddress own)
      throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.connect(server);
      InetAddress reaching = socket.getLocalAddress();
      NetworkInterface at = NetworkInterface.getByInetAddress(reaching);
      boolean isOwn =
          own != null && at != null && at.equals(NetworkInterface.getByInetAddress(own));
      return isOwn && own != null ? own : reaching;
    } catch (UncheckedIOException e) {
      throw new IOException(server + ": no network reaches it: " + e.getMessage(), e);
    }
  }

  private static MulticastSocket join(InetSocketAddress group, @Nullable InetAddress local)
      throws IOException {
    MulticastSocket socket = new MulticastSocket(null);
    try {
      socket.setReuseAddress(true);
      socket.bind(new InetSocketAddress(group.getPort()));
      NetworkInterface at = local == null ? null : NetworkInterface.getByInetAddress(local);
      if (local != null && at == null) {
        throw new SocketException("no interface has this address");
      }
      socket.joinGroup(group, at);
      return socket;
    } catch (IOException e) {
      socket.close();
      throw e;
    }
  }

  @Override
  List<TrackedBody> read(@Nullable DatagramPacket packet, long nowNs) {
    newBodies = List.of();
    if (packet != null) {
      // The data of a group may come from any port of the server.
      if (packet.getAddress().equals(settings.server().getAddress())) {
        protocol.received(packet.getData(), packet.getLength(), nowNs);
      } else {
        tally.drop(FeedDrop.FOREIGN, "a datagram from " + packet.getAddress(), nowNs);
      }
    }
    protocol.tick(nowNs);
    return newBodies;
  }

  // A datagram that the network refuses is lost; important ones are sent again.
  private void send(byte[] datagram) {
    try {
      command.send(new DatagramPacket(datagram, datagram.length, settings.server()));
    } catch (IOException e) {
      synchronized (this) {
        tally.warnOnce("unsent", settings.server() + " cannot be reached: " + e, clock.nowNs());
      }
    }
  }
}
