package org.starl.primitives.paths;

import java.util.ArrayList;
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
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.Timer;
import org.starl.primitives.StarLPrimitive;
import org.starl.random.Rng;

/**
 * Brings robots to their goals in reach tubes of their own, no two of which meet (paper, sections 4
 * and 5.4); see the package for the contract. Make it at the start of the app: with the first fix the
 * robot says where it stands, and must not move before others know. Strand only.
 *
 * <pre>{@code
 * paths.goTo(new ItemPosition("window", 3000, 1000));
 * await(() -> !paths.isUnderWay());
 * if (paths.failed()) { ... }
 * }</pre>
 */
public final class DistributedPathPlanning implements StarLPrimitive {

  private final GlobalVarHolder gvh;
  private final PathPlanner planner;
  private final Rectangle bounds;
  private final TubeSettings settings;
  private final int radiusMm;
  private final String source;
  private final TubeClaims claims;
  private final TubeDriver driver;
  private final Rng rng;
  private final Timer timer;
  private final GvhCell<TubeFlag> flag;
  private final GvhCell<TubeFailure> failure;

  /** Where to go; in place of a target, {@link #given} says the whole way. */
  private Point target = new Point(0, 0);

  private @Nullable Path given;

  /** Counts calls of goTo: a plan that was made for an earlier one is of no use. */
  private int call;

  private boolean computing;
  private boolean pausing;
  private int refusals;
  private long deadlineNs;

  /** The tube that was granted, until the body is inside it for certain. */
  private @Nullable Tube entering;

  private boolean closed;

  /** Among all robots that the deployment knows. */
  public DistributedPathPlanning(
      GlobalVarHolder gvh, String xid, PathPlanner planner, Rectangle bounds) {
    this(gvh, xid, gvh.id.participants(), planner, bounds, TubeSettings.DEFAULT);
  }

  /**
   * Among a fixed group.
   *
   * @param participants all that move on this floor, the same on every robot; they vote
   * @param bounds all bodies stay inside
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
    Channel<TubeMessage> channel = new Channel<>(TubeTrace.PRIMITIVE, xid, new TubeCodec());
    source = channel.name();
    rng = gvh.plat.entropy.fork(source);
    timer = gvh.plat.timers.timer(this::expired);
    flag = gvh.variable(source, TubeTrace.FLAG, TubeFlag.IDLE);
    failure = gvh.variable(source, TubeTrace.FAILURE, TubeFailure.NONE);
    driver = new TubeDriver(gvh, new DriverWiring());
    claims = new TubeClaims(gvh, channel, participants, settings, radiusMm, new ClaimsWiring());
    gvh.gps.onFix(this::seek);
  }

  /**
   * Goes to {@code goal}: finds a path whose tube keeps out of all obstacles and of the others' tubes,
   * claims it, drives, and gives back what is behind. {@link #tubeflag} tells how it stands.
   *
   * @throws IllegalStateException while an earlier one is under way
   */
  public void goTo(ItemPosition goal) {
    gvh.trace.action(source, TubeTrace.GO_TO, goal);
    target = goal.at();
    given = null;
    begin();
  }

  /**
   * Drives along {@code path}, as drawn, from where it stands: nothing is planned, and the tube is
   * asked for again and again until the others leave it or the deadline has passed. That it keeps
   * clear of obstacles is the caller's care.
   *
   * @throws IllegalStateException while an earlier one is under way
   * @throws IllegalArgumentException if it does not begin where the robot stands
   */
  public void goAlong(Path path) {
    double offMm = gvh.gps.maxDistanceMm(path.start());
    if (offMm > settings.positionErrorMm() + gvh.plat.moat.parameters().goalRadiusMm()) {
      throw new IllegalArgumentException(
          "path from " + path.start() + ": expected to begin where the robot is, within its error");
    }
    gvh.trace.action(source, TubeTrace.GO_TO, path);
    given = path;
    begin();
  }

  /** Stops where it is: FAIL if something was under way. What it has not passed it goes on holding. */
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

