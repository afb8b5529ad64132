package org.starl.launch;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.ItemPosition;
import org.starl.id.RobotId;
import org.starl.input.FailureText;
import org.starl.platform.Timer;
import org.starl.random.Rng;
import org.starl.robot.CreateWheelbase;
import org.starl.robot.create.CreateHost;
import org.starl.robot.create.CreateModel;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.HostPort;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels;
import org.starl.robot.file.Wheels.Create;
import org.starl.robot.optitrack.PoseSource;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.realtime.RealStrand;
import org.starl.robot.serial.PseudoTerminal;
import org.starl.robot.trace.LateTrace;
import org.starl.robot.trace.MachineClock;
import org.starl.robot.trace.ProcessTrace;
import org.starl.sim.SimulationPlan;
import org.starl.sim.world.FloorObjects;
import org.starl.sim.world.SimChassis;
import org.starl.sim.world.World;
import org.starl.trace.TraceEvent.Fault;

/**
 * The simulated bodies of a deployment: one floor with all of them, a simulated Create at the far
 * end of each serial link, and a NatNet server or JSON lines in place of the cameras. Its trace has the true
 * bodies, by which specifications are judged.
 *
 * <p>The bodies belong to the server's strand; a body moves in closed form from one command to the
 * next. Robots ask for their place on the floor by {@link WorldClient}.
 */
public final class WorldServer implements AutoCloseable {

  private static final long CAMERA_PERIOD_NS = 5_000_000;
  private static final int CAMERA_FRAMES_PER_S = 100;

  private final Deployment deployment;
  private final Consumer<String> console;
  private final Consumer<Throwable> onFailure;
  private final RealClock clock = RealClock.ofDate();
  private final long startNs = clock.nowNs();
  private final ProcessTrace trace;
  private final RealStrand strand;
  private final double apartMm;
  private final Map<RobotId, WorldBody> bodies = new TreeMap<>();
  private final List<PoseSource.Body> objects;
  private final LimitedLog strangers;
  private final Deque<AutoCloseable> parts = new ArrayDeque<>();
  private final Timer update;
  private boolean isClosed;

  // The strand only: robots whose bodies wait for room, with the streams for the answers.
  private final Map<RobotId, DataOutputStream> waiting = new TreeMap<>();

  // Written on the strand, read by the cameras' thread.
  private volatile PoseSource.Snapshot seen = new PoseSource.Snapshot(0, List.of());

  /**
   * Runs from now on.
   *
   * @param out receives the trace of the bodies
   * @param console receives log lines, from any thread
   * @param onFailure receives, from any thread, an error that ends it early
   * @throws IOException if an address or a device cannot be opened; its message is one line for
   *     people
   */
  public WorldServer(
      Deployment deployment,
      SimulationPlan plan,
      OutputStream out,
      Consumer<String> console,
      Consumer<Throwable> onFailure)
      throws IOException {
    this.deployment = deployment;
    this.console = console;
    strangers = new LimitedLog(clock, console);
    this.onFailure = onFailure;
    trace = new ProcessTrace(Fault.WORLD, plan.header(), out, onFailure::accept);
    MachineClock.tell(trace, clock, startNs);
    strand = new RealStrand("world", clock, onFailure);
    parts.push(strand);
    apartMm = Launcher.ROOM_IN_RADII * plan.settings().robotRadiusMm();
    World world =
        new World(
            strand.pieceClock(),
            strand,
            new LateTrace(trace, startNs, event -> {}),
            plan.settings().worldLimits(),
            plan.obstacles());
    objects = tagged(plan.objects());
    update = strand.timer(this::update);
    try {
      for (RobotEntry entry : deployment.simulated()) {
        bodies.put(entry.id(), body(entry, plan, world));
      }
      serveRobots();
      parts.push(
          Cameras.open(deployment, () -> seen, CAMERA_FRAMES_PER_S, clock, onFailure, console));
      for (RobotEntry entry : deployment.simulated()) {
        if (entry.wheels() instanceof Create create) {
          serveCreate(entry.id(), create);
        }
      }
    } catch (IOException | RuntimeException e) {
      close();
      throw e;
    }
    strand.post(this::update);
  }

