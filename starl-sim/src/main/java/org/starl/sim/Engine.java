// Longer than 500 lines because it answers what directors, faults and robots may ask of a run.
package org.starl.sim;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.RobotRunner;
import org.starl.body.MotionParameters;
import org.starl.body.RobotType;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.platform.StartNeeds;
import org.starl.random.Rng;
import org.starl.sim.fault.FaultRun;
import org.starl.sim.fault.FaultTarget;
import org.starl.sim.fault.Impairment;
import org.starl.sim.fault.Impairments;
import org.starl.sim.fault.RobotClock;
import org.starl.sim.kernel.Kernel;
import org.starl.sim.kernel.RobotError;
import org.starl.sim.net.SimNetwork;
import org.starl.sim.world.Body;
import org.starl.sim.world.MeasuredRobots;
import org.starl.sim.world.SimStable;
import org.starl.sim.world.Unsynced;
import org.starl.sim.world.World;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent.Fault;

/** One run: connects kernel, world, network and robots. Used for one call of {@link #run}. */
final class Engine implements SimControl, FaultTarget, AutoCloseable {

  final SimulationPlan plan;
  private final Rng.Redraw redraw = new Rng.Redraw();
  private final Rng behaviourRng;
  private final Kernel kernel;
  private final RunObservers observers;
  private final World world;
  private final SimNetwork network;
  // Null if radios have no limits.
  private final @Nullable RadioField radioField;
  private final @Nullable OrderObserver order;
  private final Participants deployment;
  private final StartNeedsCheck startNeeds;
  private final Obstacles knownObstacles;
  // Shared by all robots, of which there may be thousands.
  private final Map<RobotType, MotionParameters> motions = new EnumMap<>(RobotType.class);
  private final Map<RobotId, SimRobot> robots = new LinkedHashMap<>();
  // Data of robots that left: a robot that joins again is a new incarnation with its stored data.
  private final Map<RobotId, SimStable> stables = new LinkedHashMap<>();
  final RunSessions sessions;
  private final Map<RobotId, RobotClock> clocks = new LinkedHashMap<>();
  private final MeasuredRobots measuredRobots = new MeasuredRobots();
  private final Impairments impairments = new Impairments();
  private final SortedMap<RobotId, List<Object>> results = new TreeMap<>();
  // The number of running apps and planned restarts, for which the run waits.
  private int running;
  private int restartsDue;
  private int joined;

  Engine(SimulationPlan plan) {
    this.plan = plan;
    sessions = new RunSessions(plan.key());
    behaviourRng = new Rng(plan.header().behaviourSeed(), redraw);
    kernel = new Kernel(plan.carriers());
    observers =
        new RunObservers(
            Monitors.of(plan.monitors(), plan.specs()),
            plan.observers(),
            this::diagnosis,
            plan.commands());
    SimSettings settings = plan.settings();
    world = new World(kernel, kernel::timer, observers, settings.worldLimits(), plan.obstacles());
    network = new SimNetwork(kernel, observers, behaviourRng.fork("network"));
    network.base(settings.messageDelay(), settings.messageLoss());
    radioField = RadioField.of(settings, world);
    if (radioField != null) {
      network.limit(radioField);
    }
    order = plan.orderObserver();
    network.watch(order);
    deployment = plan.deployment();
    startNeeds = new StartNeedsCheck(plan, this::moveStarts);
    knownObstacles = plan.obstacles().known();
  }

