package org.starl.launch;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.RobotApp;
import org.starl.RobotRunner;
import org.starl.geometry.Pose;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.DeploymentKey;
import org.starl.platform.Light;
import org.starl.platform.LogSink.Level;
import org.starl.platform.Platform;
import org.starl.platform.Timer;
import org.starl.random.Rng;
import org.starl.robot.DeployedRobot;
import org.starl.robot.realtime.RealBackground;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.realtime.RealStrand;
import org.starl.robot.trace.ProcessFact;
import org.starl.robot.trace.ProcessTrace;
import org.starl.robot.udp.Discovery;
import org.starl.robot.udp.FileStable;
import org.starl.robot.udp.LossyRadio;
import org.starl.robot.udp.OpenSessions;
import org.starl.robot.udp.PeerKeys;
import org.starl.robot.udp.UdpRadio;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.SimulationPlan;
import org.starl.sim.world.Body;
import org.starl.sim.world.MeasuredRobots;
import org.starl.sim.world.SimChassis;
import org.starl.sim.world.SimObjects;
import org.starl.sim.world.SimPositioning;
import org.starl.sim.world.World;
import org.starl.time.Time;

/**
 * One incarnation of a robot's program in a process: strand, radio and storage of the real platform,
 * wheels and fixes of a simulated body. The body is alone in its world: bodies of other processes
 * cannot touch it.
 */
final class SimulatedRobot implements OneRobotControl.Body, AutoCloseable {

  private static final long ALIVE_EVERY_NS = 50 * Time.NS_PER_MS;
  private static final Discovery.Settings BEACONS =
      new Discovery.Settings(500, Integer.MAX_VALUE, 0);

  private final ProcessTrace trace;
  private final DeployedRobot.Host host;
  private final SimulationPlan plan;
  private final RobotSpec spec;
  private final RealClock real;
  private final RealStrand strand;
  private final BodyClock clock;
  private final UdpRadio udp;
  private final OpenSessions sessions = new OpenSessions();
  private final LossyRadio radio;
  private final FileStable stable;
  private final RealBackground background;
  private final SimulatedBody body;
  private final SimChassis chassis;
  private final SimPositioning positioning;
  private final RobotRunner runner;
  private final OneRobotControl control;
  private final Timer alive;

  // Null if datagrams are not sealed; set before the strand starts the program.
  private @Nullable Discovery discovery;

  // Strand only.
  private boolean isPlaceRequested;
  private boolean mayBePlaced;

  /**
   * Opens everything; {@link #start} runs it.
   *
   * @param number of the incarnation, from 1, for its random numbers
   * @param port to listen at on the loopback interface; 0 for any free one
   */
  SimulatedRobot(
      SimulationPlan plan,
      RobotSpec spec,
      int number,
      RealClock real,
      Path folder,
      int port,
      ProcessTrace trace,
      DeployedRobot.Host host)
      throws IOException {
    this.plan = plan;
    this.spec = spec;
    this.real = real;
    this.trace = trace;
    this.host = host;
    SimSettings settings = plan.settings();
    RobotId id = spec.id();
    Participants participants = Participants.of(plan.header().robots());
    Rng robotRng = new Rng(plan.header().behaviourSeed()).fork(id.name());
    Rng rng = number == 1 ? robotRng : robotRng.fork("incarnation" + number);
    strand = new RealStrand(id.name(), real, host::failed);
    clock = new BodyClock(strand.pieceClock(), this::scaleWheels);
    udp = UdpRadio.open(id, strand, loopback(port), host::failed);
    radio =
        new LossyRadio(
            udp,
            id,
            participants,
            clock,
            strand,
            rng.fork("radio"),
            draw -> delayNs(settings, draw));
    stable = FileStable.open(folder, strand, host::failed);
    background = new RealBackground(id.name(), strand);
    World world =
        new World(
            clock::shownNs, clock.reading(strand), trace, settings.worldLimits(), plan.obstacles());
    chassis = new SimChassis(strand, rng.fork("chassis"), settings.speedError());
    body = new SimulatedBody(spec, settings, world, chassis);
    long periodNs = settings.positionPeriodNs();
    positioning =
        new SimPositioning(
            id,
            new MeasuredRobots(),
            clock,
            clock::shownNs,
            strand,
            rng.fork("positioning"),
            settings.positionNoise(),
            periodNs,
            settings.get(Setting.POSITION_IN_PHASE)
                ? 0
                : SimPositioning.drawnPhaseNs(robotRng.fork("positioning"), periodNs));
    Platform platform =
        new Platform(
            id,
            participants,
            clock,
            strand,
            strand,
            radio,
            positioning,
            chassis,
            SimObjects.of(plan.objects(), world, this::bodyOrNull),
            Light.SIMULATED,
            stable,
            rng::fork,
            background,
            this::log,
            trace,
            plan.obstacles().known(),
            plan.waypoints(),
            settings.motionParameters(plan.robots().indexOf(spec), plan.robots().size()),
            plan.key() == null ? null : sessions);
    runner = new RobotRunner(platform, this::makeApp, this::appEnded);
    control = new OneRobotControl(plan, spec, this, strand, clock, runner);
    alive = strand.timer(this::reportAlive);
  }

