// Longer than 500 lines because each attack of attack.sh is one method here, over one network.
package org.starl.launch;

import static org.starl.time.Time.NS_PER_MS;
import static org.starl.time.Time.NS_PER_S;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicLongArray;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Pose;
import org.starl.input.BadInput;
import org.starl.random.Rng;
import org.starl.robot.optitrack.Axes;
import org.starl.robot.optitrack.FixBounds;
import org.starl.robot.optitrack.NatNetClient;
import org.starl.robot.optitrack.NatNetServer;
import org.starl.robot.optitrack.NatNetServerSettings;
import org.starl.robot.optitrack.NatNetSettings;
import org.starl.robot.optitrack.NatNetVersion;
import org.starl.robot.optitrack.PoseSource;
import org.starl.robot.realtime.Daemons;
import org.starl.robot.realtime.RealClock;

/**
 * An attacker without the key, who owns the network of four robots: every datagram between them, and
 * between them and the cameras, passes it. It reads, keeps, holds back and makes up datagrams, from any
 * address. Robots run on the loopback interface; the deployment file of each names a port of the
 * attacker as the address of each other robot and of the cameras. {@code
 * scenarios/deployment/attack.sh} writes those files.
 *
 * <p>From {@code base} on: + 5 world, + 6 cameras, + 8 robots, + 12 a second machine as bot0 (number 4),
 * + 20 the cameras for each of those five, + 60 + 10 a + b robot b for machine a.
 */
final class Attacker implements AutoCloseable {

  private static final int ROBOTS = 4;

  /** The second machine that runs bot0. */
  private static final int SECOND = 4;

  private static final int MACHINES = ROBOTS + 1;

  private static final int MAX_RECORDED = 100_000;
  private static final int MAX_DATAGRAM = 65_507;
  private static final int FAKE_CLIENTS = 500;
  private static final double FALSE_X_MM = 7777;
  private static final byte FRAME = 7;
  private static final byte[] REQUEST_MODELS = {4, 0, 0, 0};

  /** Where a server's description has its clock's ticks in a second. */
  private static final int TICKS_AT = 268;

  private static final byte[] CONNECT = {0, 0, 5, 0, 'P', 'i', 'n', 'g', 0};

  /** A datagram on its way from one robot to another. */
  private static final class Recorded {
    private final int from;
    private final int to;
    private final byte[] bytes;

    Recorded(int from, int to, byte[] bytes) {
      this.from = from;
      this.to = to;
      this.bytes = bytes;
    }

    boolean isBeacon() {
      return bytes.length > 1 && bytes[0] == 'S' && bytes[1] == 'B';
    }
  }

  private final int base;
  private final PrintWriter out;
  private final Rng rng = new Rng(1);
  private final Selector selector = Selector.open();
  private final DatagramChannel[][] pairs = new DatagramChannel[MACHINES][ROBOTS];
  private final DatagramChannel[] toClient = new DatagramChannel[MACHINES];
  private final DatagramChannel[] toCameras = new DatagramChannel[MACHINES];
  private final List<Socket> connections = new ArrayList<>();
  private final AtomicLongArray frames = new AtomicLongArray(MACHINES);
  private final AtomicLong passed = new AtomicLong();

  // Written by the network's thread, read by that of the commands.
  private final SocketAddress[] clients = new SocketAddress[MACHINES];

  // Guarded by this.
  private final Deque<Recorded> recorded = new ArrayDeque<>();
  private List<Recorded> former = List.of();
  private boolean isBlocked;

  /**
   * Opens all ports.
   *
   * @param base the first port
   * @param out takes a line for each command
   */
  private Attacker(int base, PrintWriter out) throws IOException {
    this.base = base;
    this.out = out;
    for (int a = 0; a < MACHINES; a++) {
      for (int b = 0; b < ROBOTS; b++) {
        if (identity(a) != b) {
          pairs[a][b] = open(local(base + 60 + 10 * a + b));
        }
      }
      toClient[a] = open(local(base + 20 + a));
      toCameras[a] = open(local(0));
    }
  }