  SimResult run() {
    observers.started(plan.header());
    try {
      plan.robots().forEach(this::join);
      plan.settings().get(Setting.REDRAWS).install(this, redraw);
      FaultRun faultRun = plan.faults().install(this, behaviourRng.fork("faults"));
      Director director = plan.director();
      if (director != null) {
        director.direct(this);
      }
      StepListener listener = plan.stepListener();
      if (listener == null) {
        kernel.run(plan.endNs(), this::isOver);
      } else {
        runStepwise(
            listener, new EngineController(this, faultRun, behaviourRng.fork("interventions")));
      }
    } catch (BadInput e) {
      throw e;
    } catch (RobotError e) {
      throw e.getCause() instanceof UnmetNeeds unmet
          ? new BadInput(String.valueOf(unmet.getMessage()))
          : told(e, List.of(new RobotId(e.strand())));
    } catch (RuntimeException e) {
      throw told(e, List.of());
    }
    SpecReport spec = observers.endSpecifications(kernel.nowNs());
    Diagnosis diagnosis = diagnosis(List.of());
    Failure failure = observers.failure(unfinished(), diagnosis, kernel.nowNs());
    SimResult result =
        new SimResult(
            plan.header().scenarioSeed(),
            plan.header().behaviourSeed(),
            kernel.nowNs(),
            kernel.events(),
            results,
            unfinished(),
            network.statistics(),
            world.collisions(),
            spec,
            diagnosis,
            observers.diagnoses(),
            observers.faults(),
            failure);
    observers.finished(result);
    return result;
  }

  private void runStepwise(StepListener listener, EngineController controller) {
    listener.onStep(controller);
    if (!controller.isStopped()) {
      kernel.run(
          plan.endNs(),
          () -> {
            listener.onStep(controller);
            return controller.isStopped() || isOver();
          });
    }
  }

  private boolean isOver() {
    if (order != null) {
      order.ran(kernel.nowNs(), kernel.lastStrand());
    }
    Director director = plan.director();
    return running == 0 && restartsDue == 0 && (director == null || director.isOver());
  }

  /**
   * Ends the run from another thread: it goes no further than the current action, which may have
   * no end.
   *
   * @return the failure of the run
   */
  SimulationFailed abandon(RuntimeException error) {
    kernel.abandon();
    return failed(error);
  }

  private SimulationFailed failed(RuntimeException cause) {
    return new SimulationFailed(
        "%s, seed %s: %s%s"
            .formatted(
                plan.header().scenario(),
                plan.header().scenarioSeed(),
                what(cause),
                observers.firstViolation()),
        cause);
  }

  private String what(RuntimeException cause) {
    // Without robot and time: an exception of the world, a director or an observer.
    return cause instanceof RobotError
        ? String.valueOf(cause.getMessage())
        : "at " + kernel.nowNs() + " ns: " + cause;
  }

  /** Tells the observers of the error that ends the run. */
  private SimulationFailed told(RuntimeException cause, List<RobotId> culprits) {
    observers.failed(culprits, what(cause), kernel.nowNs());
    return failed(cause);
  }

  private List<RobotId> unfinished() {
    List<RobotId> unfinished = new ArrayList<>();
    robots.forEach((id, robot) -> {
      if (robot.isAwaited()) {
        unfinished.add(id);
      }
    });
    return unfinished;
  }

  /**
   * @param important robots to explain in any case
   */
  private Diagnosis diagnosis(List<RobotId> important) {
    return Diagnosis.of(Diagnosis.Moment.of(kernel.nowNs(), kernel.isIdle(), robots, important));
  }

  private Diagnosis diagnosis(SpecReport.Violation violation) {
    if (violation.isOverdue()) {
      return diagnosis(violation.robots());
    }
    return Diagnosis.ofViolation(
        violation.robots().stream()
            .map(robots::get)
            .filter(robot -> robot != null && !robot.isDown() && robot.isAwaited())
            .map(SimRobot::explain)
            .toList());
  }

  @Override
  public void close() {
    try {
      kernel.close();
    } catch (RobotError e) {
      throw failed(e);
    }
  }

  @Override
  public long nowNs() {
    return kernel.nowNs();
  }

  @Override
  public long events() {
    return kernel.events();
  }

  @Override
  public void at(long atNs, Runnable action) {
    kernel.schedule(Math.max(atNs, kernel.nowNs()), action);
  }

  @Override
  public Rng scenarioRng(String name) {
    return new Rng(plan.header().scenarioSeed()).fork(name);
  }

