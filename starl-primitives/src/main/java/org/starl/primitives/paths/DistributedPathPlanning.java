// Longer than 500 lines because the calls of an app change one state: a plan, a claim, an entry, a
// drive.
package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.Computation;
import org.starl.GlobalVarHolder;
import org.starl.body.MotionParameters;
import org.starl.comms.Channel;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.gvh.GvhCell;
import org.starl.gvh.GvhVariable;
import org.starl.gvh.Wait;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.Timer;
import org.starl.platform.Waits;
import org.starl.primitives.StarLPrimitive;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.random.Rng;
import org.starl.time.Time;
import org.starl.trace.Instance;

/**
 * Drives robots to their goals inside reach tubes that do not overlap (paper, sections 4 and 5.4);
 * the package documentation is the contract. Create it at the start of the app: at the first fix
 * the robot announces its place, and it must not move before the others know it. Strand only.
 *
 * <pre>{@code
 * paths.goTo(new ItemPosition("window", 3000, 1000));
 * await(() -> !paths.isUnderWay());
 * if (paths.failed()) { ... }
 * }</pre>
 */
public final class DistributedPathPlanning implements StarLPrimitive {

  /** From a failure to the next try of {@code drive}. */
  private static final long RETRY_MS = 500;

  private final GlobalVarHolder gvh;
  private final PathPlanner planner;
  private final Rectangle bounds;
  private final TubeSettings settings;
  private final int radiusMm;
  private final Instance source;
  private final TubePort port;
  private final TubeClaims claims;
  private final TubeDriver driver;
  private final Rng rng;
  private final Timer timer;
  private final GvhCell<TubeFlag> flag;
  private final GvhCell<TubeFailure> failure;

  /** The goal of {@code goTo}; unused if {@link #given} is set. */
  private Point target = new Point(0, 0);

  private @Nullable Path given;

  private @Nullable Found lastFound;

  /** Counts calls of goTo, so that a plan for an earlier call is ignored. */
  private int call;

  private boolean computing;
  private boolean pausing;
  private int refusals;

  // Robots whose tubes were in the way of the latest try.
  private List<RobotId> inTheWay = List.of();

  private long deadlineNs;

  /** The granted tube, until the body is certainly inside it. */
  private @Nullable Tube entering;

  private boolean closed;

  /** Creates an instance among all robots of the deployment. */
  public DistributedPathPlanning(
      GlobalVarHolder gvh, String xid, PathPlanner planner, Rectangle bounds) {
    this(gvh, xid, gvh.id.participants(), planner, bounds, TubeSettings.DEFAULT);
  }

  /**
   * Creates an instance among a fixed group.
   *
   * @param participants all robots that move on this floor, the same list on every robot; they vote
   * @param bounds the floor: all bodies stay inside
   */
  public DistributedPathPlanning(
      GlobalVarHolder gvh,
      String xid,
      Participants participants,
      PathPlanner planner,
      Rectangle bounds,
      TubeSettings settings) {
    this.gvh = gvh;
    this.planner = planner;
    this.bounds = bounds;
    this.settings = settings;
    radiusMm = Tracking.tubeRadiusMm(gvh.plat.moat.parameters(), settings);
    Channel<TubeMessage> channel = new Channel<>(TubeFact.PRIMITIVE, xid, TubeMessage.SHAPE);
    source = channel.instance();
    rng = gvh.plat.entropy.fork(source.name());
    timer = gvh.plat.timers.timer(this::expired);
    flag = gvh.variable(source, TubeFact.FLAG, TubeFlag.IDLE);
    failure = gvh.variable(source, TubeFact.FAILURE, TubeFailure.NONE);
    driver = new TubeDriver(gvh, new DriverWiring());
    port = new TubePort(gvh, channel, participants, settings, radiusMm, new ClaimsWiring());
    claims = port.claims;
    gvh.gps.require(settings.needs(radiusMm));
    gvh.gps.onFix(this::seek);
    gvh.explain(this::waitsFor);
  }