  private RobotApp makeApp(GlobalVarHolder gvh) {
    if (discovery != null) {
      discovery.begin(gvh.id.boot());
    }
    return spec.app().apply(gvh);
  }

  private static long delayNs(SimSettings settings, Rng rng) {
    double loss = settings.messageLoss().probability();
    return loss > 0 && rng.nextBoolean(loss)
        ? LossyRadio.LOST
        : settings.messageDelay().drawNs(rng);
  }

  private static InetSocketAddress loopback(int port) {
    return new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
  }

  /** The port of its radio. */
  int port() {
    return udp.address().getPort();
  }

  /**
   * Starts the program.
   *
   * @param ports of all robots' radios
   */
  void start(Map<RobotId, Integer> ports) {
    ports.forEach((robot, port) -> udp.setPeer(robot, loopback(port)));
    DeploymentKey key = plan.key();
    if (key != null) {
      SortedMap<RobotId, InetSocketAddress> known = new TreeMap<>();
      ports.forEach((robot, port) -> known.put(robot, loopback(port)));
      Participants robots = Participants.of(plan.header().robots());
      discovery =
          new Discovery(
              udp,
              spec.id(),
              robots,
              known,
              PeerKeys.shared(key, spec.id(), robots),
              sessions,
              strand,
              stable,
              BEACONS,
              real,
              new Introductions());
    }
    strand.post(this::reportAlive);
    control.begin();
    runner.start();
  }

  /** There is room for its body on the floor. */
  void allowPlace() {
    strand.post(() -> mayBePlaced = true);
  }

  /** Removes its body from the floor, and ends the program at that time. */
  void leaveFloor() {
    CountDownLatch gone = new CountDownLatch(1);
    strand.post(() -> {
      lift();
      strand.close();
      gone.countDown();
    });
    try {
      gone.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * Reports what its app waits for, unless the app has ended.
   *
   * @return false if the app does not release the strand
   */
  boolean reportWaits() {
    return RobotMain.runOn(
        strand,
        () -> {
          GlobalVarHolder gvh = runner.gvh();
          RobotApp app = runner.app();
          if (gvh != null && app != null && runner.results() == null) {
            trace.report(clock, new ProcessFact.Waits(app.awaited(), gvh.waits()));
          }
        });
  }

  /** Ends it. Its body stays where it is. */
  @Override
  public void close() {
    udp.close();
    strand.close();
    background.close();
    stable.close();
  }

  private void reportAlive() {
    trace.report(
        clock, new ProcessFact.Alive(radio.copies(), radio.lost(), clock.longestPauseNs()));
    alive.set(clock.nowNs() + ALIVE_EVERY_NS);
  }

  private void appEnded() {
    List<Object> results = Objects.requireNonNull(runner.results());
    trace.report(
        clock,
        new ProcessFact.Finished(
            results.stream().map(String::valueOf).collect(Collectors.toList())));
    host.finished(results);
  }

  private void log(long timeNs, Level level, String tag, String line) {
    if (level.compareTo(Level.INFO) >= 0) {
      trace.report(clock, new ProcessFact.Log(level, tag, line));
    }
  }

  // The methods below read the clock first, to move the body to its current position.

  @Override
  public boolean place() {
    if (!isPlaceRequested) {
      isPlaceRequested = true;
      trace.report(clock, new ProcessFact.WantsPlace());
    }
    clock.nowNs();
    if (!mayBePlaced || !body.place(0)) {
      return false;
    }
    positioning.mount(body.onFloor());
    return true;
  }

  @Override
  public void lift() {
    if (body.isOnFloor()) {
      clock.nowNs();
      positioning.unmount();
      body.lift();
    }
  }

  @Override
  public boolean isOnFloor() {
    return body.isOnFloor();
  }

  @Override
  public boolean isFree(Pose place) {
    clock.nowNs();
    return body.isFree(place);
  }

  @Override
  public Pose pose() {
    clock.nowNs();
    return body.onFloor().pose();
  }

  private @Nullable Body bodyOrNull() {
    clock.nowNs();
    return body.isOnFloor() ? body.onFloor() : null;
  }

  private void scaleWheels(double factor) {
    chassis.impair(factor, factor);
  }

  /** The parent knows which processes run; here only the sessions count. */
  private final class Introductions implements Discovery.Listener {

    @Override
    public void appeared(RobotId robot, InetSocketAddress address) {}

    @Override
    public void suspected(RobotId robot, @Nullable Long lastHeardNs) {}

    @Override
    public void unknown(List<RobotId> knownTo) {}

    @Override
    public void refused(RobotId robot, InetSocketAddress address, boolean isOtherStorage) {}

    @Override
    public void disowned(String why) {
      host.failed(new IllegalStateException(why));
    }
  }
}