  private static int identity(int machine) {
    return machine == SECOND ? 0 : machine;
  }

  private static InetSocketAddress local(int port) {
    return new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
  }

  private InetSocketAddress robot(int machine) {
    return local(base + 8 + machine);
  }

  private DatagramChannel open(InetSocketAddress at) throws IOException {
    DatagramChannel channel = DatagramChannel.open().bind(at);
    channel.configureBlocking(false).register(selector, SelectionKey.OP_READ);
    return channel;
  }

  /** Obeys the standard input; the argument is the first port. */
  public static void main(String[] args) throws IOException {
    PrintWriter out = new PrintWriter(System.out, true, StandardCharsets.UTF_8);
    var commands = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    try (Attacker attacker = new Attacker(Integer.parseInt(args[0]), out)) {
      attacker.run(commands);
    }
  }

  /**
   * Passes datagrams on, and obeys commands, a line each, until there are no more.
   *
   * @throws BadInput if a command is unknown
   */
  private void run(BufferedReader commands) throws IOException {
    Daemons.of("network", this::passAll).start();
    out.println("attacker: ready");
    for (String line = commands.readLine(); line != null; line = commands.readLine()) {
      out.println(line + ": " + obey(line.split(" ", -1)));
    }
  }

  private String obey(String... words) throws IOException {
    int count = words.length > 1 ? Integer.parseInt(words[1]) : 0;
    return switch (words[0]) {
      case "block" -> block(true);
      case "pass" -> block(false);
      case "forget" -> forget();
      case "replay" -> replay(count);
      case "garbage" -> garbage(count);
      case "beacons" -> beacons(count);
      case "clients" -> connectAsManyClients(count);
      case "tcp" -> connect(count);
      case "hangup" -> hangUp();
      case "pose" -> forgePoses(count, 300);
      case "poses" -> forgePoses(count, 5);
      case "scaled" -> scalePoses(count);
      case "models" -> forgeAnswer(count, "4.1", REQUEST_MODELS, 0);
      case "info" -> forgeAnswer(count, "3.1", CONNECT, 0);
      case "ticks" -> forgeAnswer(count, "4.1", CONNECT, 2);
      default -> throw new BadInput("attack: " + BadInput.quote(words[0]) + ": no such command");
    };
  }

  @Override
  public void close() throws IOException {
    hangUp();
    for (SelectionKey key : selector.keys()) {
      key.channel().close();
    }
    selector.close();
  }

  private void passAll() {
    ByteBuffer buffer = ByteBuffer.allocate(MAX_DATAGRAM);
    try {
      while (selector.isOpen()) {
        selector.select(100);
        for (SelectionKey key : selector.selectedKeys()) {
          pass((DatagramChannel) key.channel(), buffer.clear());
        }
        selector.selectedKeys().clear();
      }
    } catch (ClosedSelectorException e) {
      return; // the attacker ends
    } catch (IOException e) {
      out.println("attacker: the network has failed: " + e);
    }
  }

  private void pass(DatagramChannel channel, ByteBuffer buffer) throws IOException {
    SocketAddress source = channel.receive(buffer);
    if (source == null) {
      return;
    }
    buffer.flip();
    for (int a = 0; a < MACHINES; a++) {
      if (channel == toClient[a]) {
        clients[a] = source;
        send(toCameras[a], buffer, local(base + 6));
      } else if (channel == toCameras[a] && clients[a] != null) {
        frames.addAndGet(a, buffer.remaining() > 100 ? 1 : 0);
        send(toClient[a], buffer, clients[a]);
      }
      for (int b = 0; b < ROBOTS; b++) {
        if (channel == pairs[a][b]) {
          byte[] bytes = new byte[buffer.remaining()];
          buffer.get(bytes);
          pass(new Recorded(identity(a), b, bytes), a);
        }
      }
    }
  }

