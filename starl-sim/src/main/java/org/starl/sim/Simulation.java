package org.starl.sim;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.RobotApp;
import org.starl.Version;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.platform.DeploymentKey;
import org.starl.random.Rng;
import org.starl.sim.fault.Envelope;
import org.starl.sim.fault.FaultGrammar;
import org.starl.sim.fault.FaultPlan;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.world.FloorObjects;
import org.starl.sim.world.WaypointFiles;
import org.starl.spec.Authentic;
import org.starl.spec.Monitor;
import org.starl.spec.Specs;
import org.starl.trace.TraceHeader;

/**
 * A simulation: robots, a world, and a seed that determines everything. Built once, run once.
 *
 * <pre>{@code
 * SimResult result = Simulation.builder().robots(4, Hello::new).seed(42).build().run();
 * }</pre>
 *
 * <p>Equal builders give equal runs, event by event, on every JVM. A simulation runs on a thread of
 * its own, for which {@link #run} waits; several simulations are independent.
 */
public final class Simulation {

  private static final int DEFAULT_ACTION_LIMIT_S = 10;

  /** A robot suspects another one of a crash after so long. */
  private static final Duration USUAL_TIMEOUT = Duration.ofSeconds(10);

  private final SimulationPlan plan;

  private Simulation(SimulationPlan plan) {
    this.plan = plan;
  }

  public static Builder builder() {
    return new Builder();
  }

  /** The plan of the run. */
  public SimulationPlan plan() {
    return plan;
  }

  /**
   * All faults of the run: those of the settings, then those drawn by chaos. The same run results
   * from these faults without chaos, sealed if chaos was hostile.
   */
  public FaultPlan faults() {
    return plan.faults();
  }

  /**
   * Runs until every app has ended, or until the time limit of the settings. The apps, the
   * director and the observers are called on a thread of the run, not on the calling thread.
   *
   * @throws SimulationFailed if an app, a handler or the simulator itself threw, or if virtual time
   *     stands still ({@link org.starl.sim.kernel.Stalled})
   */
  public SimResult run() {
    return new GuardedRun(new Engine(plan), plan.actionLimitNs()).run();
  }

  /**
   * Runs on the calling thread, for measurements of its processor time: as {@link #run}, but an
   * action that does not end is not noticed.
   */
  public SimResult runOnThisThread() {
    try (Engine engine = new Engine(plan)) {
      return engine.run();
    }
  }

  /** Collects the parts of a simulation. */
  public static final class Builder {

    private String name = "app";
    private SimSettings settings = SimSettings.defaults();
    private long seed;
    private @Nullable Long behaviourSeed;
    private CarrierKind carriers = CarrierKind.best();
    private Obstacles obstacles = Obstacles.NONE;
    private @Nullable FloorObjects objects;
    private List<ItemPosition> waypoints = List.of();
    private @Nullable Director director;
    private @Nullable StepListener stepListener;
    private Supplier<List<String>> commands = List::of;
    private FaultPlan faults = FaultPlan.NONE;
    private @Nullable Long endNs;
    private Duration actionLimit = Duration.ofSeconds(DEFAULT_ACTION_LIMIT_S);
    private Duration timeout = USUAL_TIMEOUT;
    private final List<RobotSpec> robots = new ArrayList<>();
    private final List<SimObserver> observers = new ArrayList<>();
    private final List<Supplier<? extends Monitor>> monitors = new ArrayList<>();
    private Specs specs = Specs.ALL;
    private final SortedMap<String, String> parameters = new TreeMap<>();
    private boolean isCountGiven = true;
    private @Nullable Function<GlobalVarHolder, ? extends RobotApp> placedApp;
    private int placed;

    private Builder() {}

    /** The app's or scenario's name, for trace headers and messages. */
    public Builder name(String newName) {
      name = newName;
      return this;
    }

    /** Adds {@code count} robots {@code bot0}, {@code bot1}, ... at free places drawn by seed. */
    public Builder robots(int count, Function<GlobalVarHolder, ? extends RobotApp> app) {
      if (count < 0) {
        throw new BadInput("robots: " + count + ": expected 0 or more");
      }
      placed = count;
      placedApp = app;
      return this;
    }

