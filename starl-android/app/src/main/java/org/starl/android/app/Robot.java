package org.starl.android.app;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.Version;
import org.starl.body.MotionParameters;
import org.starl.gvh.GvhVariable;
import org.starl.input.FailureText;
import org.starl.motion.Location;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.platform.Strand;
import org.starl.platform.Timer;
import org.starl.robot.CreateWheelbase;
import org.starl.robot.DeployedRobot;
import org.starl.robot.LocalSpecs;
import org.starl.robot.create.ByteLink;
import org.starl.robot.create.CreateChassis;
import org.starl.robot.create.CreateHold;
import org.starl.robot.create.CreateStatus;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.Limits;
import org.starl.robot.file.Wheels;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.trace.LateTrace;
import org.starl.robot.trace.MachineClock;
import org.starl.robot.trace.ProcessFact;
import org.starl.robot.trace.ProcessTrace;
import org.starl.spec.SpecReport.Violation;
import org.starl.time.Time;
import org.starl.trace.TraceHeader;

/**
 * The robot that this phone runs, and its state for the screen. Does not depend on Android. All methods
 * may be called from any thread; opening and closing may block.
 */
final class Robot implements DeployedRobot.Host, AutoCloseable {

  private static final long LOOK_EVERY_NS = 200 * Time.NS_PER_MS;
  private static final String LOCATION = "location";

  /** Instead of a colour: the app has not used the light yet. */
  static final int NO_LIGHT = -1;

  /**
   * A robot's persistent files.
   *
   * @param stable folder of its stable storage
   * @param trace takes its trace
   */
  record Files(Path stable, OutputStream trace) {}

  private final Mission mission;
  private final RecordingLinks links;
  private final Consumer<Throwable> onBug;
  private final RealClock clock = RealClock.ofDate();
  private final long startNs = clock.nowNs();
  private final ProcessTrace trace;
  private final LogSink log;
  private final DeployedRobot deployed;
  private final Timer look;

  // Set once, while the robot is opened.
  private @Nullable CreateChassis chassis;

  // Parts of status(); one thread writes each.
  private volatile String appState = "starts";
  private volatile @Nullable Location location;
  private volatile @Nullable Throwable bug;

  // The strand sets the first, then reads the second; onLight does it in the other order.
  private volatile int lightRgb = NO_LIGHT;
  private volatile IntConsumer onLight = rgb -> {};

  private Robot(
      Mission mission, ByteLink.Source source, Files files, LogSink log, Consumer<Throwable> onBug)
      throws IOException {
    this.mission = mission;
    this.onBug = onBug;
    this.log = log;
    links = new RecordingLinks(source);
    trace =
        new ProcessTrace(
            mission.robot().id(), header(mission.deployment()), files.trace(), this::traceLost);
    MachineClock.tell(trace, clock, startNs);
    LocalSpecs specs = new LocalSpecs(mission.program().monitors(), startNs, this::violated);
    deployed =
        DeployedRobot.open(
            mission.deployment(),
            mission.robot(),
            mission.keys(),
            new DeployedRobot.Program(
                mission.program().app(),
                mission.program().knownObstacles(),
                List.of(),
                MotionParameters.DEFAULT),
            new DeployedRobot.Surroundings(
                files.stable(),
                this::openWheels,
                mission.linesKey(),
                clock,
                this::logAndTrace,
                new LateTrace(trace, startNs, specs::observed),
                this::showLight),
            this);
    look = deployed.strand().timer(this::look);
  }

  /**
   * Brings the robot up and starts its app.
   *
   * @param links to the robot's wheels, through a guard
   * @param files this robot's; the trace is closed with the robot, or if it cannot be opened
   * @param onBug takes the error that ended the robot; its wheels are stopped then
   * @throws IOException if a part cannot be opened; all opened parts are then closed
   */
  static Robot open(
      Mission mission, ByteLink.Source links, Files files, LogSink log, Consumer<Throwable> onBug)
      throws IOException {
    Robot robot;
    try {
      robot = new Robot(mission, links, files, log, onBug);
    } catch (IOException | RuntimeException e) {
      files.trace().close();
      throw e;
    }
    robot.deployed.strand().post(robot::look);
    robot.deployed.start();
    return robot;
  }

  Mission mission() {
    return mission;
  }

  /** Stops the wheels until {@link #release}, whatever the app commands. */
  void emergencyStop() {
    deployed.emergencyStop();
  }

  /** Ends the emergency stop: the app may drive again, unless it has ended by a bug or a violation. */
  void release() {
    if (bug == null) {
      deployed.release();
    }
  }