  private void pass(Recorded datagram, int machine) {
    synchronized (this) {
      if (recorded.size() == MAX_RECORDED) {
        recorded.removeFirst();
      }
      recorded.addLast(datagram);
      if (isBlocked) {
        return;
      }
    }
    passed.incrementAndGet();
    deliver(datagram);
    // Beacons are for all on a network, so also for another machine of the same name.
    if (datagram.isBeacon() && datagram.from == 0) {
      boolean isSecond = machine == SECOND;
      DatagramChannel from = isSecond ? pairs[0][1] : pairs[SECOND][1];
      send(from, ByteBuffer.wrap(datagram.bytes), robot(isSecond ? 0 : SECOND));
    }
  }

  /** Sends it from the address that its receiver knows for its sender. */
  private void deliver(Recorded datagram) {
    int from = datagram.from;
    int to = datagram.to;
    send(pairs[to][from], ByteBuffer.wrap(datagram.bytes), robot(to));
    if (to == 0) {
      send(pairs[SECOND][from], ByteBuffer.wrap(datagram.bytes), robot(SECOND));
    }
  }

  private static void send(DatagramChannel from, ByteBuffer bytes, SocketAddress to) {
    try {
      from.send(bytes, to);
    } catch (IOException e) {
      // A network may lose it; a receiver that is not there refuses it.
      bytes.position(bytes.limit());
    }
  }

  private synchronized String block(boolean blocks) {
    isBlocked = blocks;
    return passed.get() + " datagrams passed so far";
  }

  /** What was heard until now is of a former run. */
  private synchronized String forget() {
    former = new ArrayList<>(recorded);
    recorded.clear();
    return former.size() + " datagrams recorded";
  }

  private String replay(int ms) {
    long sent = 0;
    long beacons = 0;
    long endNs = RealClock.machineNs() + ms * NS_PER_MS;
    while (RealClock.machineNs() < endNs && !former.isEmpty()) {
      for (Recorded datagram : former) {
        deliver(datagram);
        beacons += datagram.isBeacon() ? 1 : 0;
        sent++;
        pause(sent % 20 == 0 ? 5 : 0);
        if (RealClock.machineNs() >= endNs) {
          break;
        }
      }
    }
    return sent + " datagrams sent, " + beacons + " of them beacons";
  }

  private String garbage(int ms) {
    long sent = 0;
    long endNs = RealClock.machineNs() + ms * NS_PER_MS;
    List<Recorded> heard;
    synchronized (this) {
      heard = new ArrayList<>(recorded);
    }
    while (RealClock.machineNs() < endNs) {
      int to = rng.nextInt(ROBOTS);
      int from = (to + 1 + rng.nextInt(ROBOTS - 1)) % ROBOTS;
      boolean isStranger = rng.nextBoolean(0.2);
      send(
          isStranger ? toCameras[0] : pairs[to][from],
          ByteBuffer.wrap(heard.isEmpty() ? noise(100) : hostile(heard)),
          robot(to));
      sent++;
      pause(sent % 40 == 0 ? 5 : 0);
    }
    return sent + " datagrams sent";
  }

  private byte[] hostile(List<Recorded> heard) {
    byte[] bytes = heard.get(rng.nextInt(heard.size())).bytes.clone();
    return switch (rng.nextInt(4)) {
      case 0 -> noise(rng.nextInt(1400));
      case 1 -> noise(1400 + rng.nextInt(60_000));
      case 2 -> changed(bytes);
      default -> Arrays.copyOf(bytes, rng.nextInt(bytes.length));
    };
  }

  private byte[] noise(int length) {
    byte[] bytes = new byte[length];
    for (int i = 0; i < length; i++) {
      bytes[i] = (byte) rng.nextInt(256);
    }
    return bytes;
  }

  private byte[] changed(byte[] bytes) {
    bytes[rng.nextInt(bytes.length)] ^= (byte) (1 + rng.nextInt(255));
    return bytes;
  }