  /**
   * Goes to {@code goal}: plans a path whose tube avoids all obstacles and the tubes of other
   * robots, claims the tube, drives along it, and releases the passed parts. {@link #tubeflag} is
   * the state.
   *
   * @throws IllegalStateException while an earlier call is under way
   */
  public void goTo(ItemPosition goal) {
    record(new TubeGoal.Place(goal));
    target = goal.at();
    given = null;
    begin();
  }

  /**
   * Goes to {@code goal}, and tries again after each failure, until the robot is there. Only from
   * {@code callStarL}.
   *
   * @param timeoutMs no try begins later; the last one is waited for
   * @return {@link TubeFailure#NONE} at the goal; else why the last try failed: {@link
   *     TubeFailure#STOPPED} at once
   * @throws IllegalStateException as {@link #goTo}
   */
  public TubeFailure drive(ItemPosition goal, long timeoutMs) {
    return driving(goal, timeoutMs).block(gvh.plat.strand);
  }

  /** The same for an app that suspends: {@code await(paths.driving(goal, 600_000))}. */
  public Waits<TubeFailure> driving(ItemPosition goal, long timeoutMs) {
    return new Waits<>(call -> drive(call, goal, Time.afterMs(nowNs(), timeoutMs)));
  }

  private void drive(Waits<TubeFailure> call, ItemPosition goal, long untilNs) {
    goTo(goal);
    call.until(
        () -> !isUnderWay(),
        Long.MAX_VALUE,
        ended -> {
          long againNs = Time.afterMs(nowNs(), RETRY_MS);
          TubeFailure why = failure.get();
          if (!failed() || why == TubeFailure.STOPPED || againNs > untilNs) {
            call.end(why);
          } else {
            call.until(null, againNs, slept -> drive(call, goal, untilNs));
          }
        });
  }

  /**
   * Drives along the given {@code path}, without planning. The tube is requested repeatedly until
   * it is granted or the deadline has passed. The caller must make sure that the path avoids
   * obstacles.
   *
   * @throws IllegalStateException while an earlier call is under way
   * @throws IllegalArgumentException if the path does not begin at the robot's place
   */
  public void goAlong(Path path) {
    double offMm = gvh.gps.maxDistanceMm(path.start());
    if (offMm > settings.positionErrorMm() + gvh.plat.moat.parameters().goalRadiusMm()) {
      throw new IllegalArgumentException(
          "path from " + path.start() + ": expected to begin at the robot, within position error");
    }
    record(new TubeGoal.Along(path));
    given = path;
    begin();
  }

  /** Stops; FAIL if a drive was under way. The robot keeps the parts of its tube not yet passed. */
  public void stop() {
    driver.stop();
    if (isUnderWay()) {
      claims.withdraw();
      if (entering != null) {
        giveBack(entering);
      }
      fail(TubeFailure.STOPPED);
    }
  }

  /**
   * Gives back what this robot holds, but the leg in which its body is: after a drive that failed or
   * was stopped, or after a restart, where the robot will not go on at once. Others may then pass.
   *
   * @return whether it now holds that leg alone; false if its body is in no leg for certain, without a
   *     fix, or before the others know its place: call it again
   * @throws IllegalStateException while a drive is under way
   */
  public boolean standHere() {
    if (isUnderWay() || closed) {
      throw new IllegalStateException(
          source + ": standHere while " + (closed ? "closed" : flag.get()));
    }
    for (Tube tube : claims.isSettled() ? claims.held() : List.<Tube>of()) {
      for (int i = 0; i < tube.parts(); i++) {
        if (TubeDriver.isInside(gvh, tube.part(i))) {
          int last = Math.min(i + 1, tube.points().size() - 1);
          Tube leg = new Tube(tube.points().subList(i, last + 1), tube.radiusMm());
          if (!claims.held().equals(List.of(leg))) {
            holdOnly(leg);
          }
          return claims.held().equals(List.of(leg)); // not before it is on stable storage
        }
      }
    }
    return false;
  }

