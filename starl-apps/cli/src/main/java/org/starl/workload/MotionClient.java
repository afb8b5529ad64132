package org.starl.workload;

import org.starl.GlobalVarHolder;
import org.starl.geometry.Circle;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.motion.MotionFlag;
import org.starl.primitives.motion.MotionControl;
import org.starl.primitives.motion.MotionPrim;
import org.starl.primitives.motion.MotionSpec;

/**
 * Each robot drives to places around its start, outside a region that is sometimes in the way: then
 * it stops, reports failure, and tries elsewhere.
 */
final class MotionClient extends Client {

  private static final long THINK_MS = 500;

  /** Some times the longest wait in 60 runs of 12 robots without faults. */
  private static final long PROMPT_MS = 20_000;

  private static final double REACH_MM = 1_000;
  private static final double MAX_RADIUS_MM = 300;

  private final MotionPrim motion;
  private Point home = new Point(0, 0);
  private boolean hasHome;

  private MotionClient(GlobalVarHolder gvh, Setup setup) {
    super(gvh, setup, THINK_MS);
    motion = new MotionControl(gvh);
  }

  static void setUp(Setup setup) {
    setup.place(gvh -> new MotionClient(gvh, setup));
    setup.simulation().monitor(() -> new MotionSpec(setup.settings().motionParameters(0)));
    setup.promise(PROMPT_MS, true);
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
    Circle avoid = new Circle(around(home, REACH_MM), MAX_RADIUS_MM * rng.nextDouble());
    motion.do_move(new ItemPosition("place" + round, to.xMm(), to.yMm()), avoid);
    await(() -> motion.motionflag().get() != MotionFlag.MOVING);
    return motion.motionflag().get() == MotionFlag.DONE;
  }

  private Point around(Point centre, double maxMm) {
    double angle = 2 * Math.PI * rng.nextDouble();
    double mm = maxMm * rng.nextDouble();
    return new Point(
        centre.xMm() + mm * StrictMath.cos(angle), centre.yMm() + mm * StrictMath.sin(angle));
  }
}
