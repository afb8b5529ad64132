package org.starl.robot.optitrack;

import static org.starl.time.Time.NS_PER_MS;
import static org.starl.time.Time.NS_PER_S;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.MulticastSocket;
import java.net.NetworkInterface;
import java.net.SocketAddress;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.starl.platform.Clock;
import org.starl.robot.realtime.Daemons;

/**
 * Streams poses like an OptiTrack server, to any NatNet client: in place of cameras, for simulated
 * bodies and for tests. It has one thread. It accepts the connect messages of all versions, short and
 * long, and answers unknown requests with "unrecognized".
 */
public final class NatNetServer implements AutoCloseable {

  private static final String NAME = "StarL";

  private static final long ANNOUNCE_MODELS_NS = NS_PER_S;

  private final NatNetServerSettings settings;
  private final PoseSource source;
  private final Clock clock;
  private final Consumer<Exception> onFailure;
  private final MulticastSocket socket;
  private final Thread thread;
  private final AtomicLong ignored = new AtomicLong();

  // Set after the thread has started.
  private volatile Consumer<String> log = line -> {};
  private volatile Set<InetAddress> reserved = Set.of();

  // The server's thread only.
  private final StreamEncoder encoder;
  private final LittleEndianWriter out = new LittleEndianWriter();
  private final StreamClients clients = new StreamClients();
  private boolean hasRefused;
  private PoseSource.Snapshot snapshot;
  private int frames;
  private long announceUntilNs;

  private NatNetServer(
      NatNetServerSettings settings,
      PoseSource source,
      Clock clock,
      Consumer<Exception> onFailure,
      MulticastSocket socket) {
    this.settings = settings;
    this.source = source;
    this.clock = clock;
    this.onFailure = onFailure;
    this.socket = socket;
    this.encoder = new StreamEncoder(settings.version(), settings.axes());
    this.snapshot = source.snapshot();
    this.thread = Daemons.of("natnet server", this::run);
  }

  /**
   * Serves from now on.
   *
   * @param clock of the snapshots' times; its nanoseconds are the stream's ticks
   * @param onFailure is called, on the server's thread, if it cannot continue
   * @throws IOException if the address is not available
   */
  public static NatNetServer open(
      NatNetServerSettings settings, PoseSource source, Clock clock, Consumer<Exception> onFailure)
      throws IOException {
    NatNetServer server = bind(settings, source, clock, onFailure);
    server.thread.start();
    return server;
  }

  /** A server without its thread. */
  static NatNetServer bind(
      NatNetServerSettings settings, PoseSource source, Clock clock, Consumer<Exception> onFailure)
      throws IOException {
    MulticastSocket socket = new MulticastSocket(null);
    try {
      // By default a multicast socket shares its port with other programs.
      socket.setReuseAddress(false);
      socket.bind(settings.address());
      InetAddress local = settings.address().getAddress();
      if (settings.group() != null && !local.isAnyLocalAddress()) {
        socket.setNetworkInterface(NetworkInterface.getByInetAddress(local));
      }
    } catch (IOException e) {
      socket.close();
      throw new IOException("NatNet server at " + settings.address() + ": " + e.getMessage(), e);
    }
    return new NatNetServer(settings, source, clock, onFailure, socket);
  }

  /** The address at which it listens for commands. */
  public InetSocketAddress address() {
    return new InetSocketAddress(socket.getLocalAddress(), socket.getLocalPort());
  }

  /** Number of datagrams that were refused, were not a client's message, or could not be sent. */
  public long ignored() {
    return ignored.get();
  }

  /** Sets the receiver of one log line, on the server's thread: the first refused request. */
  public void onRefusal(Consumer<String> newLog) {
    log = newLog;
  }

  /**
   * Reserves places for clients at these hosts, whose number is thereby bounded only by 32 for each of
   * them: a flood from other addresses does not keep them out.
   */
  public void reserve(Set<InetAddress> hosts) {
    reserved = Set.copyOf(hosts);
  }

  /** Number of clients. On the server's thread. */
  int clients() {
    return clients.all().size();
  }

  /** Stops serving. */
  @Override
  public void close() {
    socket.close();
    Daemons.join(thread, 0);
  }

