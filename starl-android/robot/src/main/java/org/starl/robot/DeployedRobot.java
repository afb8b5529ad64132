package org.starl.robot;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.RobotApp;
import org.starl.RobotRunner;
import org.starl.body.MotionParameters;
import org.starl.geometry.Fix;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacles;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.motion.Location;
import org.starl.platform.DeploymentKey;
import org.starl.platform.Light;
import org.starl.platform.LogSink;
import org.starl.platform.LogSink.Level;
import org.starl.platform.ObjectSensor;
import org.starl.platform.Platform;
import org.starl.random.Rng;
import org.starl.robot.create.CreateHold;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.HostPort;
import org.starl.robot.file.Network;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.optitrack.FeedStatistics;
import org.starl.robot.optitrack.PoseFeed;
import org.starl.robot.realtime.RealBackground;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.realtime.RealStrand;
import org.starl.robot.realtime.StrandUse;
import org.starl.robot.trace.DropSummary;
import org.starl.robot.trace.ProcessFact;
import org.starl.robot.udp.Discovery;
import org.starl.robot.udp.FileStable;
import org.starl.robot.udp.LossyRadio;
import org.starl.robot.udp.OpenSessions;
import org.starl.robot.udp.PeerKeys;
import org.starl.robot.udp.UdpRadio;
import org.starl.robot.udp.UdpStatistics;
import org.starl.time.Time;
import org.starl.trace.Instance;
import org.starl.trace.Note;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceSink;
import org.starl.trace.Vocabulary;

/**
 * One robot of a deployment, from {@link #open} to {@link #close}: an incarnation of its program on the
 * real platform. Times are those of {@link RealClock#ofDate}.
 */
public final class DeployedRobot implements AutoCloseable {

  /** What a reader of the traces of robots in real time needs, besides that of the app. */
  public static final Vocabulary VOCABULARY =
      ProcessFact.VOCABULARY
          .and(DropSummary.VOCABULARY)
          .and(MeasuredBody.VOCABULARY)
          .variables(CreateHold.WHEELS.primitive(), CreateHold.HELD_BY);

  private static final String TAG = "network";

  /**
   * The robot's program.
   *
   * @param app makes the app over the robot's gvh
   * @param knownObstacles the map at the start
   * @param waypoints named places on the floor
   * @param motion parameters, except those that follow from the deployment's limits
   */
  public record Program(
      Function<GlobalVarHolder, ? extends RobotApp> app,
      Obstacles knownObstacles,
      List<ItemPosition> waypoints,
      MotionParameters motion) {}

  /**
   * The robot's environment.
   *
   * @param storage a folder for this robot only
   * @param wheels this robot's
   * @param linesKey of the JSON feed's lines; null for none
   * @param clock read by several threads
   * @param log from any thread
   * @param trace from any thread
   * @param light called on the strand; null for the drive's light
   */
  public record Surroundings(
      Path storage,
      Wheelbase.Source wheels,
      @Nullable DeploymentKey linesKey,
      RealClock clock,
      LogSink log,
      TraceSink trace,
      @Nullable Light light) {}

  /** Receives the robot's end. */
  public interface Host {

    /** On the strand: the app has ended; the robot still answers messages. */
    void finished(List<Object> results);

    /** From any thread: the robot cannot continue. Its wheels are already stopped. */
    void failed(Throwable error);
  }

  private final RobotId id;
  private final Host host;
  private final RealClock clock;
  private final LogSink log;
  private final DropSummary trace;
  private final RealStrand strand;
  private final UdpRadio udp;
  private final Discovery discovery;
  private final boolean isProven;
  private final FileStable stable;
  private final RealBackground background;
  private final PoseFeed poses;
  private final MeasuredBody body;
  private final Wheelbase wheels;
  private final RobotRunner runner;

  /**
   * Opens everything; {@link #start} runs it.
   *
   * @param keys null: datagrams are not sealed
   * @throws IOException if radio, storage, positions or wheels cannot be opened; one line for people
   */
  public static DeployedRobot open(
      Deployment deployment,
      RobotEntry entry,
      @Nullable PeerKeys keys,
      Program program,
      Surroundings surroundings,
      Host host)
      throws IOException {
    Opened opened = new Opened();
    try {
      return new DeployedRobot(deployment, entry, keys, program, surroundings, host, opened);
    } catch (IOException | RuntimeException e) {
      opened.close();
      throw e;
    }
  }

