package org.starl.motion;

import static org.starl.time.Time.NS_PER_MS;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.body.WheelCommand;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.gvh.GvhCell;
import org.starl.gvh.GvhVariable;
import org.starl.gvh.Log;
import org.starl.gvh.Trace;
import org.starl.gvh.Variables;
import org.starl.platform.Chassis;
import org.starl.platform.Clock;
import org.starl.platform.Platform;
import org.starl.platform.Timer;
import org.starl.random.Rng;
import org.starl.trace.Instance;

/**
 * {@code gvh.plat.moat}: drives the robot to a target (paper, section 4.1). Strand only.
 *
 * <p>Safety: the body, a disc, stays outside the region to avoid, within the bounds of {@link Gps}.
 * Progress: DONE means that the estimated position is within the goal radius of the target, so the
 * true one is within goal radius plus error bound; FAIL, with a {@link #failure}, means that the
 * wheels are stopped and the target was not reached. During a motion a timer steps the automaton
 * once per period, and a contact steps it at once; an idle robot needs no computation.
 */
public final class MotionController {

  private static final Instance SOURCE = MotionFact.SOURCE;

  private final Gps gps;
  private final Clock clock;
  private final Chassis chassis;
  private final Log log;
  private final Trace trace;
  private final Timer timer;
  private final Rng rng;
  private final GvhCell<MotionTask> task;
  private final GvhCell<MotionFlag> motionflag;

  private MotionParameters parameters;
  private MotionParameters inUse;
  private WheelCommand commanded = WheelCommand.STOP;
  private boolean bumped;
  private Consumer<Contact> contactListener = contact -> {};
  private Supplier<Region> retreatAvoid = Nowhere::new;
  private long dueNs;
  private @Nullable MotionRun run;

  public MotionController(Platform platform, Gps gps, Log log, Trace trace, Variables variables) {
    this.gps = gps;
    parameters = platform.motionParameters();
    inUse = parameters;
    clock = platform.clock();
    chassis = platform.chassis();
    this.log = log;
    this.trace = trace;
    timer = platform.timers().timer(this::tick);
    rng = platform.entropy().fork(SOURCE.name());
    task = variables.variable(SOURCE, MotionFact.TASK, new MotionTask.None());
    motionflag = variables.variable(SOURCE, MotionFact.FLAG, MotionFlag.IDLE);
    chassis.onBump(this::bumpsChanged);
    // A restarted program must not continue with the speed of the one before.
    chassis.drive(WheelCommand.STOP);
  }

  /**
   * Goes to {@code target}, replacing any earlier command. A motion that cannot begin fails within
   * this call, so a program that tries again must sleep in between.
   */
  public void doMove(ItemPosition target) {
    doMove(target, new Nowhere());
  }

  /**
   * Goes to {@code target} with the whole body outside {@code avoid}, or stops with FAIL; replaces
   * any earlier command. The target's heading is ignored.
   */
  public void doMove(ItemPosition target, Region avoid) {
    move(target, avoid, null);
  }

  /** The same on a way of {@code planner}; planned anew where the body is held up. */
  public void doMove(ItemPosition target, Region avoid, WayPlanner planner) {
    move(target, avoid, from -> traced(planner.plan(from)));
  }

  private void move(ItemPosition target, Region avoid, @Nullable WayPlanner planner) {
    record(new MotionFact.doMove(target, avoid));
    long nowNs = clock.nowNs();
    MotionRun newRun = MotionRun.goTo(target.at(), avoid, retreatAvoid, parameters, rng, nowNs);
    begin(new MotionTask.GoTo(target, avoid), newRun.onWayOf(planner));
  }

  private Supplier<@Nullable List<Point>> traced(Supplier<@Nullable List<Point>> plan) {
    return () -> {
      List<Point> way = plan.get();
      if (way != null && way.size() != 1) {
        record(new MotionFact.planned(way));
      }
      return way;
    };
  }

  /** Turns on the spot until the robot faces {@code target}, replacing any earlier command. */
  public void turnTo(ItemPosition target) {
    record(new MotionFact.turnTo(target));
    begin(
        new MotionTask.TurnTo(target),
        MotionRun.turnTo(target.at(), retreatAvoid, parameters, rng, clock.nowNs()));
  }

  /**
   * Drives with this command until the next call, without a target; cancels any motion. Call it in
   * each step of the app: real wheels stop if the program is silent. Nothing watches the way but the
   * app, which reads {@link #bumps}.
   */
  public void doDrive(WheelCommand command) {
    if (run != null || !command.equals(commanded)) {
      record(new MotionFact.doDrive(command.linearMmPerS(), command.angularRadPerS()));
    }
    inUse = parameters;
    gps.assume(inUse);
    if (run != null) {
      run = null;
      timer.cancel();
      task.set(new MotionTask.None());
      motionflag.set(MotionFlag.IDLE);
    }
    drive(command);
  }