  /**
   * One call of a restarted program for mutex and tubes: declares that the body is only in {@code
   * sections} of {@code mutex}, and waits until {@link #standHere()}. Only from {@code callStarL}.
   *
   * @param timeoutMs how long at most, above 0
   * @return whether it now holds the leg of its body alone
   */
  public boolean standHere(MutexPrim mutex, Collection<String> sections, long timeoutMs) {
    mutex.standsIn(sections);
    gvh.plat.strand.awaitUntil(this::standHere, Time.afterMs(nowNs(), timeoutMs));
    return standHere();
  }

  /** Whether the latest {@code goTo} has not ended yet. */
  public boolean isUnderWay() {
    return switch (flag.get()) {
      case PLANNING, CLAIMING, MOVING -> true;
      case IDLE, DONE, FAIL -> false;
    };
  }

  public boolean failed() {
    return flag.get() == TubeFlag.FAIL;
  }

  public GvhVariable<TubeFlag> tubeflag() {
    return flag.variable();
  }

  /** Why the latest {@code goTo} failed. */
  public GvhVariable<TubeFailure> failure() {
    return failure.variable();
  }

  /** Whether the others know this robot's place; it does not move before. */
  public boolean isPlaced() {
    return claims.isPlaced();
  }

  /** The tubes that this robot holds. */
  public List<Tube> held() {
    return claims.held();
  }

  /** All parts of tubes that other robots hold or want, as far as known; paths avoid them. */
  public List<Capsule> taken() {
    return claims.taken();
  }

  /** Robots that have not announced their place, as far as known; all robots wait for them. */
  public List<RobotId> unplaced() {
    return claims.unplaced();
  }

  /** The radius of the tubes around the path, in mm. */
  public int radiusMm() {
    return radiusMm;
  }

  /** The radius of the tubes of a robot with these motion parameters, in mm. */
  public static int radiusMm(MotionParameters motion, TubeSettings settings) {
    return Tracking.tubeRadiusMm(motion, settings);
  }

  /**
   * The same motion, but so slow that the robot drives at most {@code stepMm} until its next command
   * is in effect: a tube is wider by that distance.
   */
  public static MotionParameters slowed(MotionParameters motion, double stepMm) {
    double most = stepMm / Tracking.stepS(motion);
    return motion.toBuilder()
        .linSpeedMaxMmPerS(Math.min(motion.linSpeedMaxMmPerS(), most))
        .linSpeedMinMmPerS(Math.min(motion.linSpeedMinMmPerS(), most))
        .arcSpeedMaxMmPerS(Math.min(motion.arcSpeedMaxMmPerS(), most))
        .build();
  }

  /**
   * The radius for a map that all robots share: if they have a reaction time, an upper bound for
   * robots that drive {@link #slowed}, whatever their speed errors.
   */
  public static int radiusMm(MotionParameters motion, TubeSettings settings, double stepMm) {
    return motion.reactionMs() == 0
        ? Tracking.tubeRadiusMm(motion, settings)
        : Tracking.tubeRadiusMm(motion, settings, stepMm);
  }

  @Override
  public Instance source() {
    return source;
  }

  /** Stops, and ends communication. Held tubes stay held, as after a crash. */
  @Override
  public void close() {
    stop();
    closed = true;
    timer.cancel();
    port.close();
  }

  private void record(TubeGoal goal) {
    gvh.trace.action(source, TubeFact.SHAPE, new TubeFact.goTo(goal));
  }

  private @Nullable Wait waitsFor() {
    if (!claims.isPlaced() && !claims.inTheWay().isEmpty()) {
      return new Wait(source, "stands too near for its first tube; needs room", claims.inTheWay());
    }
    List<RobotId> unplaced = claims.unplaced();
    if (!unplaced.isEmpty()) {
      return new Wait(source, "waits for the first place", unplaced);
    }
    if (!isUnderWay()) {
      return null;
    }
    String what = flag.get() + " to " + target + ", refused " + refusals + " times";
    return new Wait(source, what + (inTheWay.isEmpty() ? "" : "; needs room"), inTheWay);
  }