  private DeployedRobot(
      Deployment deployment,
      RobotEntry entry,
      @Nullable PeerKeys keys,
      Program program,
      Surroundings surroundings,
      Host host,
      Opened opened)
      throws IOException {
    id = entry.id();
    this.host = host;
    clock = surroundings.clock();
    log = surroundings.log();
    trace = new DropSummary(id, surroundings.trace());
    strand = opened.add(new RealStrand(id.name(), clock, this::fail));
    strand.onLongPiece(deployment.limits().reactionMs() * Time.NS_PER_MS, this::held);
    wheels = opened.add(surroundings.wheels().open(strand, clock, this::wheelsLog, host::failed));
    Light light = surroundings.light() == null ? wheels : surroundings.light();
    InetSocketAddress address = address(entry, deployment.network());
    InetAddress local = address.getAddress().isAnyLocalAddress() ? null : address.getAddress();
    udp = opened.add(UdpRadio.open(id, strand, address, this::fail));
    udp.onDrop(line -> log.log(clock.nowNs(), Level.WARN, TAG, line));
    stable = opened.add(FileStable.open(surroundings.storage(), strand, this::fail));
    background = opened.add(new RealBackground(id.name(), strand));
    poses = opened.add(PoseFeeds.open(deployment, surroundings.linesKey(), local, clock, log));
    OwnFixes.join(poses, entry, wheels, deployment.limits());
    long startNs = clock.nowNs();
    Participants participants = deployment.participants();
    isProven = keys != null;
    OpenSessions sessions = new OpenSessions();
    discovery =
        opened.add(
            new Discovery(
                udp,
                id,
                participants,
                known(deployment),
                keys,
                sessions,
                strand,
                stable,
                settings(deployment.network()),
                clock,
                new Neighbourhood()));
    // Each start has its own random choices.
    Rng rng = new Rng(deployment.seed()).fork(id.name()).fork("start" + startNs);
    double loss = deployment.network().loss();
    LossyRadio radio =
        new LossyRadio(
            udp,
            id,
            participants,
            strand.pieceClock(),
            strand,
            rng.fork("radio"),
            draw -> loss > 0 && draw.nextBoolean(loss) ? LossyRadio.LOST : 0);
    MotionParameters motion = RealMotion.of(program.motion(), deployment.limits());
    body =
        new MeasuredBody(
            id,
            motion.robotRadiusMm(),
            deployment.limits().speedMmPerS(),
            deployment.limits().stillAfterNs(),
            poses.positioning(strand, entry.rigidBody()),
            () -> positions(poses.newest(), deployment.robots().values()),
            strand.pieceClock(),
            trace);
    Platform platform =
        new Platform(
            id,
            participants,
            strand.pieceClock(),
            strand,
            strand,
            radio,
            body,
            wheels,
            objects(deployment, entry, program.knownObstacles(), motion.robotRadiusMm()),
            light,
            discovery.storage(),
            rng::fork,
            background,
            log,
            trace,
            program.knownObstacles(),
            program.waypoints(),
            motion,
            keys == null ? null : sessions);
    runner =
        new RobotRunner(
            platform,
            gvh -> {
              // The boot number is in stable storage now.
              discovery.begin(gvh.id.boot());
              wheels.onHolds(gvh.variable(CreateHold.WHEELS, CreateHold.HELD_BY, List.of())::set);
              return program.app().apply(gvh);
            },
            this::finished);
  }

  /** Starts the app. Once. */
  public void start() {
    runner.start();
  }

  /** The strand on which all of it runs. */
  public RealStrand strand() {
    return strand;
  }

  /** Runs the robot's program. */
  public RobotRunner runner() {
    return runner;
  }

  /** The use of the strand's time so far. */
  public StrandUse strandUse() {
    return strand.use();
  }

  /** Counts of the measuring system's messages. */
  public FeedStatistics positions() {
    return poses.statistics();
  }

  /** Counts of the radio's datagrams. */
  public UdpStatistics network() {
    return udp.statistics();
  }

  /** Stops the wheels at once, below the program, until {@link #release}. */
  public void emergencyStop() {
    // Stop first: a log may block on a disk or a terminal.
    wheels.emergencyStop();
    log.log(clock.nowNs(), Level.WARN, "wheels", "emergency stop");
  }

  /** Ends the emergency stop: the program's next command is obeyed. */
  public void release() {
    wheels.release();
  }

  /** Stops the wheels, then ends the robot. */
  @Override
  public void close() {
    wheels.emergencyStop();
    wheels.close();
    discovery.close();
    udp.close();
    strand.close();
    body.end(clock.nowNs());
    trace.flush(clock.nowNs());
    poses.close();
    background.close();
    stable.close();
  }

  private static InetSocketAddress address(RobotEntry entry, Network network) throws IOException {
    HostPort address = entry.address();
    return address == null ? new InetSocketAddress(network.port()) : address.resolve();
  }

  private static SortedMap<RobotId, InetSocketAddress> known(Deployment deployment)
      throws IOException {
    SortedMap<RobotId, InetSocketAddress> known = new TreeMap<>();
    for (RobotEntry robot : deployment.robots().values()) {
      HostPort address = robot.address();
      if (address != null) {
        known.put(robot.id(), address.resolve());
      }
    }
    return known;
  }