  private void run() {
    DatagramReceiver receiver = new DatagramReceiver(socket);
    long periodNs = NS_PER_S / settings.framesPerS();
    long nextNs = clock.nowNs();
    while (!socket.isClosed()) {
      try {
        long nowNs = clock.nowNs();
        if (nowNs >= nextNs) {
          nextNs = Math.max(nextNs + periodNs, nowNs);
          stream(nowNs);
        } else {
          DatagramPacket packet = receiver.receive((int) ((nextNs - nowNs) / NS_PER_MS) + 1);
          if (packet != null) {
            answer(packet, clock.nowNs());
          }
        }
      } catch (IOException | RuntimeException e) {
        if (!socket.isClosed()) {
          socket.close();
          onFailure.accept(e);
        }
      }
    }
  }

  private void stream(long nowNs) {
    snapshot = source.snapshot();
    if (encoder.addNew(snapshot)) {
      announceUntilNs = nowNs + ANNOUNCE_MODELS_NS;
    }
    clients.removeSilent(nowNs);
    frames++;
    if (settings.group() == null && clients.all().isEmpty()) {
      return;
    }
    byte[] frame = encoder.frame(frames, snapshot, nowNs < announceUntilNs, clock.nowNs());
    if (settings.group() != null) {
      send(frame, settings.group());
    } else {
      for (SocketAddress client : clients.all()) {
        send(frame, client);
      }
    }
  }

  /** On the server's thread. */
  void answer(DatagramPacket packet, long nowNs) {
    byte[] bytes = packet.getData();
    InetSocketAddress client = (InetSocketAddress) packet.getSocketAddress();
    long clientNs;
    int id = Message.id(bytes, packet.getLength());
    try {
      LittleEndianReader in = Message.payload(bytes, packet.getLength());
      clientNs = id == Message.ECHO_REQUEST ? in.i64() : 0;
    } catch (BufferUnderflowException e) {
      ignored.incrementAndGet();
      return;
    }
    clients.reserve(reserved);
    if (!clients.heard(client, nowNs)) {
      refuse(client, "more than " + StreamClients.STRANGERS_PER_S + " strangers' requests in 1 s");
      return;
    }
    switch (id) {
      case Message.CONNECT -> connect(client, nowNs);
      case Message.DISCOVERY -> send(info(), client);
      case Message.KEEP_ALIVE -> {
        // Known clients are marked as heard above.
      }
      case Message.DISCONNECT -> {
        if (!clients.leave(client, nowNs)) {
          ignored.incrementAndGet();
        }
      }
      case Message.REQUEST_MODELS -> {
        encoder.addNew(snapshot);
        send(encoder.models(snapshot.bodies()), client);
      }
      case Message.ECHO_REQUEST ->
          send(out.begin(Message.ECHO_RESPONSE).i64(clientNs).i64(nowNs).end(), client);
      case Message.REQUEST -> send(out.begin(Message.UNRECOGNIZED).end(), client);
      default -> ignored.incrementAndGet();
    }
  }

  private void connect(InetSocketAddress client, long nowNs) {
    if (clients.add(client, nowNs)) {
      send(info(), client);
    } else {
      refuse(
          client,
          String.format(
              "there are %s clients, or %s of its host",
              StreamClients.MAX, StreamClients.MAX_PER_HOST));
    }
  }

  private void refuse(SocketAddress client, String why) {
    ignored.incrementAndGet();
    if (!hasRefused) {
      hasRefused = true;
      log.accept("NatNet: a request of " + client + " is refused: " + why + "; further ones, too");
    }
  }

  private byte[] info() {
    InetSocketAddress group = settings.group();
    return new ServerInfo(
            NAME,
            settings.version(),
            NS_PER_S,
            group != null,
            group == null ? NatNetSettings.DATA_PORT : group.getPort(),
            group == null ? 0 : ByteBuffer.wrap(group.getAddress().getAddress()).getInt())
        .datagram(out);
  }

  // A client that cannot be reached loses the datagram; after a silence it is removed.
  private void send(byte[] datagram, SocketAddress to) {
    try {
      socket.send(new DatagramPacket(datagram, datagram.length, to));
    } catch (IOException e) {
      ignored.incrementAndGet();
    }
  }
}