  private void begin() {
    if (isUnderWay() || closed) {
      throw new IllegalStateException(source + ": goTo while " + (closed ? "closed" : flag.get()));
    }
    call++;
    refusals = 0;
    inTheWay = List.of();
    pausing = false;
    failure.set(TubeFailure.NONE);
    deadlineNs = nowNs() + settings.deadlineNs();
    timer.set(deadlineNs);
    flag.set(TubeFlag.PLANNING);
    seek();
  }

  /** Plans a path if all conditions hold; called again when a condition changes. */
  private void seek() {
    boolean wanted = flag.get() == TubeFlag.PLANNING && !computing && !pausing && !closed;
    if (!wanted || !claims.isSettled() || !gvh.gps.hasFix() || !holdsOne()) {
      return;
    }
    if (given != null) {
      claim(given);
      return;
    }
    PlanTask task = task(claims.taken());
    PlanTask alone = task(List.of());
    Departure departure = departure();
    PathPlanner used = planner;
    int mine = call;
    computing = true;
    Found before = lastFound;
    Computation<Found> plans =
        gvh.plat.compute(() -> Found.of(departure, used, task, alone, before));
    plans.whenDone(() -> {
      computing = false;
      lastFound = plans.result();
      if (mine == call && !closed) {
        planned(lastFound);
      } else {
        seek();
      }
    });
  }

  /**
   * Whether the robot may claim one more tube. A program that crashed between the grant of a tube
   * and the entry into it restarts with two tubes. It releases the one without its body, once it
   * has a fix.
   */
  private boolean holdsOne() {
    List<Tube> held = claims.held();
    if (held.size() < Holding.MAX_TUBES) {
      return true;
    }
    for (Tube tube : held) {
      if (tube.capsules().stream().anyMatch(part -> TubeDriver.isInside(gvh, part))) {
        holdOnly(tube);
        return false;
      }
    }
    return false;
  }

  private PlanTask task(List<Capsule> taken) {
    double bodyMm = gvh.plat.moat.parameters().robotRadiusMm();
    return new PlanTask(
        start(), target, bounds, gvh.gps.knownObstacles().all(), taken, bodyMm, radiusMm - bodyMm);
  }

  /**
   * The start of a path: the nearest point on the axis of a held tube, if one is near. The axis
   * keeps the margin that a path needs, except for rounding; the robot stops anywhere within the
   * goal radius.
   */
  private Point start() {
    Point here = gvh.gps.pose().at();
    Point nearest = here;
    double nearestMm = settings.positionErrorMm() + gvh.plat.moat.parameters().goalRadiusMm();
    for (Tube tube : claims.held()) {
      for (Capsule part : tube.capsules()) {
        Point onAxis = part.axis().nearest(here);
        if (onAxis.distanceMm(here) < nearestMm) {
          nearest = onAxis;
          nearestMm = onAxis.distanceMm(here);
        }
      }
    }
    return nearest;
  }

  /** Limits the start point so that the body is inside the tube's disc there. */
  private Departure departure() {
    double bodyMm = gvh.plat.moat.parameters().robotRadiusMm();
    double reachMm = radiusMm - bodyMm - settings.positionErrorMm();
    return new Departure(gvh.gps.pose().at(), reachMm);
  }

  private void planned(Found found) {
    if (flag.get() != TubeFlag.PLANNING) {
      return;
    }
    if (found.among().plan() instanceof Plan.Found way) {
      claim(way.path());
    } else if (found.alone().plan() instanceof Plan.Found way) {
      Tube tube = Tracking.tube(way.path(), radiusMm, settings.maxLegMm());
      inTheWay = tube == null ? List.of() : claims.meeting(tube);
      tryLater();
    } else {
      fail(TubeFailure.NO_PATH);
    }
  }

  private void claim(Path path) {
    Tube tube = Tracking.tube(path, radiusMm, settings.maxLegMm());
    if (tube == null) {
      fail(TubeFailure.TOO_LONG);
      return;
    }
    flag.set(TubeFlag.CLAIMING);
    claims.ask(tube);
  }