  /** Whether the latest {@code goTo} has come to no end yet. */
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
    return flag;
  }

  /** Why the latest {@code goTo} came to nothing. */
  public GvhVariable<TubeFailure> failure() {
    return failure;
  }

  /** Whether the others know where this robot stands; nothing moves before they do. */
  public boolean isPlaced() {
    return claims.isPlaced();
  }

  /** What this robot holds now. */
  public List<Tube> held() {
    return claims.held();
  }

  /** All parts of what others hold or want, as far as this robot knows: its ways keep out of them. */
  public List<Capsule> taken() {
    return claims.taken();
  }

  /** Robots that have not said where they stand, as far as this one knows: everybody waits for them. */
  public List<RobotId> unplaced() {
    return claims.unplaced();
  }

  /** How wide the tubes are: this far from the path, in mm. */
  public int radiusMm() {
    return radiusMm;
  }

  /** How wide the tubes of a robot are that moves like that: this far from the path, in mm. */
  public static int radiusMm(MotionParameters motion, TubeSettings settings) {
    return Tracking.tubeRadiusMm(motion, settings);
  }

  @Override
  public String source() {
    return source;
  }

  /** Stops; hears and sends nothing more. What it holds stays held, as by a robot that crashed. */
  @Override
  public void close() {
    stop();
    closed = true;
    timer.cancel();
    claims.close();
  }

  private void begin() {
    if (isUnderWay() || closed) {
      throw new IllegalStateException(source + ": goTo while " + (closed ? "closed" : flag.get()));
    }
    call++;
    refusals = 0;
    pausing = false;
    failure.set(TubeFailure.NONE);
    deadlineNs = nowNs() + settings.deadlineNs();
    timer.set(deadlineNs);
    flag.set(TubeFlag.PLANNING);
    seek();
  }

  /** Seeks a path, unless it cannot begin yet: it is called again when what it waits for is there. */
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
    PathPlanner with = planner;
    int mine = call;
    computing = true;
    Computation<Found> plans = gvh.plat.compute(() -> Found.of(departure, with, task, alone));
    plans.whenDone(() -> {
      computing = false;
      if (mine == call && !closed) {
        planned(plans.result());
      } else {
        seek();
      }
    });
  }

  /**
   * Whether there is room for one more tube. A program that crashed between a grant and the way into
   * it starts anew with both: it gives back the one that its body is not in, once it knows.
   */
  private boolean holdsOne() {
    List<Tube> held = claims.held();
    if (held.size() < Holding.MAX_TUBES) {
      return true;
    }
    for (Tube tube : held) {
      for (int i = 0; i < tube.parts(); i++) {
        if (TubeDriver.isInside(gvh, tube.part(i))) {
          claims.keep(List.of(tube));
          return false;
        }
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
   * Where a way begins: on the line of the tube that it holds, if it stands near it. That is as far
   * from everything as a way must be, but for rounding; the robot itself stops anywhere within the
   * goal radius.
   */
  private Point start() {
    Point here = gvh.gps.pose().at();
    Point nearest = here;
    double nearestMm = settings.positionErrorMm() + gvh.plat.moat.parameters().goalRadiusMm();
    for (Tube tube : claims.held()) {
      for (int i = 0; i < tube.parts(); i++) {
        Point onLine = tube.part(i).axis().nearest(here);
        if (onLine.distanceMm(here) < nearestMm) {
          nearest = onLine;
          nearestMm = onLine.distanceMm(here);
        }
      }
    }
    return nearest;
  }

  /** The body is inside the disc where its way begins, once its place is known well enough. */
  private Departure departure() {
    double bodyMm = gvh.plat.moat.parameters().robotRadiusMm();
    double reachMm = radiusMm - bodyMm - settings.positionErrorMm();
    return new Departure(gvh.gps.pose().at(), reachMm);
  }

  private void planned(Found found) {
    if (flag.get() != TubeFlag.PLANNING) {
      return;
    }
    if (found.among() instanceof Plan.Found way) {
      claim(way.path());
    } else if (found.alone() instanceof Plan.Found) {
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
    // Between 0.5 and 1.5 of the mean: two that refuse each other do not keep in step.
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

  /** Gives back all but the granted tube once the body is inside it for certain, and drives. */
  private void enter() {
    Tube tube = entering;
    if (tube == null) {
      return;
    }
    if (TubeDriver.isInside(gvh, tube.part(0))) {
      entering = null;
      timer.cancel();
      claims.keep(List.of(tube));
      flag.set(TubeFlag.MOVING);
      driver.drive(tube);
    } else if (nowNs() >= deadlineNs) {
      giveBack(tube);
      fail(TubeFailure.DEADLINE);
    } else {
      timer.set(Math.min(deadlineNs, nowNs() + settings.resendNs()));
    }
  }

  /** The robot has not moved: it needs nothing but what it held before. */
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

  /** Paths among the others' tubes, and, where there is none, on a floor without them. */
  private record Found(Plan among, Plan alone) {
    static Found of(Departure departure, PathPlanner planner, PlanTask task, PlanTask alone) {
      Plan among = departure.plan(planner, task);
      boolean same = among instanceof Plan.Found || task.taken().isEmpty();
      return new Found(among, same ? among : departure.plan(planner, alone));
    }
  }

  private final class ClaimsWiring implements TubeClaims.Listener {
    @Override
    public void granted(Tube tube) {
      if (flag.get() == TubeFlag.CLAIMING) {
        entering = tube;
        enter();
      } else {
        giveBack(tube);
      }
    }

    @Override
    public void refused() {
      if (flag.get() == TubeFlag.CLAIMING) {
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
      claims.keep(List.of(rest));
    }

    @Override
    public void arrived(Tube end) {
      claims.keep(List.of(end));
      flag.set(TubeFlag.DONE);
    }

    @Override
    public void stopped(String why) {
      gvh.log.i(source, "stopped: " + why);
      fail(TubeFailure.MOTION);
    }
  }
}