    public Builder robot(RobotSpec robot) {
      robots.add(robot);
      return this;
    }

    public Builder settings(SimSettings newSettings) {
      settings = newSettings;
      return this;
    }

    /** The settings so far. */
    public SimSettings settings() {
      return settings;
    }

    /** Seed of the scenario (places, routes, arrivals) and, unless set separately, of behaviour. */
    public Builder seed(long newSeed) {
      seed = newSeed;
      return this;
    }

    /** Seed of behaviour: delays, losses, noise, the robots' own draws. */
    public Builder behaviourSeed(long newSeed) {
      behaviourSeed = newSeed;
      return this;
    }

    public Builder carriers(CarrierKind kind) {
      carriers = kind;
      return this;
    }

    public Builder obstacles(Obstacles newObstacles) {
      obstacles = newObstacles;
      return this;
    }

    /** The obstacles so far; those of the obstacle file are added by {@link #build}. */
    public Obstacles obstacles() {
      return obstacles;
    }

    /**
     * Gives every robot an object sensor, {@code gvh.plat.objects}. So it also declares that the app
     * needs one: {@code starl deploy check} asks for sensors of that range on robots.
     *
     * @param rangeMm of the sensor, above 0
     * @param objects with different names; may be none
     */
    public Builder objects(double rangeMm, List<ItemPosition> objects) {
      this.objects = new FloorObjects(objects, rangeMm);
      return this;
    }

    /**
     * Sets the floor's waypoints, which every robot reads by {@code gvh.gps.getWaypointPositions()}.
     *
     * @throws BadInput if two have one name
     */
    public Builder waypoints(List<ItemPosition> newWaypoints) {
      Set<String> names = new TreeSet<>();
      for (ItemPosition waypoint : newWaypoints) {
        if (!names.add(waypoint.name())) {
          throw new BadInput(
              "waypoints: two are called "
                  + BadInput.quote(waypoint.name())
                  + ": expected names that differ");
        }
      }
      waypoints = List.copyOf(newWaypoints);
      return this;
    }

    public Builder director(Director newDirector) {
      director = newDirector;
      return this;
    }

    /** Sets the step listener, which may pause the run and intervene. */
    public Builder stepListener(StepListener newListener) {
      stepListener = newListener;
      return this;
    }

    /**
     * Sets the processor time that one action may use, {@value DEFAULT_ACTION_LIMIT_S} s unless
     * set. A longer action fails the run: the code between two waits should take milliseconds.
     */
    public Builder actionLimit(Duration cpu) {
      if (cpu.isNegative() || cpu.isZero()) {
        throw new BadInput("action limit " + cpu + ": expected above 0");
      }
      actionLimit = cpu;
      return this;
    }

    /**
     * Ends the run at {@code newEndNs} at the latest, instead of after the duration of the
     * settings: for a scenario in which the duration has another meaning.
     */
    public Builder endNs(long newEndNs) {
      endNs = newEndNs;
      return this;
    }

    /**
     * Adds a fault as text: {@code crash(bot2,at=12s,restart=5s)}.
     *
     * @throws BadInput if {@code fault} is not one
     */
    public Builder fault(String fault) {
      return faults(new FaultPlan(List.of(FaultGrammar.parse(fault))));
    }

    /** Adds faults to those of the settings. */
    public Builder faults(FaultPlan plan) {
      faults = faults.plus(plan);
      return this;
    }

    /**
     * Sets the longest timeout of the protocols that the robots use, 10 s unless set: chaos also
     * draws outages that last longer.
     *
     * @param longest zero if there is none: then chaos draws no outages
     */
    public Builder timeout(Duration longest) {
      timeout = longest;
      return this;
    }

    public Builder observer(SimObserver observer) {
      observers.add(observer);
      return this;
    }

    /**
     * Adds a specification to check throughout the run; the supplier creates a monitor for each
     * run.
     */
    public Builder monitor(Supplier<? extends Monitor> monitor) {
      monitors.add(monitor);
      return this;
    }

    /** Checks only these specifications of those added; all of them unless set. */
    public Builder specs(Specs newSpecs) {
      specs = newSpecs;
      return this;
    }

    /** Adds a parameter of the scenario to the trace's header: a replay must set it. */
    public Builder parameter(String key, String value) {
      parameters.put(key, value);
      return this;
    }