  /** The bump sensors now. */
  public Bumps bumps() {
    return chassis.bumps();
  }

  /** Stops the wheels and cancels the motion. */
  public void motion_stop() {
    record(new MotionFact.motion_stop());
    run = null;
    timer.cancel();
    drive(WheelCommand.STOP);
    task.set(new MotionTask.None());
    motionflag.set(MotionFlag.IDLE);
  }

  /** Whether the last motion is still going on: not done, failed or stopped. */
  public boolean inMotion() {
    return motionflag.get() == MotionFlag.MOVING;
  }

  /** The paper's {@code mc.failed}: whether the last motion failed. */
  public boolean failed() {
    return motionflag.get() == MotionFlag.FAIL;
  }

  /** Why the last motion failed, in words for people; empty if it did not. */
  public String failure() {
    MotionFailure why = run == null ? null : run.failure();
    return why == null ? "" : why.toString();
  }

  public GvhVariable<MotionFlag> motionflag() {
    return motionflag.variable();
  }

  /** The pair {@code (target, avoid)} of the last command. */
  public GvhVariable<MotionTask> target() {
    return task.variable();
  }

  /** Sets the parameters of the next motion; the current one keeps its own. */
  public void setParameters(MotionParameters newParameters) {
    parameters = newParameters;
  }

  public MotionParameters parameters() {
    return parameters;
  }

  /**
   * Sets the one listener for contacts. It is called on the strand, before the wheels react,
   * whenever a bump sensor changes during a motion and at least one is closed, under any collision
   * policy.
   */
  public void onContact(Consumer<Contact> listener) {
    contactListener = listener;
  }

  /**
   * Sets the region that the body stays out of while it backs off after a bump, besides that of its
   * motion: such as the zones that others hold. It is read on the strand, when the body begins to back
   * off; a part in which the body is then holds it where it is. Default: nowhere.
   */
  public void setRetreatAvoid(Supplier<Region> region) {
    retreatAvoid = region;
  }

  private void record(MotionFact fact) {
    trace.action(SOURCE, MotionFact.SHAPE, fact);
  }

  private void begin(MotionTask newTask, MotionRun newRun) {
    run = newRun;
    inUse = parameters;
    gps.assume(inUse);
    task.set(newTask);
    motionflag.set(MotionFlag.MOVING);
    dueNs = clock.nowNs();
    tick();
  }

  private void tick() {
    long nowNs = clock.nowNs();
    step(nowNs);
    if (run == null || !run.needsSteps()) {
      timer.cancel();
      return;
    }
    long periodNs = inUse.automatonPeriodMs() * NS_PER_MS;
    while (dueNs <= nowNs) {
      dueNs += periodNs;
    }
    timer.set(dueNs);
  }

  private void step(long nowNs) {
    if (run == null) {
      return;
    }
    drive(run.step(gps.location(), gps.isContradicted(), chassis.bumps(), gps.lingering(), nowNs));
    if (motionflag.get() == MotionFlag.MOVING && run.status() != MotionFlag.MOVING) {
      reportEnd(run);
    }
    motionflag.set(run.status());
  }

  private void reportEnd(MotionRun ended) {
    MotionFailure why = ended.failure();
    if (why != null) {
      log.i(SOURCE.name(), "failed: " + why);
      record(new MotionFact.failed(why));
    } else if (trace.isOn()) {
      Pose at = gps.pose();
      record(new MotionFact.arrived(at.xMm(), at.yMm(), gps.errorMm()));
    }
  }

  private void drive(WheelCommand command) {
    if (!command.equals(commanded)) {
      commanded = command;
      gps.commanded(command, bumped);
    }
    // Repeated at each step: it also shows the chassis that the program is alive.
    chassis.drive(command);
  }

  private void bumpsChanged() {
    Bumps bumps = chassis.bumps();
    bumped = bumps.any();
    gps.commanded(commanded, bumped);
    // A sensor that opens waits for the next step: else a robot that stops for its contact, and so
    // frees itself, would drive against it again at the same time, and never let time pass.
    if (bumped && run != null && run.needsSteps()) {
      if (gps.location() instanceof Location.Known known) {
        handleContact(new Contact(known, bumps));
      }
      step(clock.nowNs());
      if (run != null && !run.needsSteps()) {
        timer.cancel();
      }
    }
  }

  private boolean marksContacts() {
    return inUse.reaction() == CollisionPolicy.STOP_ON_COLLISION
        || inUse.reaction() == CollisionPolicy.USE_COLBACK;
  }

  private void handleContact(Contact contact) {
    if (marksContacts()) {
      Pose pose = contact.at().pose();
      Point guess = KnownObstacles.contact(pose, contact.bumps(), inUse.robotRadiusMm());
      gps.knownObstacles().addContact(guess, inUse.contactMarkMm());
    }
    contactListener.accept(contact);
  }
}
