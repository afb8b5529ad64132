package org.starl.sim;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.RobotApp;
import org.starl.RobotRunner;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.gvh.Wait;
import org.starl.motion.Deviation;
import org.starl.motion.Location;
import org.starl.platform.Light;
import org.starl.platform.Platform;
import org.starl.platform.Strand;
import org.starl.random.Rng;
import org.starl.sim.fault.ImpairedStrand;
import org.starl.sim.fault.Impairment;
import org.starl.sim.fault.RobotClock;
import org.starl.sim.kernel.Kernel;
import org.starl.sim.kernel.SimBackground;
import org.starl.sim.kernel.SimStrand;
import org.starl.sim.world.Body;
import org.starl.sim.world.SimChassis;
import org.starl.sim.world.SimObjects;
import org.starl.sim.world.SimPositioning;
import org.starl.sim.world.SimStable;
import org.starl.sim.world.Unsynced;
import org.starl.sim.world.World;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceSink;

/**
 * One robot of a run in one incarnation: its program on a simulated platform, and its body while on
 * the floor. It also is the program's trace sink: a program that is unwound writes no more events.
 */
final class SimRobot implements TraceSink {

  /** With fewer robots the app's objects stay in the processor's cache. */
  private static final int MANY = 1000;

  /** A change of a belief's error is traced if it is larger: a picture shows no smaller one. */
  private static final double SHOWN_MM = 25;

  private RobotSpec spec;
  private final int index;
  private final int incarnation;
  private final SimStable stable;
  private final SimStrand strand;
  private final SimChassis chassis;
  private final SimPositioning positioning;
  // Null if no fault affects time: the robot then uses the kernel's clock and its own strand.
  private final @Nullable RobotClock clock;
  private final @Nullable ImpairedStrand impaired;
  private final RobotRunner runner;
  private final Engine engine;
  private boolean finished;
  private boolean willRestart;
  private long changedNs;
  private @Nullable Body body;
  private Deviation deviation = Deviation.NONE;
  // Whether fixes may be wrong by so much that it is traced.
  private boolean mayDeviate;

  /**
   * Creates the first incarnation since the robot joined.
   *
   * @param stable the robot's stable storage, kept if it left before
   * @param index number of robots that joined earlier
   */
  SimRobot(RobotSpec spec, Engine engine, SimStable stable, int index) {
    this(spec, engine, stable, index, 1, 0);
  }

  private SimRobot(
      RobotSpec spec,
      Engine engine,
      SimStable stable,
      int index,
      int incarnation,
      int survivingWrites) {
    this.spec = spec;
    this.engine = engine;
    this.index = index;
    this.incarnation = incarnation;
    this.stable = stable;
    SimSettings settings = engine.settings();
    Kernel kernel = engine.kernel();
    Rng robotRng = engine.behaviourRng(spec.id());
    // Each incarnation has its own random numbers; the positioning system is external and
    // continues.
    Rng rng = incarnation == 1 ? robotRng : robotRng.fork("incarnation" + incarnation);
    strand = kernel.strand(spec.id().name());
    clock = engine.clockOf(spec.id());
    impaired = clock == null ? null : new ImpairedStrand(strand, clock, kernel);
    long reactionNs = settings.get(Setting.REACTION).toNanos();
    chassis =
        new SimChassis(strand, rng.fork("chassis"), settings.speedError(), kernel, reactionNs);
    positioning = positioning(settings, kernel, rng);
    if (incarnation == 1) {
      positioning.onNeeds(engine::require);
    }
    stable.restart(strand, survivingWrites);
    Platform platform =
        new Platform(
            spec.id(),
            engine.deployment(),
            clock == null ? kernel : clock,
            impaired == null ? strand : impaired,
            impaired == null ? strand : impaired,
            engine.network().attach(spec.id(), strand, impaired == null ? null : impaired::pass),
            positioning,
            chassis,
            SimObjects.of(engine.plan.objects(), engine.world(), () -> body),
            Light.SIMULATED,
            stable,
            rng::fork,
            new SimBackground(kernel, strand, settings.computeTimeNs()),
            engine.observers().logOf(spec.id()),
            // Without log observers all robots share one sink, which stays in the processor's
            // cache.
            engine.observers().isOn() ? this : engine.observers(),
            engine.knownObstacles(),
            engine.waypoints(),
            engine.motionParameters(index),
            engine.sessions.started(spec.id()));
    runner = new RobotRunner(platform, this::makeApp, this::appEnded);
    mayDeviate = settings.positionNoise().boundMm() > SHOWN_MM / 2;
    if (engine.observers().isOn()) {
      // Between two fixes nothing but its bound keeps a belief true.
      positioning.aroundFix(
          () -> traceDeviation(Double.MAX_VALUE),
          () -> {
            if (mayDeviate) {
              traceDeviation(SHOWN_MM);
            }
          });
    }
    Impairment impairment = engine.impairmentOf(spec.id());
    if (impairment.equals(Impairment.NONE)) {
      positioning.setOffset(0 - spec.origin().xMm(), 0 - spec.origin().yMm());
      // A fault may have ended while the program was down.
      applyToStorageAndClock(impairment);
    } else {
      applyImpairment(impairment);
    }
  }

