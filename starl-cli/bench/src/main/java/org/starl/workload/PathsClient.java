package org.starl.workload;

import org.starl.GlobalVarHolder;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Rectangle;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.OptimalPlanner;
import org.starl.primitives.paths.PathPlanner;
import org.starl.primitives.paths.RrtPlanner;
import org.starl.primitives.paths.RrtSettings;
import org.starl.primitives.paths.TubeFlag;
import org.starl.primitives.paths.TubeSettings;
import org.starl.primitives.paths.TubesSpec;
import org.starl.random.Rng;
import org.starl.sim.SimSettings;
import org.starl.time.Time;

/**
 * Robots drive to places all over a floor with walls, each in a tube that it has claimed. A robot
 * that finds no path or gets no tube tries elsewhere. Robots stop some of their drives.
 */
final class PathsClient extends Client {

  static final Parameter PLANNER =
      Parameter.choice("planner", "how paths are found: optimal or rrt", "optimal", "rrt");

  private static final long THINK_MS = 500;
  private static final long PROMPT_MS = 80_000;
  private static final long PROMPT_EACH_MS = 10_000;
  private static final int PROMPT_MESSAGES = 100;
  private static final double MARGIN_MM = 500;

  /** Part of the drives that are stopped, after at most so much time. */
  private static final double CANCELLED = 0.1;

  private static final long CANCEL_MS = 10_000;

  /** Half of these while a claim is under way: a tube may be granted after the stop. */
  private static final long CANCEL_CLAIM_MS = 150;

  static final TubeSettings TUBES = tubes(60, 1_000);

  /** The longest legs of small tubes, whose radius has little room for the stray of a long leg. */
  private static final int SHORT_LEG_MM = 400;

  /** The tubes' deadline, and the longest drive with its stops. */
  private static final long TOLD_NS = 600 * Time.NS_PER_S;

  private final double sideMm;
  private final DistributedPathPlanning paths;

  private PathsClient(GlobalVarHolder gvh, Setup setup, boolean isOptimal, TubeSettings tubes) {
    super(gvh, setup, THINK_MS);
    sideMm = setup.sideMm();
    Rectangle floor = new Rectangle(0, 0, sideMm, sideMm);
    paths =
        new DistributedPathPlanning(
            gvh, "floor", gvh.id.participants(), planner(rng, isOptimal), floor, tubes);
  }

  static void setUp(Setup setup) {
    boolean isOptimal = setup.request().choice(PLANNER).equals("optimal");
    // A tube may allow for less than the error that a robot has between two fixes, or while one is
    // due: then it must wait for a better one.
    int noiseMm = (int) Math.ceil(setup.settings().positionNoise().boundMm());
    boolean isSmall = new Rng(setup.request().seed()).fork("paths/tubes").nextBoolean(0.5);
    TubeSettings tubes = isSmall ? tubes(noiseMm, SHORT_LEG_MM) : TUBES;
    setup.place(gvh -> new PathsClient(gvh, setup, isOptimal, tubes));
    setup.simulation().obstacles(setup.walls());
    setup.simulation().monitor(() -> new TubesSpec(TOLD_NS));
    setup.promise(PROMPT_MS + setup.robots() * PROMPT_EACH_MS, PROMPT_MESSAGES, true);
  }

  private static TubeSettings tubes(int positionErrorMm, int maxLegMm) {
    return new TubeSettings(positionErrorMm, maxLegMm, 30_000, 200, 2_000, 200, 2_000);
  }

  /** Wheels and fixes with errors, as for motion. */
  static void settings(Request request, SimSettings.Builder settings) {
    MotionClient.errors(new Rng(request.seed()).fork("motion"), settings);
  }

  private static PathPlanner planner(Rng rng, boolean isOptimal) {
    return isOptimal
        ? new OptimalPlanner()
        : new RrtPlanner(new RrtSettings(2_000, 500, 0.1, 50), rng.fork("rrt").nextLong());
  }

  @Override
  protected void prepare() {
    await(gvh.gps::hasFix);
  }

  @Override
  protected boolean obtain(int round) {
    paths.goTo(new ItemPosition("place" + round, somewhere(), somewhere()));
    if (rng.nextBoolean(CANCELLED)) {
      if (rng.nextBoolean(0.5)) {
        await(() -> !paths.isUnderWay() || paths.tubeflag().get() == TubeFlag.CLAIMING);
        await(() -> !paths.isUnderWay(), rng.nextLong(0, CANCEL_CLAIM_MS));
      } else {
        await(() -> !paths.isUnderWay(), rng.nextLong(0, CANCEL_MS));
      }
      paths.stop();
    }
    await(() -> !paths.isUnderWay());
    return !paths.failed();
  }

  private double somewhere() {
    return MARGIN_MM + (sideMm - 2 * MARGIN_MM) * rng.nextDouble();
  }
}
