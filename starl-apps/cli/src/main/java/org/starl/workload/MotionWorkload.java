package org.starl.workload;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.geometry.Circle;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.motion.MotionFlag;
import org.starl.primitives.motion.MotionPrim;
import org.starl.primitives.motion.MotionSpec;
import org.starl.primitives.motion.Motioncontrol;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;

/**
 * {@code starl campaign motion}: each robot drives to places around its own, outside a region that
 * is sometimes in the way: then it stops, is told, and tries elsewhere.
 */
final class MotionWorkload extends PrimitiveDemo {

  private static final long THINK_MS = 500;
  private static final double REACH_MM = 1_000;
  private static final double MOST_RADIUS_MM = 300;

  MotionWorkload() {
    super("motion", "robots drive to places at random, outside regions that may be in the way");
  }

  @Override
  public Envelope envelope() {
    return Envelope.SPATIAL;
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(rounds(8), busy("20s"));
  }

  @Override
  void prepare(Simulation.Builder simulation, Request request, SimSettings settings) {
    Course course = course(request);
    place(simulation, settings, count(request, 1, 64), gvh -> new Driver(gvh, course));
    simulation.monitor(() -> new MotionSpec(settings.motionParameters(0)));
  }

  private static final class Driver extends Client {
    private final MotionPrim motion;
    private Point home = new Point(0, 0);
    private boolean hasHome;

    Driver(GlobalVarHolder gvh, Course course) {
      super(gvh, course, THINK_MS);
      motion = new Motioncontrol(gvh);
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
      Circle avoid = new Circle(around(home, REACH_MM), MOST_RADIUS_MM * rng.nextDouble());
      motion.do_move(new ItemPosition("place" + round, to.xMm(), to.yMm()), avoid);
      await(() -> motion.motionflag().get() != MotionFlag.MOVING);
      return motion.motionflag().get() == MotionFlag.DONE;
    }

    private Point around(Point centre, double mostMm) {
      double angle = 2 * Math.PI * rng.nextDouble();
      double mm = mostMm * rng.nextDouble();
      return new Point(
          centre.xMm() + mm * StrictMath.cos(angle), centre.yMm() + mm * StrictMath.sin(angle));
    }
  }
}
