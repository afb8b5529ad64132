package org.starl.sim;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.Version;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.platform.DeploymentKey;
import org.starl.random.Rng;
import org.starl.sim.fault.Envelope;
import org.starl.sim.fault.FaultGrammar;
import org.starl.sim.fault.FaultPlan;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.net.LinkRule;
import org.starl.sim.world.WaypointFiles;
import org.starl.spec.Monitor;
import org.starl.trace.TraceHeader;

/**
 * A simulation: robots, a world, and a seed that decides everything. Built once, run once.
 *
 * <pre>{@code
 * SimResult result = Simulation.builder().robots(4, Hello::new).seed(42).build().run();
 * }</pre>
 *
 * <p>Equal builders give equal runs, event by event, on every JVM. A simulation runs on the calling
 * thread; several may run at once on several threads, and share nothing.
 */
public final class Simulation {

  private final Builder plan;

  private Simulation(Builder plan) {
    this.plan = plan;
  }

  public static Builder builder() {
    return new Builder();
  }

  /** What it consists of; not what the rules for its datagrams are. */
  public Blueprint blueprint() {
    return new Blueprint(
        plan.header(),
        plan.settings,
        plan.obstacles,
        plan.key(),
        plan.robots,
        plan.director,
        plan.monitors,
        plan.observers);
  }

  /**
   * All that is to go wrong in it: the settings' faults, then chaos, drawn by now. With these
   * faults, sealed if chaos was hostile, and no chaos, it is the same run.
   */
  public FaultPlan faults() {
    return plan.allFaults();
  }

  /**
   * Runs until every app has ended, or until the settings' time limit.
   *
   * @throws SimulationFailed if an app, a handler or the simulator itself threw
   */
  public SimResult run() {
    try (Engine engine = new Engine(plan)) {
      return engine.run();
    }
  }

  /** Says what a simulation consists of. */
  public static final class Builder {

    String name = "app";
    SimSettings settings = SimSettings.defaults();
    long seed;
    @Nullable Long behaviourSeed;
    CarrierKind carriers = CarrierKind.best();
    Obstacles obstacles = Obstacles.NONE;
    @Nullable Director director;
    @Nullable Bystander bystander;
    private FaultPlan faults = FaultPlan.NONE;
    private @Nullable Long endNs;
    final List<RobotSpec> robots = new ArrayList<>();
    final List<LinkRule> linkRules = new ArrayList<>();
    final List<SimObserver> observers = new ArrayList<>();
    final List<Supplier<? extends Monitor>> monitors = new ArrayList<>();
    private final SortedMap<String, String> parameters = new TreeMap<>();
    private boolean isCountGiven = true;
    private @Nullable Function<GlobalVarHolder, ? extends LogicThread> placedApp;
    private int placed;

    private Builder() {}

    /** The app's or scenario's name, for trace headers and messages. */
    public Builder name(String newName) {
      name = newName;
      return this;
    }