  private void tryLater() {
    refusals++;
    pausing = true;
    flag.set(TubeFlag.PLANNING);
    long meanNs = settings.pauseNs(refusals);
    // Between 0.5 and 1.5 of the mean, so that two robots do not refuse each other in step.
    long atNs = nowNs() + meanNs / 2 + rng.nextLong(0, meanNs);
    timer.set(Math.min(atNs, deadlineNs));
  }

  private void expired() {
    if (entering != null) {
      enter();
    } else if (nowNs() >= deadlineNs) {
      claims.withdraw();
      fail(TubeFailure.DEADLINE);
    } else {
      pausing = false;
      timer.set(deadlineNs);
      seek();
    }
  }

  /** Starts the drive once the body is certainly inside the granted tube, and releases the rest. */
  private void enter() {
    Tube tube = entering;
    if (tube == null) {
      return;
    }
    if (TubeDriver.isInside(gvh, tube.part(0))) {
      entering = null;
      timer.cancel();
      holdOnly(tube);
      flag.set(TubeFlag.MOVING);
      driver.drive(tube);
    } else if (nowNs() >= deadlineNs) {
      giveBack(tube);
      fail(TubeFailure.DEADLINE);
    } else {
      timer.set(Math.min(deadlineNs, nowNs() + settings.resendNs()));
    }
  }

  /** Releases all but {@code rest}, which contains the whole body, position error included. */
  private void holdOnly(Tube rest) {
    Point at = gvh.gps.pose().at();
    gvh.trace.action(
        source,
        TubeFact.SHAPE,
        new TubeFact.frees(new TubeList(List.of(rest)), at.xMm(), at.yMm(), gvh.gps.errorMm()));
    claims.keep(List.of(rest));
  }

  /** Releases a granted tube: the robot has not moved, so it needs only what it held before. */
  private void giveBack(Tube tube) {
    entering = null;
    List<Tube> before = new ArrayList<>(claims.held());
    before.remove(tube);
    claims.keep(before);
  }

  private void fail(TubeFailure why) {
    timer.cancel();
    failure.set(why);
    flag.set(TubeFlag.FAIL);
  }

  private long nowNs() {
    return gvh.plat.clock.nowNs();
  }

  /** A plan, with all that it depends on: a robot that waits often plans the same again. */
  private record Made(Departure departure, PlanTask task, Plan plan) {
    static Made of(Departure departure, PathPlanner planner, PlanTask task, @Nullable Made before) {
      if (before != null && before.departure.equals(departure) && before.task.equals(task)) {
        return before;
      }
      return new Made(departure, task, departure.plan(planner, task));
    }
  }

  /** A plan around the tubes of others; if there is none, also a plan without these tubes. */
  private record Found(Made among, Made alone) {
    static Found of(
        Departure departure,
        PathPlanner planner,
        PlanTask task,
        PlanTask alone,
        @Nullable Found before) {
      Made among = Made.of(departure, planner, task, before == null ? null : before.among);
      Made last = before == null || alone.equals(task) ? among : before.alone;
      boolean isWay = among.plan instanceof Plan.Found;
      return new Found(among, isWay ? last : Made.of(departure, planner, alone, last));
    }
  }

  private final class ClaimsWiring implements TubeClaims.Listener {
    @Override
    public void granted(Tube tube) {
      if (flag.get() == TubeFlag.CLAIMING) {
        entering = tube;
        inTheWay = List.of();
        enter();
      } else {
        giveBack(tube);
      }
    }

    @Override
    public void refused() {
      if (flag.get() == TubeFlag.CLAIMING) {
        inTheWay = claims.inTheWay();
        tryLater();
      }
    }

    @Override
    public void settled() {
      seek();
    }
  }

  private final class DriverWiring implements TubeDriver.Listener {
    @Override
    public void passed(int parts, Tube rest) {
      holdOnly(rest);
    }

    @Override
    public void arrived(Tube end) {
      holdOnly(end);
      flag.set(TubeFlag.DONE);
    }

    @Override
    public void stopped(String why) {
      gvh.log.i(source.name(), "stopped: " + why);
      fail(TubeFailure.MOTION);
    }
  }
}
