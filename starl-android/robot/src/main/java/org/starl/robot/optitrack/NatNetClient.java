package org.starl.robot.optitrack;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.MulticastSocket;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.platform.Positioning;
import org.starl.platform.Strand;

/**
 * A client of one OptiTrack server (Motive, or {@link NatNetServer}), NatNet 3.0 to 4.2 and, as far
 * as sections have sizes, later. It connects automatically, and again after each silence.
 *
 * <pre>{@code
 * NatNetClient client = NatNetClient.open(NatNetSettings.unicast(server), clock, log);
 * Positioning positioning = client.positioning(strand, "bot0");
 * }</pre>
 */
public final class NatNetClient implements PoseFeed {

  private static final int TICK_MS = 20;

  private final NatNetSettings settings;
  private final Clock clock;
  private final DatagramSocket command;
  private final @Nullable MulticastSocket data;
  private final List<Reception> receptions = new ArrayList<>();
  private final Followers followers = new Followers();
  private final ReentrantLock lock = new ReentrantLock();

  // Guarded by the lock.
  private final Tally tally;
  private final NatNetProtocol protocol;
  private List<TrackedBody> fresh = List.of();

  private NatNetClient(
      NatNetSettings settings,
      Clock clock,
      LogSink log,
      DatagramSocket command,
      @Nullable MulticastSocket data) {
    this.settings = settings;
    this.clock = clock;
    this.command = command;
    this.data = data;
    this.tally = new Tally(log, "natnet");
    this.protocol = new NatNetProtocol(settings, tally, this::send, bodies -> fresh = bodies);
  }

  /**
   * Begins to connect, in the background.
   *
   * @param clock the robot's, for the fixes' times; read by other threads
   * @param log takes a line from the client's threads for the first error of each kind
   * @throws IOException if no socket is available, or the group cannot be joined
   */
  public static NatNetClient open(NatNetSettings settings, Clock clock, LogSink log)
      throws IOException {
    InetAddress local = settings.local();
    DatagramSocket command =
        new DatagramSocket(
            local == null ? new InetSocketAddress(0) : new InetSocketAddress(local, 0));
    MulticastSocket data = null;
    try {
      InetSocketAddress group = settings.group();
      data = group == null ? null : join(group, local);
    } catch (IOException e) {
      command.close();
      throw new IOException(
          "NatNet group " + settings.group() + " at " + local + ": " + e.getMessage(), e);
    }
    NatNetClient client = new NatNetClient(settings, clock, log, command, data);
    client.receive("natnet command", command);
    if (data != null) {
      client.receive("natnet data", data);
    }
    return client;
  }

  @Override
  public Positioning positioning(Strand strand, String name) {
    lock.lock();
    try {
      protocol.want(name, clock.nowNs());
    } finally {
      lock.unlock();
    }
    return followers.follow(strand, name, body -> body.name().equals(name));
  }

  /** The fixes of the rigid body whose streaming number is {@code id}. */
  public Positioning positioning(Strand strand, int id) {
    return followers.follow(strand, "rigid body " + id, body -> body.id() == id);
  }

  @Override
  public void onBodies(Consumer<List<TrackedBody>> watcher) {
    followers.watch(watcher);
  }

  /** Whether a server has answered and has not been silent since. */
  public boolean isConnected() {
    lock.lock();
    try {
      return protocol.isConnected();
    } finally {
      lock.unlock();
    }
  }

  /** The names of the server's rigid bodies; empty before the server has sent them. */
  public List<String> bodyNames() {
    lock.lock();
    try {
      return protocol.models().names();
    } finally {
      lock.unlock();
    }
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
    if (!command.isClosed()) {
      send(new LittleEndianWriter().begin(Message.DISCONNECT).end());
    }
    receptions.forEach(Reception::close);
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

  private void receive(String name, DatagramSocket socket) {
    receptions.add(Reception.start(name, socket, TICK_MS, this::take, this::fail));
  }

  private void take(@Nullable DatagramPacket packet) {
    followers.publish(step(packet, clock.nowNs()));
  }

  /** The bodies of the frame, if it was one: to be published without the lock. */
  private List<TrackedBody> step(@Nullable DatagramPacket packet, long nowNs) {
    lock.lock();
    try {
      fresh = List.of();
      if (packet != null) {
        judge(packet, nowNs);
      }
      protocol.tick(nowNs);
      return fresh;
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
    closeSockets();
  }

  // The data of a group may come from any port of the server.
  private void judge(DatagramPacket packet, long nowNs) {
    tally.received();
    if (packet.getAddress().equals(settings.server().getAddress())) {
      protocol.received(packet.getData(), packet.getLength(), nowNs);
    } else {
      tally.drop(FeedDrop.FOREIGN, "a datagram from " + packet.getAddress(), nowNs);
    }
  }

  // A datagram that the network refuses is lost; important ones are sent again.
  private void send(byte[] datagram) {
    try {
      command.send(new DatagramPacket(datagram, datagram.length, settings.server()));
    } catch (IOException e) {
      lock.lock();
      try {
        tally.warnOnce("unsent", settings.server() + " cannot be reached: " + e, clock.nowNs());
      } finally {
        lock.unlock();
      }
    }
  }

  private void closeSockets() {
    command.close();
    if (data != null) {
      data.close();
    }
  }
}