    /** Adds {@code count} robots {@code bot0}, {@code bot1}, ... at free places drawn by seed. */
    public Builder robots(int count, Function<GlobalVarHolder, ? extends LogicThread> app) {
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

    /** The settings as they stand. */
    public SimSettings settings() {
      return settings;
    }

    /** Decides the scenario: places, routes, arrivals; and behaviour unless that has its own. */
    public Builder seed(long newSeed) {
      seed = newSeed;
      return this;
    }

    /** Decides everything else: delays, losses, noise, the robots' own draws. */
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

    /** The obstacles so far: those of the settings' file come with {@link #build}. */
    public Obstacles obstacles() {
      return obstacles;
    }

    public Builder director(Director newDirector) {
      director = newDirector;
      return this;
    }

    /** Somebody who may let the run wait, and may intervene. */
    public Builder bystander(Bystander newBystander) {
      bystander = newBystander;
      return this;
    }

    /**
     * Ends the run at {@code newEndNs} at the latest, whatever the settings' duration says: for a
     * scenario in which that is the time of something else.
     */
    public Builder endNs(long newEndNs) {
      endNs = newEndNs;
      return this;
    }

    /** A rule for every datagram, before the settings' delay and loss; earlier rules go first. */
    public Builder linkRule(LinkRule rule) {
      linkRules.add(rule);
      return this;
    }

    /**
     * One more fault, as text: {@code crash(bot2,at=12s,restart=5s)}.
     *
     * @throws BadInput if it is none
     */
    public Builder fault(String fault) {
      return faults(new FaultPlan(List.of(FaultGrammar.parse(fault))));
    }

    /** More faults, besides those of the settings. */
    public Builder faults(FaultPlan plan) {
      faults = faults.plus(plan);
      return this;
    }

    public Builder observer(SimObserver observer) {
      observers.add(observer);
      return this;
    }

    /** A specification to check throughout the run. A supplier, since each run needs its own. */
    public Builder monitor(Supplier<? extends Monitor> monitor) {
      monitors.add(monitor);
      return this;
    }

    /** A parameter of the scenario, for the trace's header: what a replay must set. */
    public Builder parameter(String key, String value) {
      parameters.put(key, value);
      return this;
    }

    /**
     * It was the scenario that decided how many robots there are, whatever the settings say: the
     * trace's header does not name their number, so that the scenario decides again in a replay.
     */
    public Builder countedByScenario() {
      isCountGiven = false;
      return this;
    }

    /**
     * The simulation; the builder is used up.
     *
     * @throws BadInput if the settings' files cannot be read, the robots find no room, or a fault
     *     names a robot that is not there and cannot join
     */
    public Simulation build() {
      if (!faults.isEmpty()) {
        FaultPlan all = settings.get(Setting.FAULTS).plus(faults);
        settings = settings.toBuilder().set(Setting.FAULTS, all).build();
        faults = FaultPlan.NONE;
      }
      String obstacleFile = settings.get(Setting.OBSTACLE_FILE);
      if (!obstacleFile.isEmpty()) {
        for (Obstacle obstacle : WaypointFiles.read(Path.of(obstacleFile)).obstacles().all()) {
          obstacles = obstacles.plus(obstacle);
        }
      }
      if (placedApp != null) {
        List<Pose> starts = Starts.of(settings, placed, obstacles, new Rng(seed));
        for (int i = 0; i < placed; i++) {
          RobotId id = new RobotId(settings.robotName() + i);
          robots.add(new RobotSpec(id, starts.get(i), true, placedApp));
        }
        placedApp = null;
      }
      if (director == null) {
        // With one, others may join: then it is looked at when the fault begins.
        settings.get(Setting.FAULTS).requireNamedAmong(deployment().asList());
      }
      return new Simulation(this);
    }

    /** The seed of everything but the scenario. */
    long behaviourSeedOrDerived() {
      return behaviourSeed != null ? behaviourSeed : TraceHeader.behaviourSeedOf(seed);
    }

    /** Those of the settings, then chaos; the robots must be known. */
    FaultPlan allFaults() {
      Rng rng = new Rng(behaviourSeedOrDerived()).fork("chaos");
      return settings
          .get(Setting.FAULTS)
          .plus(
              FaultPlan.chaos(
                  settings.get(Setting.CHAOS), robots.size(), settings.chaosEndNs(), rng));
    }

    /** The robots of the start; two of one name would be taken for one. */
    Participants deployment() {
      List<RobotId> ids = new ArrayList<>();
      robots.forEach(robot -> ids.add(robot.id()));
      Participants deployment = Participants.of(ids);
      if (deployment.size() != ids.size()) {
        throw new BadInput("two robots of one name among " + ids);
      }
      return deployment;
    }

    /** What the run's datagrams are sealed with, or null for none. */
    @Nullable DeploymentKey key() {
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

    TraceHeader header() {
      Map<String, String> all = new LinkedHashMap<>(parameters);
      all.putAll(settings.asText());
      if (!isCountGiven) {
        all.remove(Setting.ROBOTS.key());
      }
      return new TraceHeader(
          Version.STARL, name, seed, behaviourSeedOrDerived(), all, deployment().asList());
    }

    /** When it ends at the latest, in ns of virtual time. */
    public long endNs() {
      return endNs == null ? settings.endNs() : endNs;
    }
  }
}