  /**
   * Traces how far the program's belief is from the truth, if that has changed by more than {@code
   * leastMm}, or if it has become false or true.
   */
  private void traceDeviation(double leastMm) {
    GlobalVarHolder gvh = runner.gvh();
    Body at = body;
    if (gvh != null
        && at != null
        && gvh.gps.currentlocation().get() instanceof Location.Known belief) {
      Pose truth = at.pose();
      Point place = truth.at().minus(spec.origin());
      Deviation now = Deviation.of(belief, Pose.of(place, truth.headingRad()));
      if (now.differs(deviation, leastMm)) {
        deviation = now;
        engine
            .observers()
            .record(
                new TraceEvent.Variable(
                    engine.nowNs(), spec.id(), Deviation.SOURCE, Deviation.VAR, now));
      }
    }
  }

  private RobotApp makeApp(GlobalVarHolder gvh) {
    RobotApp app = spec.app().apply(gvh);
    strand.prefetch(gvh.comms, gvh.comms.lamportClock(), app);
    if (engine.deployment().size() >= MANY) {
      strand.prefetch(AppFields.of(app));
    }
    return app;
  }

  private SimPositioning positioning(SimSettings settings, Kernel kernel, Rng incarnationRng) {
    long periodNs = settings.positionPeriodNs();
    long phaseNs =
        settings.get(Setting.POSITION_IN_PHASE)
            ? 0
            : SimPositioning.drawnPhaseNs(
                engine.lastingRng(spec.id()).fork("positioning"), periodNs);
    Rng noise = incarnationRng.fork("positioning");
    return new SimPositioning(
        spec.id(),
        engine.measuredRobots(),
        kernel,
        clock == null ? kernel : clock,
        strand,
        noise,
        settings.positionNoise(),
        periodNs,
        phaseNs);
  }

  /** Sets the impairment of its parts. */
  void applyImpairment(Impairment impairment) {
    mayDeviate = true;
    chassis.impair(impairment.wheels(), impairment.wheels());
    positioning.setNoise(impairment.noise());
    positioning.setOffset(
        impairment.offXMm() - spec.origin().xMm(), impairment.offYMm() - spec.origin().yMm());
    positioning.turn(!impairment.isBlind());
    applyToStorageAndClock(impairment);
  }

  /** Sets the impairment of the parts that outlast a crash of the program. */
  private void applyToStorageAndClock(Impairment impairment) {
    stable.setFlushDelay(engine.settings().stableDelayNs() + impairment.diskNs());
    if (impaired != null) {
      impaired.apply(impairment);
    }
  }

  RobotSpec spec() {
    return spec;
  }