  private WorldBody body(RobotEntry entry, SimulationPlan plan, World world) {
    CreateModel model =
        entry.wheels() instanceof Create create
            ? CreateWheelbase.model(create)
            : CreateModel.CREATE_2;
    Rng rng = new Rng(deployment.seed()).fork(entry.id().name()).fork("chassis");
    return new WorldBody(
        RobotMain.spec(plan, entry.id()),
        entry.rigidBody(),
        plan.settings(),
        model.axleMm(),
        world,
        strand,
        new SimChassis(strand, rng, plan.settings().speedError()));
  }

  /** The objects on the floor, as cameras see them: tagged like robots. */
  private static List<PoseSource.Body> tagged(@Nullable FloorObjects floor) {
    List<ItemPosition> objects = floor == null ? List.of() : floor.objects();
    return objects.stream()
        .map(object -> new PoseSource.Body(object.name(), object.pose(), true, 0))
        .toList();
  }

  /** The wheels of a robot that is simulated without a Create: its program runs in this process. */
  public Wheelbase.Source wheels(RobotId robot) {
    WorldBody body = bodies.get(robot);
    if (body == null) {
      throw new IllegalArgumentException(robot + " is not simulated");
    }
    return (robotStrand, robotClock, log, onWheelFailure) -> new SimulatedWheels(body, robotStrand);
  }

  /** Ends it, with its Creates and cameras. */
  @Override
  public void close() {
    if (isClosed) {
      return;
    }
    isClosed = true;
    for (AutoCloseable part : parts) {
      try {
        part.close();
      } catch (Exception e) {
        console.accept(part + ": " + FailureText.of(e)); // the end of the process closes it too
      }
    }
    try {
      trace.end(clock.nowNs() - startNs);
    } catch (IOException e) {
      console.accept("the trace is cut off: " + FailureText.of(e));
    }
  }

  /** Places waiting bodies, and updates the cameras' picture. On the strand. */
  private void update() {
    waiting
        .entrySet()
        .removeIf(each -> {
          RobotId robot = each.getKey();
          WorldBody body = bodies.get(robot);
          boolean isPlaced = body != null && body.place(apartMm);
          if (isPlaced) {
            answer(each.getValue(), WorldClient.Word.PLACED);
            console.accept(robot + " is on the floor");
          }
          return isPlaced;
        });
    long nowNs = strand.pieceClock().nowNs();
    List<PoseSource.Body> all = new ArrayList<>();
    bodies.values().forEach(body -> all.add(body.seen(nowNs)));
    all.addAll(objects);
    seen = new PoseSource.Snapshot(nowNs, all);
    update.set(nowNs + CAMERA_PERIOD_NS);
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
            ended -> strangers.log(robot.name(), robot + "'s Create: " + ended.getMessage()));
    parts.push(host);
    switch (create.simulatedAt()) {
      case Wheels.Tcp tcp -> host.listen(listen(tcp.address()));
      case Wheels.Device device -> host.serve(PseudoTerminal.open(device.path()));
    }
  }

  private static ServerSocket listen(HostPort address) throws IOException {
    ServerSocket server = new ServerSocket();
    server.setReuseAddress(true);
    server.bind(address.resolve());
    return server;
  }

  private void serveRobots() throws IOException {
    HostPort address = deployment.world();
    if (address == null) {
      throw new IllegalArgumentException(
          "simulated bodies need 'world:', the address of their world");
    }
    RobotDoor door =
        new RobotDoor(
            listen(address), bodies::containsKey, this::talk, strangers, onFailure::accept);
    parts.push(door);
    door.open();
  }

  // On the connection's thread.
  private void talk(RobotId robot, Socket socket, DataInputStream in) throws IOException {
    WorldBody body = bodies.get(robot);
    if (body == null) {
      throw new IllegalStateException(robot + " is not simulated");
    }
    DataOutputStream answers = new DataOutputStream(socket.getOutputStream());
    while (true) {
      WorldClient.Word word = WorldClient.Word.read(in);
      strand.post(() -> obey(robot, body, word, answers));
    }
  }

  // On the strand.
  private void obey(
      RobotId robot, WorldBody body, WorldClient.Word word, DataOutputStream answers) {
    waiting.remove(robot);
    if (word == WorldClient.Word.PLACE) {
      waiting.put(robot, answers);
    } else if (word == WorldClient.Word.LIFT) {
      body.lift();
      answer(answers, WorldClient.Word.LIFTED);
    }
  }

  private void answer(DataOutputStream to, WorldClient.Word word) {
    try {
      to.writeUTF(word.name());
    } catch (IOException e) {
      strangers.log("lost", "a robot's connection: " + e.getMessage());
    }
  }
}