  private static Discovery.Settings settings(Network network) {
    return new Discovery.Settings(
        network.beaconEveryMs(),
        network.suspectAfterMs(),
        network.broadcasts() ? network.port() : 0);
  }

  private ObjectSensor objects(
      Deployment deployment, RobotEntry entry, Obstacles obstacles, double radiusMm) {
    if (entry.objects() == null) {
      return ObjectSensor.NONE;
    }
    return switch (entry.objects()) {
      case POSITIONS -> {
        Set<String> robots = new TreeSet<>();
        deployment.robots().values().forEach(robot -> robots.add(robot.rigidBody()));
        yield new TaggedObjects(poses::newest, robots, this::location, obstacles, clock);
      }
      case BUMPER -> new BumperObjects(wheels, radiusMm, this::location);
    };
  }

  /** The program's estimate. On the strand. */
  private Location location() {
    GlobalVarHolder gvh = runner.gvh();
    return gvh == null ? new Location.Unknown() : gvh.gps.location();
  }

  /** The robots' fixes, of those of bodies by their names in the measuring system. */
  static SortedMap<RobotId, Fix> positions(
      Map<String, Fix> bodies, Collection<RobotEntry> entries) {
    SortedMap<RobotId, Fix> robots = new TreeMap<>();
    for (RobotEntry robot : entries) {
      Fix fix = bodies.get(robot.rigidBody());
      if (fix != null) {
        robots.put(robot.id(), fix);
      }
    }
    return robots;
  }

  /** Warnings of the wheels are actions of the trace, too: they explain violations. */
  private void wheelsLog(long timeNs, Level level, String tag, String line) {
    log.log(timeNs, level, tag, line);
    if (level.compareTo(Level.WARN) >= 0) {
      act("wheels", "warns", line);
    }
  }

  private void held(long pieceNs, String by) {
    String line = by + " held the strand for " + pieceNs / Time.NS_PER_MS + " ms";
    log.log(clock.nowNs(), Level.WARN, "strand", line + ": commands and messages were late");
    act("strand", "held", line);
  }

  private void act(String source, String action, String argument) {
    strand.post(() -> {
      if (trace.isOn()) {
        trace.record(
            Action.of(
                strand.pieceClock().nowNs(),
                id,
                Instance.of(source),
                Note.SHAPE,
                new Note(action, List.of(argument))));
      }
    });
  }

  private void finished() {
    host.finished(List.copyOf(runner.results() == null ? List.of() : runner.results()));
  }

  private void fail(Throwable error) {
    wheels.emergencyStop();
    host.failed(error);
  }

  /** Logs and traces which robots are heard, suspected and refused. */
  private final class Neighbourhood implements Discovery.Listener {

    @Override
    public void refused(RobotId robot, InetSocketAddress at, boolean isOtherStorage) {
      String why =
          isOtherStorage
              ? "its storage is not the one that is known here"
              : "a later start of it is known here";
      tell(Level.WARN, "refuses", robot, "refuses " + robot + " at " + at + ": " + why);
    }

    @Override
    public void disowned(String why) {
      if (isProven) {
        fail(new DisownedException(why));
      } else {
        // Without keys any sender on the network could stop robots by this.
        log.log(clock.nowNs(), Level.WARN, TAG, why);
      }
    }

    @Override
    public void appeared(RobotId robot, InetSocketAddress at) {
      tell(Level.INFO, "hears", robot, "hears " + robot + " at " + at);
    }

    @Override
    public void suspected(RobotId robot, @Nullable Long lastHeardNs) {
      String since =
          lastHeardNs == null
              ? "was never heard"
              : "was last heard " + (clock.nowNs() - lastHeardNs) / Time.NS_PER_MS + " ms ago";
      tell(Level.WARN, "suspects", robot, "suspects " + robot + ", which " + since);
    }

    @Override
    public void unknown(List<RobotId> knownTo) {
      log.log(
          clock.nowNs(),
          Level.WARN,
          TAG,
          "the storage is new, and known to "
              + (knownTo.isEmpty() ? "no other robot" : String.valueOf(knownTo))
              + ": "
              + id
              + " promises nothing (no vote, no consent) until more than half of the others know it");
    }

    private void tell(Level level, String action, RobotId robot, String line) {
      log.log(clock.nowNs(), level, TAG, line);
      act(TAG, action, robot.name());
    }
  }

  /** The parts opened so far, to be closed if a later one cannot be opened. */
  private static final class Opened {
    private final ArrayDeque<AutoCloseable> parts = new ArrayDeque<>();

    <T extends AutoCloseable> T add(T part) {
      parts.push(part);
      return part;
    }

    void close() {
      for (AutoCloseable part : parts) {
        try {
          part.close();
        } catch (Exception e) {
          throw new IllegalStateException(part + " cannot be closed", e);
        }
      }
    }
  }
}