  @Override
  public void join(RobotSpec spec) {
    if (spec.id().equals(Fault.WORLD)) {
      throw new BadInput("no robot can have the name " + Fault.WORLD);
    }
    if (robots.containsKey(spec.id())) {
      throw new BadInput("robot " + spec.id() + " has already joined");
    }
    SimStable stable =
        stables.computeIfAbsent(
            spec.id(), id -> new SimStable(kernel, plan.settings().stableDelayNs()));
    SimRobot robot = new SimRobot(spec, this, stable, joined);
    joined++;
    robots.put(spec.id(), robot);
    running++;
    placeRadio(spec.id(), null);
    if (spec.onFloor() && !putOnFloor(spec.id())) {
      throw new BadInput("robot " + spec.id() + ": its start " + spec.start() + " is not free");
    }
    robot.start();
  }

  /** Called by the first program of each robot, before or after its first fix. */
  void require(StartNeeds needs) {
    startNeeds.require(needs, robots.values());
  }

  /** Moves all bodies to other starts, before any program has had a fix. */
  void moveStarts(List<RobotSpec> starts) {
    starts.forEach(start -> takeOffFloor(start.id()));
    for (RobotSpec start : starts) {
      robot(start.id()).startAt(start.start());
      if (start.onFloor() && !putOnFloor(start.id())) {
        throw new UnmetNeeds(
            "robot " + start.id() + ": its start " + start.start() + " is not free");
      }
    }
  }

  @Override
  public void leave(RobotId id) {
    SimRobot robot = robot(id);
    takeOffFloor(id);
    if (!robot.isDown()) {
      end(robot, false);
    }
    robots.remove(id);
  }

  @Override
  public List<RobotId> robots() {
    return List.copyOf(robots.keySet());
  }

  @Override
  public boolean isUp(RobotId id) {
    SimRobot robot = robots.get(id);
    return robot != null && !robot.isDown();
  }

  @Override
  public int unflushed(RobotId id) {
    SimRobot robot = robots.get(id);
    return robot == null ? 0 : robot.unflushed();
  }

  @Override
  public boolean isRareUnflushed(RobotId id) {
    SimRobot robot = robots.get(id);
    return robot != null && robot.isRareUnflushed();
  }

  @Override
  public void crash(RobotId id) {
    crash(robot(id), false);
  }

  @Override
  public void crash(RobotId id, long downNs, Unsynced unsynced) {
    SimRobot crashed = robot(id);
    crash(crashed, true);
    restartsDue++;
    at(
        nowNs() + downNs,
        () -> {
          restartsDue--;
          if (robots.get(id) == crashed) {
            restart(id, unsynced);
          }
        });
  }

  private void crash(SimRobot robot, boolean willRestart) {
    RobotId id = robot.spec().id();
    if (robot.isDown()) {
      throw new IllegalStateException(id + " has already crashed");
    }
    recordFault(id, Fault.CRASH, "", "");
    end(robot, willRestart);
  }

  @Override
  public void restart(RobotId id, Unsynced unsynced) {
    SimRobot crashed = robot(id);
    if (!crashed.isDown()) {
      throw new IllegalStateException(id + " is up: only a crashed robot restarts");
    }
    recordFault(id, Fault.RESTART, "", unsynced.name().toLowerCase(Locale.ROOT));
    SimRobot robot = crashed.nextIncarnation(unsynced);
    robots.put(id, robot);
    results.remove(id);
    running++;
    robot.start();
  }

  private void end(SimRobot robot, boolean willRestart) {
    network.detach(robot.spec().id());
    if (!robot.isFinished()) {
      running--;
    }
    robot.end(willRestart);
  }

  @Override
  public void recordFault(RobotId robot, String name, String effect, String detail) {
    if (observers.isOn()) {
      observers.record(new Fault(nowNs(), robot, name, effect, detail));
    }
  }

  /** Called on the strand of robot {@code id} when its app has ended. */
  void appEnded(RobotId id, RobotRunner runner) {
    List<Object> result = runner.results();
    if (result == null) {
      throw new IllegalStateException(id + " ended without results");
    }
    results.put(id, result);
    running--;
  }

