package org.starl.deployment;

import java.io.BufferedInputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.platform.Timer;
import org.starl.random.Rng;
import org.starl.robot.CreateWheelbase;
import org.starl.robot.PoseFeeds;
import org.starl.robot.Wheelbase;
import org.starl.robot.create.CreateHost;
import org.starl.robot.create.CreateModel;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.HostPort;
import org.starl.robot.file.Positions;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels;
import org.starl.robot.file.Wheels.Create;
import org.starl.robot.optitrack.NatNetServer;
import org.starl.robot.optitrack.NatNetServerSettings;
import org.starl.robot.optitrack.NatNetVersion;
import org.starl.robot.optitrack.PoseSource;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.realtime.RealStrand;
import org.starl.robot.trace.LateTrace;
import org.starl.robot.trace.MachineClock;
import org.starl.robot.trace.Outbox;
import org.starl.sim.Blueprint;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.world.SimChassis;
import org.starl.sim.world.World;
import org.starl.trace.TraceEvent.Fault;

/**
 * The world of a deployment whose bodies, all or some, are simulated: one floor with all of them, a
 * simulated Create at the far end of each one's link, and the cameras, a NatNet server. What it says of
 * bodies in its trace is the truth that specifications are judged by.
 *
 * <p>It has a strand of its own, on which the bodies are; a body moves in closed form from one command to
 * the next. Robots ask it for places by {@link Hands}.
 */
public final class WorldProcess implements AutoCloseable {

  private static final long LOOK_EVERY_NS = 5_000_000;
  // Between two bodies' middles, one of which has made room for the other: a radius to spare.
  private static final double ROOM_IN_RADII = 3;
  private static final double NO_AXLE_MM = CreateModel.CREATE_2.axleMm();

  private final Deployment deployment;
  private final Consumer<String> teller;
  private final Consumer<Throwable> onFailure;
  private final RealClock clock = RealClock.ofDate();
  private final long startNs = clock.nowNs();
  private final Outbox trace;
  private final RealStrand strand;
  private final double apartMm;
  private final Map<RobotId, WorldBody> bodies = new TreeMap<>();
  private final Deque<Closeable> open = new ArrayDeque<>();
  private final Deque<AutoCloseable> parts = new ArrayDeque<>();
  private final List<Wish> wishes = new ArrayList<>();
  private final Timer look;
  private boolean isClosed;

  // Made anew on the world's strand at each look; the cameras' thread takes the newest.
  private volatile PoseSource.Snapshot seen = new PoseSource.Snapshot(0, List.of());

  /** A body that is to be put on the floor, and who is told. */
  private record Wish(RobotId robot, WorldBody body, OutputStream asker) {}

  /**
   * Runs from now on.
   *
   * @param out takes the trace of the bodies
   * @param teller takes lines for people, from any thread
   * @param onFailure is told what ends it early, from any thread
   * @throws IOException if an address or a device is not to be had: one line for people
   */
  public WorldProcess(
      Deployment deployment,
      Blueprint blueprint,
      OutputStream out,
      Consumer<String> teller,
      Consumer<Throwable> onFailure)
      throws IOException {
    this.deployment = deployment;
    this.teller = teller;
    this.onFailure = onFailure;
    trace = new Outbox(Fault.WORLD, blueprint.header(), out);
    MachineClock.tell(trace, clock, startNs);
    strand = new RealStrand("world", clock, onFailure);
    parts.push(strand);
    double radiusMm = blueprint.settings().robotRadiusMm();
    apartMm = ROOM_IN_RADII * radiusMm;
    World world =
        new World(
            strand.pieceClock(),
            strand,
            new LateTrace(trace, startNs, event -> {}),
            blueprint.settings().worldLimits(),
            blueprint.obstacles());
    look = strand.timer(this::look);
    try {
      for (RobotEntry entry : deployment.simulated()) {
        bodies.put(entry.id(), body(entry, blueprint, world, radiusMm));
      }
      serveHands();
      serveCameras();
      for (RobotEntry entry : deployment.simulated()) {
        if (entry.wheels() instanceof Create create) {
          serveCreate(entry.id(), create);
        }
      }
    } catch (IOException | RuntimeException e) {
      close();
      throw e;
    }
    strand.post(this::look);
  }

  private WorldBody body(RobotEntry entry, Blueprint blueprint, World world, double radiusMm) {
    RobotSpec spec =
        blueprint.robots().stream()
            .filter(each -> each.id().equals(entry.id()))
            .findFirst()
            .orElseThrow(() -> new IllegalArgumentException("there is no robot " + entry.id()));
    double axleMm =
        entry.wheels() instanceof Create create
            ? CreateWheelbase.model(create).axleMm()
            : NO_AXLE_MM;
    Rng rng = new Rng(deployment.seed()).fork(entry.id().name()).fork("chassis");
    SimChassis chassis = new SimChassis(strand, rng, blueprint.settings().get(Setting.SPEED_ERROR));
    return new WorldBody(
        entry.id(), entry.rigidBody(), spec.start(), radiusMm, axleMm, world, strand, chassis);
  }

  /** The wheels of a robot that is simulated without a Create: its program runs in this process. */
  public Wheelbase.Source wheels(RobotId robot) {
    WorldBody body = bodies.get(robot);
    if (body == null) {
      throw new IllegalArgumentException(robot + " is not simulated");
    }
    return (robotStrand, robotClock, log, onFailure) -> new WorldWheels(body, robotStrand);
  }