  /** Sets the pose at which its body is put on the floor. */
  void startAt(Pose start) {
    spec = new RobotSpec(spec.id(), start, spec.onFloor(), spec.app(), spec.origin());
  }

  /** Whether its program has had a position fix. */
  boolean hasFix() {
    return positioning.hasMeasured();
  }

  void start() {
    runner.start();
  }

  /**
   * Ends the program: it runs no more code, and its unwinding has no effect. Its body stays in
   * place, at rest.
   *
   * @param newWillRestart whether a restart is planned
   */
  void end(boolean newWillRestart) {
    willRestart = newWillRestart;
    chassis.halt();
    positioning.unmount();
    stable.halt();
    strand.close();
  }

  /** Whether the program has ended because the robot crashed or left. */
  boolean isDown() {
    return strand.isClosed();
  }

  /** The number of its writes that a crash would lose now. */
  int unflushed() {
    return stable.unflushed();
  }

  boolean isRareUnflushed() {
    return stable.isRareUnflushed();
  }

  /** Whether the run waits for the app to end; false after a permanent crash. */
  boolean isAwaited() {
    return !finished && (willRestart || !isDown());
  }

  /** Creates the next incarnation of this ended robot, not yet started. */
  SimRobot nextIncarnation(Unsynced unsynced) {
    int next = incarnation + 1;
    int survivingWrites =
        switch (unsynced) {
          case LOST -> 0;
          case KEPT -> stable.unflushed();
          case SOME ->
              (int)
                  engine
                      .behaviourRng(spec.id())
                      .fork("stable" + next)
                      .nextLong(0, stable.unflushed());
        };
    SimRobot robot = new SimRobot(spec, engine, stable, index, next, survivingWrites);
    if (body != null) {
      robot.putOnFloor(body);
    }
    return robot;
  }

  /** What its primitives wait for or hold. */
  List<Wait> waits() {
    GlobalVarHolder gvh = runner.gvh();
    return gvh == null ? List.of() : gvh.waits();
  }

  /** When a variable last changed; -1 if the run does not record it. */
  long changedNs() {
    return engine.observers().isOn() ? changedNs : -1;
  }

  /** The state of the app and of what it waits for. */
  UnfinishedRobot explain() {
    return UnfinishedRobot.of(
        spec.id(),
        runner,
        strand.appStack(),
        strand.isAppRunning(),
        strand.appWaitsSinceNs(),
        changedNs(),
        body == null ? List.of() : body.touches());
  }

  boolean isFinished() {
    return finished;
  }

  /** Passes a point to the app if it runs. */
  void point(int xMm, int yMm) {
    Strand own = impaired == null ? strand : impaired;
    own.post(() -> {
      RobotApp app = runner.app();
      if (app != null) {
        app.receivedPointInput(xMm, yMm);
      }
    });
  }

  boolean isOnFloor() {
    return body != null;
  }

  Body body() {
    if (body == null) {
      throw new IllegalStateException(spec.id() + " is not on the floor");
    }
    return body;
  }

  void putOnFloor(Body newBody) {
    body = newBody;
    if (!isDown()) {
      chassis.mount(newBody);
      positioning.mount(newBody);
    }
  }

  void takeOffFloor(World world) {
    if (body != null) {
      chassis.unmount();
      positioning.unmount();
      world.remove(body);
      body = null;
    }
  }

  @Override
  public boolean isOn() {
    return true; // it is the sink of runs with observers only
  }

  @Override
  public void record(TraceEvent event) {
    if (!isDown()) {
      if (event instanceof TraceEvent.Variable) {
        changedNs = engine.nowNs();
      }
      // A robot with a wrong clock stamps its events wrongly; the trace is in true time.
      engine.observers().record(clock == null ? event : event.at(engine.nowNs()));
    }
  }

  // An unwound app may return as if it had ended normally.
  private void appEnded() {
    if (!isDown()) {
      finished = true;
      engine.appEnded(spec.id(), runner);
    }
  }
}
