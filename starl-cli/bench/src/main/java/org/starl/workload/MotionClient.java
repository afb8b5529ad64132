package org.starl.workload;

import java.time.Duration;
import java.util.function.BiConsumer;
import org.starl.GlobalVarHolder;
import org.starl.apps.Request;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.geometry.Circle;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Region;
import org.starl.motion.MotionFlag;
import org.starl.primitives.motion.MotionControl;
import org.starl.primitives.motion.MotionPrim;
import org.starl.primitives.motion.MotionSpec;
import org.starl.random.Rng;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;

/**
 * Each robot drives to places around its start, outside a region that is sometimes in the way: then
 * it stops, reports failure, and tries elsewhere. Robots bump into each other, in half of the runs
 * into walls, too, and cancel some of their motions.
 */
final class MotionClient extends Client {

  private static final long THINK_MS = 500;

  /** Far enough to meet robots that start beside it. */
  private static final double REACH_MM = 2_500;

  private static final double MAX_RADIUS_MM = 300;

  /** Part of the motions that are cancelled, after at most so much time. */
  private static final double CANCELLED = 0.1;

  private static final long CANCEL_MS = 4_000;

  /** Part of the runs in which motions have little time. */
  private static final double HURRIED = 0.3;

  private static final long[] REACTIONS_MS = {0, 0, 50, 150};

  /** Between fixes that are this far apart a robot needs its odometry; older ones stop it. */
  private static final Duration SELDOM = Duration.ofMillis(250);

  /** Part of the runs in which robots plan no ways: they drive straight at what they must avoid. */
  private static final double STRAIGHT = 0.3;

  private final MotionPrim motion;
  private final BiConsumer<ItemPosition, Region> mover;
  private Point home = new Point(0, 0);
  private boolean hasHome;

  private MotionClient(GlobalVarHolder gvh, Setup setup, boolean isHurried, boolean isStraight) {
    super(gvh, setup, THINK_MS);
    gvh.plat.moat.setParameters(paced(gvh.plat.moat.parameters(), isHurried));
    motion = new MotionControl(gvh);
    mover = isStraight ? gvh.plat.moat::doMove : motion::do_move;
  }

  static void setUp(Setup setup) {
    // Robots bump into walls far more often than into each other.
    Rng drawn = new Rng(setup.request().seed()).fork("motion/walls");
    boolean hasWalls = drawn.nextBoolean(0.5);
    boolean isHurried = drawn.nextBoolean(HURRIED);
    boolean isStraight = drawn.nextBoolean(STRAIGHT);
    Obstacles walls = hasWalls ? setup.walls() : Obstacles.NONE;
    setup.simulation().obstacles(walls);
    MotionParameters parameters = paced(setup.settings().motionParameters(0), isHurried);
    setup.placeSilent(gvh -> new MotionClient(gvh, setup, isHurried, isStraight));
    setup.simulation().monitor(() -> new MotionSpec(parameters).located().backingOff(walls));
    // Past a body or a wall that stands at its target a robot drives until its time is over.
    boolean isLong = hasWalls || isHurried || !parameters.collisionPolicy().fails();
    setup.promise(isLong ? parameters.longestMs(2 * REACH_MM) : promptMs(parameters), 0, true);
  }

  /** A motion in a hurry that has slow wheels fails as too slow, before the faults are over. */
  private static MotionParameters paced(MotionParameters usual, boolean isHurried) {
    return isHurried ? usual.toBuilder().noProgressMs(6_000).slowestMmPerS(100).build() : usual;
  }

  /**
   * The time to turn around and to drive the longest way at the speeds of a motion that nothing is in
   * the way of, and twice the time after which it fails without progress. So 64 s, or 70 s with errors
   * of the wheels. The factor two is chosen after runs: the longest wait seen, 52.6 s, needed more than
   * one, and one of 70 s more than two where a reaction is longer than a step. Only {@link MotionParameters#longestMs}, 222 s, is the contract.
   */
  private static long promptMs(MotionParameters p) {
    double slowTurnS = p.slowTurnAngleRad() / p.turnSpeedMinRadPerS();
    double turnS = slowTurnS + (Math.PI - p.slowTurnAngleRad()) / p.turnSpeedMaxRadPerS();
    double slowS = p.slowFwdRadiusMm() / p.linSpeedMinMmPerS();
    double driveS = slowS + (2 * REACH_MM - p.slowFwdRadiusMm()) / p.linSpeedMaxMmPerS();
    long tries = p.reactionMs() > p.automatonPeriodMs() ? 3 : 2;
    return tries * p.noProgressMs()
        + (long) Math.ceil(1e3 * (turnS + driveS) / (1 - p.speedError()));
  }

  /** One of the reactions to a bump, and {@link #errors}. */
  static void settings(Request request, SimSettings.Builder settings) {
    CollisionPolicy[] policies = CollisionPolicy.values();
    Rng drawn = new Rng(request.seed()).fork("motion");
    settings.set(Setting.COLLISION_POLICY, policies[drawn.nextInt(policies.length)]);
    errors(drawn, settings);
    settings.set(Setting.DISCOVERY_ROBOTS, drawn.nextBoolean(0.5) ? 1 : 0);
  }

  /**
   * Wheels and fixes with errors. Half of the runs have no error of a kind: then a margin for
   * another kind that is too small is not made up for. In the longest reaction several commands are
   * in effect, as a robot gives one each 60 ms.
   */
  static void errors(Rng drawn, SimSettings.Builder settings) {
    if (drawn.nextBoolean(0.3)) {
      settings.set(Setting.POSITION_PERIOD, SELDOM);
    }
    settings
        .set(Setting.SPEED_ERROR, drawn.nextBoolean(0.5) ? 0.2 : 0)
        .set(Setting.POSITION_NOISE, drawn.nextBoolean(0.5) ? 20.0 : 0)
        .set(Setting.HEADING_NOISE, drawn.nextBoolean(0.5) ? 0.1 : 0)
        .set(Setting.REACTION, Duration.ofMillis(REACTIONS_MS[drawn.nextInt(REACTIONS_MS.length)]));
  }

  @Override
  protected void prepare() {
    await(gvh.gps::hasFix);
    if (!hasHome) {
      home = gvh.gps.pose().at();
      hasHome = true;
    }
  }

  @Override
  protected boolean obtain(int round) {
    Point to = around(home, REACH_MM);
    Point centre = rng.nextBoolean(0.5) ? around(home, REACH_MM) : onTheWay(to);
    Circle avoid = new Circle(centre, MAX_RADIUS_MM * rng.nextDouble());
    mover.accept(new ItemPosition("place" + round, to.xMm(), to.yMm()), avoid);
    if (rng.nextBoolean(CANCELLED)) {
      pause(rng.nextLong(0, CANCEL_MS));
      motion.motion_stop();
    }
    await(() -> motion.motionflag().get() != MotionFlag.MOVING);
    return motion.motionflag().get() == MotionFlag.DONE;
  }

  private Point onTheWay(Point to) {
    Point here = gvh.gps.pose().at();
    return here.plus(to.minus(here).times(rng.nextDouble()));
  }

  private Point around(Point centre, double maxMm) {
    double angle = 2 * Math.PI * rng.nextDouble();
    double mm = maxMm * rng.nextDouble();
    return new Point(
        centre.xMm() + mm * StrictMath.cos(angle), centre.yMm() + mm * StrictMath.sin(angle));
  }
}
