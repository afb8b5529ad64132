package org.starl.launch;

import java.util.List;
import org.starl.RobotRunner;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.platform.Clock;
import org.starl.random.Rng;
import org.starl.robot.realtime.RealStrand;
import org.starl.sim.Director;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimControl;
import org.starl.sim.SimulationPlan;
import org.starl.sim.net.SimNetwork;
import org.starl.sim.world.Unsynced;
import org.starl.time.Time;

/**
 * The control that a scenario's director has in the process of one robot: it directs this robot
 * only. All other robots appear as up, on the floor, far away and moving. Strand only.
 */
final class OneRobotControl implements SimControl {

  private static final Pose FAR_AWAY = Pose.of(new Point(1e9, 1e9), 0);
  private static final long RETRY_NS = 50 * Time.NS_PER_MS;

  /** The robot's simulated body. */
  interface Body {

    /** Asks for its start position; returns whether it stands there now. */
    boolean place();

    /** Removes it from the floor. */
    void lift();

    boolean isOnFloor();

    /** Whether it would touch no known body there. */
    boolean isFree(Pose place);

    /** Its pose on the floor. */
    Pose pose();
  }

  private final SimulationPlan plan;
  private final RobotSpec spec;
  private final Body body;
  private final RealStrand strand;
  private final Clock clock;
  private final RobotRunner runner;

  /**
   * @param clock the robot's own, for its strand
   * @param runner runs its program
   */
  OneRobotControl(
      SimulationPlan plan,
      RobotSpec spec,
      Body body,
      RealStrand strand,
      Clock clock,
      RobotRunner runner) {
    this.plan = plan;
    this.spec = spec;
    this.body = body;
    this.strand = strand;
    this.clock = clock;
    this.runner = runner;
  }

  /** Puts the body on the floor and lets the director begin. Call from any thread, once. */
  void begin() {
    strand.post(() -> {
      if (spec.onFloor()) {
        placeSoon();
      }
      Director director = plan.director();
      if (director != null) {
        director.direct(this);
      }
    });
  }

  private void placeSoon() {
    if (!body.place()) {
      at(clock.nowNs() + RETRY_NS, this::placeSoon);
    }
  }

  private boolean isHere(RobotId id) {
    return id.equals(spec.id());
  }

  @Override
  public long nowNs() {
    return clock.nowNs();
  }

  @Override
  public long events() {
    return 0;
  }

  @Override
  public void at(long atNs, Runnable action) {
    strand.timer(action).set(atNs);
  }

  @Override
  public Rng scenarioRng(String name) {
    return new Rng(plan.header().scenarioSeed()).fork(name);
  }

  @Override
  public List<RobotId> robots() {
    return plan.header().robots();
  }

  @Override
  public boolean isUp(RobotId id) {
    return true;
  }

  @Override
  public boolean putOnFloor(RobotId id) {
    return !isHere(id) || body.place();
  }

  @Override
  public void takeOffFloor(RobotId id) {
    if (isHere(id)) {
      body.lift();
    }
  }

  @Override
  public boolean isOnFloor(RobotId id) {
    return !isHere(id) || body.isOnFloor();
  }

  @Override
  public boolean isFree(Pose place) {
    return body.isFree(place);
  }

  @Override
  public Pose truePose(RobotId id) {
    return isHere(id) ? body.pose() : FAR_AWAY;
  }

  @Override
  public boolean isFinished(RobotId id) {
    return isHere(id) && runner.isFinished();
  }

  @Override
  public void join(RobotSpec newcomer) {
    throw unsupported("start " + newcomer.id());
  }

  @Override
  public void crash(RobotId id) {
    throw unsupported("crash " + id);
  }

  @Override
  public void crash(RobotId id, long downNs, Unsynced unsynced) {
    throw unsupported("crash " + id);
  }

  @Override
  public void restart(RobotId id, Unsynced unsynced) {
    throw unsupported("restart " + id);
  }

  @Override
  public void leave(RobotId id) {
    throw unsupported("remove " + id);
  }

  @Override
  public SimNetwork network() {
    throw unsupported("change the network");
  }

  private static UnsupportedOperationException unsupported(String action) {
    return new UnsupportedOperationException(
        "a director cannot " + action + " where robots are processes");
  }
}
