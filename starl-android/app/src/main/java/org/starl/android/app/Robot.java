package org.starl.android.app;

import java.io.IOException;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.GvhVariable;
import org.starl.RobotRunner;
import org.starl.deploy.create.ByteLink;
import org.starl.deploy.create.CreateChassis;
import org.starl.deploy.create.CreateHold;
import org.starl.deploy.create.CreateStatus;
import org.starl.deploy.optitrack.PoseFeed;
import org.starl.deploy.realtime.RealBackground;
import org.starl.deploy.realtime.RealClock;
import org.starl.deploy.realtime.RealStrand;
import org.starl.deploy.udp.FileStable;
import org.starl.deploy.udp.UdpRadio;
import org.starl.geometry.Fix;
import org.starl.geometry.Obstacles;
import org.starl.motion.Location;
import org.starl.platform.LogSink;
import org.starl.platform.Platform;
import org.starl.platform.Positioning;
import org.starl.platform.Timer;
import org.starl.platform.TraceSink;
import org.starl.random.Rng;
import org.starl.trace.TraceEvent;

/**
 * One robot on real ports, from {@link #open} to {@link #close}. Nothing here is Android's. All may
 * be called from any thread; opening and closing may take their time.
 */
final class Robot implements AutoCloseable {

  private static final long LOOK_EVERY_NS = 200_000_000;
  private static final String LOCATION = "location";

  /** Nobody listens: on a phone there is no place yet for traces. */
  private static final TraceSink NO_TRACE =
      new TraceSink() {
        @Override
        public boolean isOn() {
          return false;
        }

        @Override
        public void record(TraceEvent event) {
          throw new IllegalStateException("nobody asked for " + event);
        }
      };

  private final Mission mission;
  private final Consumer<Throwable> onBug;
  private final RealStrand strand;
  private final UdpRadio radio;
  private final FileStable stable;
  private final RealBackground background;
  private final PoseFeed feed;
  private final CreateChassis chassis;
  private final RobotRunner runner;
  private final Timer look;

  // What status() tells; written on the strand or a driver's thread, each by one alone.
  private volatile String appState = "starts";
  private volatile @Nullable Location location;
  private volatile @Nullable IOException linkProblem;
  private volatile @Nullable Throwable bug;

  private Robot(
      Mission mission,
      ByteLink.Source links,
      Path folder,
      LogSink log,
      Consumer<Throwable> onBug,
      Closer opened)
      throws IOException {
    this.mission = mission;
    this.onBug = onBug;
    String name = mission.robot().id().name();
    RealClock clock = new RealClock();
    strand = opened.add(new RealStrand(name, clock, this::failed));
    radio = opened.add(Ports.radio(mission, strand, this::failed));
    stable = opened.add(FileStable.open(folder, strand, this::failed));
    background = opened.add(new RealBackground(name, strand));
    feed = opened.add(Ports.feed(mission, clock, log));
    chassis =
        opened.add(
            CreateChassis.open(
                name, Ports.create(mission), links, strand, clock, new ChassisListener()));
    Rng rng = new Rng(new SecureRandom().nextLong());
    Platform platform =
        new Platform(
            mission.robot().id(),
            mission.deployment().participants(),
            clock,
            strand,
            strand,
            radio,
            seenByChassis(feed.positioning(strand, mission.robot().rigidBody())),
            chassis,
            stable,
            rng::fork,
            background,
            log,
            NO_TRACE,
            Obstacles.NONE,
            Ports.motion(mission.deployment().limits()),
            mission.key());
    runner = new RobotRunner(platform, mission.app(), this::appEnded);
    look = strand.timer(this::look);
  }

  /**
   * Brings the robot up and starts its app.
   *
   * @param links to the robot's wheels
   * @param folder of its stable storage, its alone
   * @param onBug is told what the robot cannot go on after; its wheels are stopped then
   * @throws IOException if a port of it is not to be had; nothing is left open
   */
  static Robot open(
      Mission mission, ByteLink.Source links, Path folder, LogSink log, Consumer<Throwable> onBug)
      throws IOException {
    Closer opened = new Closer();
    try {
      Robot robot = new Robot(mission, links, folder, log, onBug, opened);
      robot.strand.post(robot::look);
      robot.runner.start();
      return robot;
    } catch (IOException | RuntimeException e) {
      opened.close();
      throw e;
    }
  }

  Mission mission() {
    return mission;
  }

  /** Stops the wheels, and until {@link #release}, whatever the app wants. */
  void emergencyStop() {
    chassis.emergencyStop();
  }

  /** Takes the emergency stop back: the app drives on. */
  void release() {
    chassis.release();
  }

  RobotStatus status() {
    CreateStatus wheels = chassis.status();
    return new RobotStatus(
        mission.robot().id(),
        mission.deployment().app(),
        appState,
        location,
        wheels,
        linkProblem,
        radio.statistics(),
        strand.use(),
        bug);
  }

  /** Stops the wheels and ends the robot; again, it does nothing. */
  @Override
  public void close() {
    chassis.emergencyStop();
    // What the program still says goes nowhere; the chassis waits until the wheels were told.
    chassis.close();
    radio.close();
    feed.close();
    strand.close();
    background.close();
    stable.close();
  }

  /** The chassis must know of fixes: without them it stops the wheels. */
  private Positioning seenByChassis(Positioning positioning) {
    return receiver ->
        positioning.onFix(fix -> {
          passOn(fix);
          receiver.fixed(fix);
        });
  }

  private void passOn(Fix fix) {
    chassis.fixed(fix);
  }

  // On the strand.
  private void look() {
    GlobalVarHolder gvh = runner.gvh();
    if (gvh != null) {
      location = gvh.gps.location();
      if (!runner.isFinished()) {
        appState = "runs" + appLocation(gvh);
      }
    }
    look.set(gvh == null ? 0 : gvh.plat.clock.nowNs() + LOOK_EVERY_NS);
  }

  /** Where in its state machine the app is, as the paper's figures name it. */
  private static String appLocation(GlobalVarHolder gvh) {
    for (GvhVariable<?> variable : gvh.variables()) {
      if (variable.name().equals(LOCATION)) {
        return ", at " + variable.get();
      }
    }
    return "";
  }

  private void appEnded() {
    List<Object> results = runner.results();
    appState = "has ended: " + results;
  }

  // From any thread.
  private void failed(Throwable error) {
    bug = error;
    // A port may fail before there are wheels.
    if (chassis != null) {
      chassis.emergencyStop();
    }
    onBug.accept(error);
  }

  private final class ChassisListener implements CreateChassis.Listener {

    @Override
    public void changed(CreateStatus status) {
      if (!status.holds().contains(CreateHold.NO_LINK)) {
        linkProblem = null;
      }
    }

    @Override
    public void linkFailed(IOException cause) {
      linkProblem = cause;
    }

    @Override
    public void failed(Throwable error) {
      Robot.this.failed(error);
    }
  }
}
