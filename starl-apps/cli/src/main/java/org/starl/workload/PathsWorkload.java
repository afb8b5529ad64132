package org.starl.workload;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.OptimalPlanner;
import org.starl.primitives.paths.PathPlanner;
import org.starl.primitives.paths.RrtPlanner;
import org.starl.primitives.paths.RrtSettings;
import org.starl.primitives.paths.TubeSettings;
import org.starl.primitives.paths.TubesSpec;
import org.starl.random.Rng;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;

/**
 * {@code starl campaign paths}: robots drive to places all over a floor with walls, each in a tube
 * that it has claimed. Who finds no way, or is told that it will not get one, tries elsewhere.
 */
final class PathsWorkload extends PrimitiveDemo {

  private static final long THINK_MS = 500;
  private static final double MARGIN_MM = 500;
  private static final double WALL_MM = 1_200;

  private static final TubeSettings TUBES =
      new TubeSettings(60, 1_000, 30_000, 200, 2_000, 200, 2_000);

  /** The tubes' deadline, and the longest drive with its stops. */
  private static final long TOLD_NS = 600_000_000_000L;

  private static final Parameter PLANNER =
      new Parameter(
          "planner",
          "optimal",
          "how paths are found: optimal or rrt",
          Form.choice(List.of("optimal", "rrt")));

  PathsWorkload() {
    super("paths", "robots drive all over a floor with walls, in tubes that never meet");
  }

  @Override
  public Envelope envelope() {
    return Envelope.SPATIAL;
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(rounds(6), busy("60s"), PLANNER);
  }

  @Override
  void prepare(Simulation.Builder simulation, Request request, SimSettings settings) {
    Course course = course(request);
    int robots = count(request, 1, 16);
    String planner = request.parameter(PLANNER.key());
    if (!planner.equals("optimal") && !planner.equals("rrt")) {
      throw new BadInput("planner=" + BadInput.quote(planner) + ": expected optimal or rrt");
    }
    double sideMm = sideMm(robots);
    place(
        simulation,
        settings,
        robots,
        gvh -> new Traveller(gvh, course, sideMm, planner.equals("optimal")));
    simulation.monitor(() -> new TubesSpec(TOLD_NS));
  }

  /** A wall on the corner between each four robots, this way and that way in turns. */
  @Override
  Obstacles obstacles(Request request) {
    Obstacles walls = Obstacles.NONE;
    int corners = (int) (sideMm(count(request, 1, 16)) / SPACING_MM) - 1;
    for (int i = 0; i < corners * corners; i++) {
      Point at = new Point((i % corners + 1) * SPACING_MM, (i / corners + 1) * SPACING_MM);
      Point half = i % 2 == 0 ? new Point(WALL_MM / 2, 0) : new Point(0, WALL_MM / 2);
      walls = walls.plus(Obstacle.wall(at.minus(half), at.plus(half)));
    }
    return walls;
  }

  private static double sideMm(int robots) {
    return SPACING_MM * Math.ceil(Math.sqrt(robots));
  }

  private static final class Traveller extends Client {
    private final double sideMm;
    private final DistributedPathPlanning paths;

    Traveller(GlobalVarHolder gvh, Course course, double sideMm, boolean isOptimal) {
      super(gvh, course, THINK_MS);
      this.sideMm = sideMm;
      Rectangle floor = new Rectangle(0, 0, sideMm, sideMm);
      paths =
          new DistributedPathPlanning(
              gvh, "floor", gvh.id.participants(), planner(rng, isOptimal), floor, TUBES);
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
      await(() -> !paths.isUnderWay());
      return !paths.failed();
    }

    private double somewhere() {
      return MARGIN_MM + (sideMm - 2 * MARGIN_MM) * rng.nextDouble();
    }
  }
}