  /**
   * Sets the one receiver of the app's light, which is the phone's screen: the current colour now, and
   * each further one on the strand; {@link #NO_LIGHT}, or 24 bits, of which 0 is off.
   */
  void onLight(IntConsumer receiver) {
    onLight = receiver;
    receiver.accept(lightRgb);
  }

  RobotStatus status() {
    CreateStatus wheels = wheels().status();
    boolean isLinked = !wheels.holds().contains(CreateHold.NO_LINK);
    return new RobotStatus(
        mission.robot().id(),
        mission.deployment().app(),
        appState,
        location,
        wheels,
        isLinked ? null : links.problem(),
        deployed.network(),
        deployed.strandUse(),
        bug);
  }

  /** Stops the wheels, ends the robot, and then its trace. */
  @Override
  public void close() {
    deployed.close();
    try {
      trace.end(clock.nowNs() - startNs);
    } catch (IOException e) {
      log.log(clock.nowNs(), LogSink.Level.ERROR, "trace", "is cut off: " + FailureText.of(e));
    }
  }

  // On the strand.
  @Override
  public void finished(List<Object> results) {
    appState = "has ended: " + results;
  }

  // From any thread; the wheels are stopped already.
  @Override
  public void failed(Throwable error) {
    bug = error;
    onBug.accept(error);
  }

  // From any thread.
  private void traceLost(IOException failure) {
    CreateChassis here = chassis;
    if (here != null) {
      here.emergencyStop();
    }
    failed(failure);
  }

  // On the strand, which ends: a robot whose program is wrong must not drive on.
  private void violated(Violation violation) {
    if (bug == null) {
      String line = "VIOLATED: " + violation;
      IllegalStateException error = new IllegalStateException(line);
      // First: from now on nothing releases the wheels.
      bug = error;
      emergencyStop();
      deployed.strand().close();
      logAndTrace(clock.nowNs(), LogSink.Level.ERROR, "specification", line);
      failed(error);
    }
  }

  /** The simulator's header for the same run, without the settings that are not in the deployment. */
  private static TraceHeader header(Deployment deployment) {
    return new TraceHeader(
        Version.STARL,
        deployment.app(),
        deployment.seed(),
        TraceHeader.behaviourSeedOf(deployment.seed()),
        deployment.parameters(),
        deployment.participants().asList());
  }

  // From any thread.
  private void logAndTrace(long timeNs, LogSink.Level level, String tag, String line) {
    log.log(timeNs, level, tag, line);
    if (level.compareTo(LogSink.Level.INFO) >= 0) {
      trace.report(() -> Math.max(0, timeNs - startNs), new ProcessFact.Log(level, tag, line));
    }
  }

  private Wheelbase openWheels(
      Strand strand, Clock clock, LogSink log, Consumer<Throwable> onFailure) throws IOException {
    Wheels.Create create = (Wheels.Create) mission.robot().wheels();
    Limits limits = mission.deployment().limits();
    String name = mission.robot().id().name();
    Wheelbase opened =
        CreateWheelbase.of(name, create, limits, links).open(strand, clock, log, onFailure);
    chassis = (CreateChassis) opened;
    return opened;
  }

  // On the strand.
  private void showLight(int rgb) {
    lightRgb = rgb;
    onLight.accept(rgb);
  }

  private CreateChassis wheels() {
    CreateChassis here = chassis;
    if (here == null) {
      throw new IllegalStateException("a robot without wheels");
    }
    return here;
  }

  // On the strand.
  private void look() {
    // Null until its boot number is on the disk.
    GlobalVarHolder gvh = deployed.runner().gvh();
    if (gvh != null) {
      location = gvh.gps.location();
      if (!deployed.runner().isFinished()) {
        appState = "runs" + appLocation(gvh);
      }
    }
    look.set(clock.nowNs() + LOOK_EVERY_NS);
  }

  /** The app's location in its state machine, as the paper's figures name it. */
  private static String appLocation(GlobalVarHolder gvh) {
    for (GvhVariable<?> variable : gvh.variables()) {
      if (variable.name().equals(LOCATION)) {
        return ", at " + variable.get();
      }
    }
    return "";
  }

  /** Links that record why the last one could not be opened. */
  private static final class RecordingLinks implements ByteLink.Source {
    private final ByteLink.Source source;
    private volatile @Nullable IOException problem;

    RecordingLinks(ByteLink.Source source) {
      this.source = source;
    }

    @Nullable IOException problem() {
      return problem;
    }

    @Override
    public ByteLink open() throws IOException {
      try {
        ByteLink link = source.open();
        problem = null;
        return link;
      } catch (IOException e) {
        problem = e;
        throw e;
      }
    }
  }
}