  /** Beacons of this run, changed, and of the former one, unchanged, each from its sender's address. */
  private String beacons(int ms) {
    List<Recorded> all = new ArrayList<>(former);
    synchronized (this) {
      all.addAll(recorded);
    }
    all.removeIf(each -> !each.isBeacon());
    List<Recorded> forged = new ArrayList<>();
    for (Recorded each : all) {
      forged.add(new Recorded(each.from, each.to, changed(each.bytes.clone())));
    }
    all.addAll(forged);
    long sent = 0;
    long endNs = RealClock.machineNs() + ms * NS_PER_MS;
    while (RealClock.machineNs() < endNs && !all.isEmpty()) {
      deliver(all.get(rng.nextInt(all.size())));
      sent++;
      pause(sent % 20 == 0 ? 5 : 0);
    }
    return sent + " beacons sent";
  }

  /** 3,000 connect messages of NatNet a second, from many addresses. */
  private String connectAsManyClients(int ms) throws IOException {
    List<DatagramChannel> fakes = new ArrayList<>();
    for (int i = 0; i < FAKE_CLIENTS; i++) {
      InetAddress host =
          InetAddress.getByAddress(new byte[] {127, 1, (byte) (i / 200), (byte) (1 + i % 200)});
      fakes.add(DatagramChannel.open().bind(new InetSocketAddress(host, 0)));
    }
    long beganNs = RealClock.machineNs();
    long endNs = beganNs + ms * NS_PER_MS;
    long lastSecondNs = endNs - NS_PER_S;
    long[] before = null;
    long sent = 0;
    while (RealClock.machineNs() < endNs) {
      for (int i = 0; i < 15; i++) {
        send(fakes.get((int) (sent++ % FAKE_CLIENTS)), ByteBuffer.wrap(CONNECT), local(base + 6));
      }
      pause(5);
      if (before == null && RealClock.machineNs() >= lastSecondNs) {
        before = frameCounts();
      }
    }
    long[] after = frameCounts();
    int served = 0;
    for (DatagramChannel fake : fakes) {
      fake.configureBlocking(false);
      served += hasFrame(fake) ? 1 : 0;
      fake.close();
    }
    return sent
        + " requests sent, "
        + served
        + " of "
        + FAKE_CLIENTS
        + " get frames, frames a second at least "
        + least(before, after);
  }

  private static boolean hasFrame(DatagramChannel client) throws IOException {
    ByteBuffer datagram = ByteBuffer.allocate(MAX_DATAGRAM);
    while (client.receive(datagram.clear()) != null) {
      if (datagram.get(0) == FRAME) {
        return true;
      }
    }
    return false;
  }

  private long[] frameCounts() {
    long[] counts = new long[ROBOTS];
    for (int i = 0; i < ROBOTS; i++) {
      counts[i] = frames.get(i);
    }
    return counts;
  }

  private static long least(long @Nullable [] before, long[] after) {
    long least = Long.MAX_VALUE;
    for (int i = 0; i < ROBOTS; i++) {
      least = Math.min(least, after[i] - (before == null ? 0 : before[i]));
    }
    return least;
  }

  private String connect(int count) {
    int failed = 0;
    for (int i = 0; i < count; i++) {
      Socket socket = new Socket();
      try {
        socket.connect(local(base + 5), 1000);
        connections.add(socket);
      } catch (IOException e) {
        failed++;
      }
    }
    return connections.size() + " connections, " + failed + " failed";
  }

  private String hangUp() throws IOException {
    for (Socket socket : connections) {
      socket.close();
    }
    connections.clear();
    return "closed";
  }

  /** Frames in the cameras' name, with all robots far away, one each {@code periodMs}. */
  private String forgePoses(int ms, int periodMs) throws IOException {
    List<PoseSource.Body> bodies = new ArrayList<>();
    for (int i = 0; i < ROBOTS; i++) {
      bodies.add(new PoseSource.Body("bot" + i, new Pose(FALSE_X_MM, 1000.0 * i, 0), true, 0.1));
    }
    return forgeFrames(ms, periodMs, () -> bodies);
  }