  /** Ends it, wheels and cameras and all. */
  @Override
  public void close() {
    if (isClosed) {
      return;
    }
    isClosed = true;
    for (Closeable each : open) {
      closeQuietly(each);
    }
    for (AutoCloseable part : parts) {
      closeQuietly(part);
    }
    try {
      trace.end(clock.nowNs() - startNs);
    } catch (IOException e) {
      teller.accept("the trace is cut off: " + e);
    }
  }

  // What cannot be closed is as good as closed: the process ends.
  private void closeQuietly(AutoCloseable part) {
    try {
      part.close();
    } catch (Exception e) {
      teller.accept(part + ": " + e);
    }
  }

  // The world's strand: gives places, and shows the cameras what there is.
  private void look() {
    wishes.removeIf(wish -> {
      boolean isPlaced = wish.body().place(apartMm);
      if (isPlaced) {
        answer(wish.asker(), Hands.Word.PLACED);
        teller.accept(wish.robot() + " is on the floor");
      }
      return isPlaced;
    });
    List<PoseSource.Body> all = new ArrayList<>();
    bodies.values().forEach(body -> all.add(body.seen()));
    long nowNs = strand.pieceClock().nowNs();
    seen = new PoseSource.Snapshot(nowNs, all);
    look.set(nowNs + LOOK_EVERY_NS);
  }

  private static InetSocketAddress here(HostPort address) throws IOException {
    return address.resolve();
  }

  private void serveCameras() throws IOException {
    if (!(deployment.positions() instanceof Positions.NatNet natNet)) {
      throw new IllegalArgumentException("bodies are simulated, and no cameras see them");
    }
    String multicast = natNet.multicast();
    String[] version = natNet.version().split("\\.", -1);
    NatNetServerSettings settings =
        new NatNetServerSettings(
            here(natNet.server()),
            multicast == null
                ? null
                : new InetSocketAddress(InetAddress.getByName(multicast), natNet.dataPort()),
            new NatNetVersion(Integer.parseInt(version[0]), Integer.parseInt(version[1])),
            PoseFeeds.axes(natNet),
            100,
            true);
    parts.push(NatNetServer.open(settings, () -> seen, clock, onFailure::accept));
  }

  private void serveCreate(RobotId robot, Create create) throws IOException {
    WorldBody body = bodies.get(robot);
    if (body == null || create.simulatedAt() == null) {
      throw new IllegalStateException(robot + " is not simulated");
    }
    CreateHost host =
        CreateHost.start(
            robot.name(),
            CreateWheelbase.model(create),
            body,
            clock,
            ended -> teller.accept(robot + "'s Create: " + ended.getMessage()));
    parts.push(host);
    switch (create.simulatedAt()) {
      case Wheels.Tcp tcp -> {
        ServerSocket server = new ServerSocket();
        server.setReuseAddress(true);
        server.bind(here(tcp.address()));
        host.listen(server);
      }
      case Wheels.Device device -> host.serve(ByteLinks.farEnd(device));
    }
  }

  private void serveHands() throws IOException {
    HostPort address = deployment.world();
    if (address == null) {
      throw new IllegalArgumentException("bodies are simulated, and nobody knows where");
    }
    ServerSocket server = new ServerSocket();
    server.setReuseAddress(true);
    server.bind(here(address));
    open.push(server);
    thread("hands", () -> accept(server)).start();
  }

  private void accept(ServerSocket server) {
    while (!server.isClosed()) {
      try {
        Socket socket = server.accept();
        thread("hand", () -> obey(socket)).start();
      } catch (IOException e) {
        if (!server.isClosed()) {
          onFailure.accept(e);
          return;
        }
      }
    }
  }

  private void obey(Socket socket) {
    try (socket;
        ShortLines lines = new ShortLines(new BufferedInputStream(socket.getInputStream()))) {
      String name = lines.next();
      WorldBody body =
          name == null || !RobotId.isValid(name) ? null : bodies.get(new RobotId(name));
      if (name == null || body == null) {
        teller.accept("a stranger asks for a body: " + socket.getRemoteSocketAddress());
        return;
      }
      RobotId robot = new RobotId(name);
      OutputStream answers = socket.getOutputStream();
      for (String line = lines.next(); line != null; line = lines.next()) {
        Hands.Word word = Hands.Word.of(line);
        strand.post(() -> obey(robot, body, word, answers));
      }
    } catch (IOException | IllegalArgumentException e) {
      teller.accept("hands: " + e.getMessage());
    }
  }

  // On the world's strand.
  private void obey(RobotId robot, WorldBody body, Hands.Word word, OutputStream answers) {
    wishes.removeIf(wish -> wish.robot().equals(robot));
    if (word == Hands.Word.PLACE) {
      wishes.add(new Wish(robot, body, answers));
    } else if (word == Hands.Word.LIFT) {
      body.lift();
      answer(answers, Hands.Word.LIFTED);
    }
  }

  // Who has hung up meanwhile needs no answer.
  private void answer(@Nullable OutputStream to, Hands.Word word) {
    try {
      if (to != null) {
        to.write(word.line().getBytes(StandardCharsets.UTF_8));
      }
    } catch (IOException e) {
      teller.accept("hands: " + e.getMessage());
    }
  }

  private static Thread thread(String name, Runnable work) {
    Thread thread = new Thread(work, "world " + name);
    thread.setDaemon(true);
    return thread;
  }
}