    /**
     * Declares that the scenario, not the settings, decides the number of robots: the number is
     * omitted from the trace's header, so that the scenario decides again in a replay.
     */
    public Builder countedByScenario() {
      isCountGiven = false;
      return this;
    }

    /**
     * Sets the command lines that repeat the run and shrink it, each with a word before it: the
     * description of a failure has them.
     */
    public Builder commands(Supplier<List<String>> lines) {
      commands = lines;
      return this;
    }

    /**
     * Builds the simulation. A builder may be used once, because its observers and director have
     * state.
     *
     * @throws BadInput if the settings are inconsistent, their files cannot be read, the robots do
     *     not fit on the floor, or a fault names a robot that does not exist and cannot join
     */
    public Simulation build() {
      SimSettings all = settings.with(Setting.FAULTS, settings.get(Setting.FAULTS).plus(faults));
      Obstacles floor = floor();
      Starts starts = new Starts(all, robots, placed, placedApp, floor, new Rng(seed));
      Contradictions.check(all, starts, robots.size() + placed, endNs());
      List<RobotSpec> start = starts.initial();
      starts.check(start);
      List<RobotId> deployment = SimulationPlan.deployment(start).asList();
      if (director == null) {
        // With a director more robots may join: names are then checked when a fault begins.
        all.get(Setting.FAULTS).requireNamedAmong(deployment);
      }
      TraceHeader header =
          new TraceHeader(
              Version.STARL, name, seed, behaviourSeedOrDerived(), headerSettings(all), deployment);
      return new Simulation(
          new SimulationPlan(
              header,
              all,
              carriers,
              floor,
              objects,
              waypoints,
              key(),
              start,
              starts.areDrawn() ? starts::spaced : null,
              director,
              stepListener,
              all.get(Setting.FAULTS).plus(chaos(start.size())),
              endNs(),
              actionLimit.toNanos(),
              allMonitors(),
              specs,
              observers,
              commands));
    }

    /** All obstacles, including those of the obstacle file. */
    private Obstacles floor() {
      Obstacles floor = obstacles;
      String file = settings.get(Setting.OBSTACLE_FILE);
      if (!file.isEmpty()) {
        for (Obstacle obstacle : WaypointFiles.obstacles(Path.of(file)).all()) {
          floor = floor.plus(obstacle);
        }
      }
      return floor;
    }

    /** The seed of everything except the scenario. */
    private long behaviourSeedOrDerived() {
      return behaviourSeed != null ? behaviourSeed : TraceHeader.behaviourSeedOf(seed);
    }

    private FaultPlan chaos(int count) {
      Rng rng = new Rng(behaviourSeedOrDerived()).fork("chaos");
      return FaultPlan.chaos(
          settings.get(Setting.CHAOS),
          key() != null,
          count,
          timeout.toNanos(),
          settings.chaosEndNs(),
          rng);
    }

    /** With the one of sealed datagrams, if they are sealed. */
    private List<Supplier<? extends Monitor>> allMonitors() {
      List<Supplier<? extends Monitor>> all = new ArrayList<>(monitors);
      if (key() != null) {
        all.add(Authentic::new);
      }
      return all;
    }

    /** The key that seals the run's datagrams, or null. */
    private @Nullable DeploymentKey key() {
      boolean isHostile = settings.get(Setting.CHAOS) == Envelope.HOSTILE;
      if (!isHostile && !settings.get(Setting.SEALED)) {
        return null;
      }
      Rng rng = new Rng(seed).fork("key");
      byte[] secret = new byte[DeploymentKey.BYTES];
      for (int i = 0; i < secret.length; i++) {
        secret[i] = (byte) rng.nextInt(256);
      }
      return new DeploymentKey(secret);
    }

    private Map<String, String> headerSettings(SimSettings all) {
      Map<String, String> text = new LinkedHashMap<>(parameters);
      text.putAll(all.asText());
      if (!isCountGiven) {
        text.remove(Setting.ROBOTS.key());
      }
      return text;
    }

    /** The latest end of the run, in ns of virtual time. */
    public long endNs() {
      return endNs == null ? settings.endNs() : endNs;
    }
  }
}