  /** The cameras' frames at three times their rate, with the positions scaled by half. */
  private String scalePoses(int ms) throws IOException {
    NatNetSettings settings =
        new NatNetSettings(local(base + 6), null, null, Axes.DEFAULT, FixBounds.DEFAULT);
    try (NatNetClient spy =
        NatNetClient.open(settings, RealClock.ofDate(), (timeNs, level, tag, line) -> {})) {
      return forgeFrames(
          ms,
          3,
          () ->
              spy.newest().entrySet().stream()
                  .map(each -> scaled(each.getKey(), each.getValue().pose()))
                  .toList());
    }
  }

  private static PoseSource.Body scaled(String name, Pose pose) {
    Pose half = new Pose(pose.xMm() / 2, pose.yMm() / 2, pose.headingRad());
    return new PoseSource.Body(name, half, true, 0.1);
  }

  private NatNetServer imitate(String version, Supplier<List<PoseSource.Body>> bodies)
      throws IOException {
    RealClock now = RealClock.ofDate();
    String[] numbers = version.split("\\.", -1);
    // The dates of two processes may differ by some microseconds, and no frame is of the future.
    return NatNetServer.open(
        new NatNetServerSettings(
            local(0),
            null,
            new NatNetVersion(Integer.parseInt(numbers[0]), Integer.parseInt(numbers[1])),
            Axes.DEFAULT,
            300),
        () -> new PoseSource.Snapshot(now.nowNs() - 2 * NS_PER_MS, bodies.get()),
        () -> now.nowNs() - NS_PER_MS,
        failure -> out.println("attacker: " + failure));
  }

  private String forgeFrames(int ms, int periodMs, Supplier<List<PoseSource.Body>> bodies)
      throws IOException {
    long sent = 0;
    try (NatNetServer server = imitate("4.1", bodies);
        DatagramChannel client = DatagramChannel.open().bind(local(0))) {
      client.send(ByteBuffer.wrap(CONNECT), server.address());
      ByteBuffer frame = ByteBuffer.allocate(MAX_DATAGRAM);
      long endNs = RealClock.machineNs() + ms * NS_PER_MS;
      long nextNs = RealClock.machineNs();
      while (RealClock.machineNs() < endNs) {
        client.receive(frame.clear());
        frame.flip();
        if (frame.get(0) == FRAME && RealClock.machineNs() >= nextNs) {
          nextNs = RealClock.machineNs() + periodMs * NS_PER_MS;
          sent += sendAsCameras(frame);
        }
      }
    }
    return sent + " frames sent";
  }

  /**
   * Answers of another server in the cameras' name: with bot0's and bot1's names swapped.
   *
   * @param ticks factor of its clock's rate; 0 for the true one
   */
  private String forgeAnswer(int times, String version, byte[] question, int ticks)
      throws IOException {
    List<PoseSource.Body> bodies = new ArrayList<>();
    for (String name : List.of("bot1", "bot0", "bot2", "bot3")) {
      bodies.add(new PoseSource.Body(name, new Pose(0, 0, 0), true, 0));
    }
    long sent = 0;
    try (NatNetServer server = imitate(version, () -> bodies);
        DatagramChannel client = DatagramChannel.open().bind(local(0))) {
      client.send(ByteBuffer.wrap(question), server.address());
      ByteBuffer answer = ByteBuffer.allocate(MAX_DATAGRAM).order(ByteOrder.LITTLE_ENDIAN);
      client.receive(answer);
      answer.flip();
      if (ticks > 0) {
        answer.putLong(TICKS_AT, answer.getLong(TICKS_AT) * ticks);
      }
      for (int i = 0; i < times; i++) {
        sent += sendAsCameras(answer);
        pause(100);
      }
    }
    return sent + " messages sent";
  }

  private int sendAsCameras(ByteBuffer datagram) {
    int sent = 0;
    for (int i = 0; i < ROBOTS; i++) {
      if (clients[i] != null) {
        send(toClient[i], datagram.duplicate(), clients[i]);
        sent++;
      }
    }
    return sent;
  }

  private static void pause(long ms) {
    if (ms > 0) {
      LockSupport.parkNanos(ms * NS_PER_MS);
    }
  }
}