  @Override
  public boolean putOnFloor(RobotId id) {
    SimRobot robot = robot(id);
    if (robot.isOnFloor()) {
      throw new IllegalStateException(id + " is already on the floor");
    }
    Pose start = robot.spec().start();
    if (!isFree(start)) {
      return false;
    }
    Body body = world.add(id, start, plan.settings().robotRadiusMm(), network.number(id));
    robot.putOnFloor(body);
    placeRadio(id, body);
    return true;
  }

  private void placeRadio(RobotId id, @Nullable Body body) {
    if (radioField != null) {
      radioField.place(network.number(id), body);
    }
  }

  @Override
  public boolean isFree(Pose pose) {
    return !plan.settings().worldLimits().collisions()
        || world.isFree(pose, plan.settings().robotRadiusMm());
  }

  @Override
  public void takeOffFloor(RobotId id) {
    robot(id).takeOffFloor(world);
    placeRadio(id, null);
  }

  @Override
  public boolean isOnFloor(RobotId id) {
    return robot(id).isOnFloor();
  }

  @Override
  public boolean isKnown(RobotId id) {
    return stables.containsKey(id);
  }

  @Override
  public World world() {
    return world;
  }

  @Override
  public @Nullable Body body(RobotId id) {
    SimRobot robot = robots.get(id);
    return robot != null && robot.isOnFloor() ? robot.body() : null;
  }

  @Override
  public Runnable impair(@Nullable RobotId id, Impairment impairment) {
    impairments.add(id, impairment);
    impairmentsChanged(id);
    return () -> {
      impairments.remove(id, impairment);
      impairmentsChanged(id);
    };
  }

  private void impairmentsChanged(@Nullable RobotId id) {
    robots.forEach((robotId, robot) -> {
      if ((id == null || id.equals(robotId)) && !robot.isDown()) {
        robot.applyImpairment(impairments.total(robotId));
      }
    });
  }

  Impairment impairmentOf(RobotId id) {
    return impairments.total(id);
  }

  /** The robot's own clock if faults may change its time; otherwise null. */
  @Nullable RobotClock clockOf(RobotId id) {
    boolean mayChange = plan.faults().changesTime() || plan.stepListener() != null;
    return mayChange ? clocks.computeIfAbsent(id, any -> new RobotClock(kernel)) : null;
  }

  @Override
  public Pose truePose(RobotId id) {
    return robot(id).body().pose();
  }

  @Override
  public boolean isFinished(RobotId id) {
    return robot(id).isFinished();
  }

  @Override
  public SimNetwork network() {
    return network;
  }

  Kernel kernel() {
    return kernel;
  }

  /** All robots that have joined since the start of the run. */
  Set<RobotId> known() {
    return stables.keySet();
  }

  /** Passes a point to a robot's app; does nothing if the robot is down or has left. */
  void point(RobotId id, int xMm, int yMm) {
    SimRobot robot = robots.get(id);
    if (robot != null && !robot.isDown()) {
      robot.point(xMm, yMm);
    }
  }

  SimSettings settings() {
    return plan.settings();
  }

  RunObservers observers() {
    return observers;
  }

  Participants deployment() {
    return deployment;
  }

  /** The motion parameters of robot number {@code index}, unless its app sets others. */
  MotionParameters motionParameters(int index) {
    return motions.computeIfAbsent(
        plan.settings().robotType(index, plan.robots().size()), plan.settings()::motionParameters);
  }

  MeasuredRobots measuredRobots() {
    return measuredRobots;
  }

  List<ItemPosition> waypoints() {
    return plan.waypoints();
  }

  Obstacles knownObstacles() {
    return knownObstacles;
  }

  /** What stays the same for {@code robot} in all its incarnations, also after a redraw. */
  Rng lastingRng(RobotId robot) {
    return new Rng(plan.header().behaviourSeed()).fork(robot.name());
  }

  /** The generator of all random numbers of {@code robot}. */
  Rng behaviourRng(RobotId robot) {
    return behaviourRng.fork(robot.name());
  }

  private SimRobot robot(RobotId id) {
    SimRobot robot = robots.get(id);
    if (robot == null) {
      throw new IllegalArgumentException("there is no robot " + id);
    }
    return robot;
  }
}
