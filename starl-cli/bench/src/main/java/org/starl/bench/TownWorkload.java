package org.starl.bench;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.FlowingCar;
import org.starl.apps.intersection.logic.RoadsideUnit;
import org.starl.apps.intersection.logic.Route;
import org.starl.apps.intersection.logic.Zone;
import org.starl.apps.intersection.robot.Car;
import org.starl.apps.intersection.robot.Floor;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.random.Rng;
import org.starl.sim.Director;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimControl;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.time.Time;

/**
 * B4b: N cars at N/4 intersections of the paper's Figure 2, in one run. Each intersection has three
 * roadside units, its own positioning system, and one car on each arm: a car that has crossed leaves,
 * and another one, on a route drawn by seed, enters its arm as soon as the place is free. The radio
 * reaches 6 m; the intersections are 12 m apart. 60 s, without monitors.
 */
public final class TownWorkload implements Workload {

  private static final int ARMS = 4;
  private static final double APART_MM = 12_000;
  private static final double RANGE_MM = 6_000;
  private static final Duration DURATION = Duration.ofSeconds(60);
  private static final long LOOK_EVERY_NS = 100 * Time.NS_PER_MS;

  @Override
  public String name() {
    return "b4b";
  }

  @Override
  public String summary() {
    return "a town: one intersection for each four cars, which keep coming";
  }

  @Override
  public Simulation.Builder plan(int robots, Style style, long seed) {
    if (robots < ARMS || robots % ARMS != 0) {
      throw new BadInput("b4b: " + robots + " robots: expected a multiple of " + ARMS);
    }
    if (style != Style.BLOCKING) {
      throw new BadInput("b4b: style step: expected blocking");
    }
    return plan(robots, new Town(robots / ARMS, new Rng(seed).fork("town")), seed);
  }

  static Simulation.Builder plan(int robots, Town town, long seed) {
    SimSettings settings = SimSettings.builder().radioRange(RANGE_MM).duration(DURATION).build();
    Simulation.Builder simulation =
        Simulation.builder().name("b4b").seed(seed).settings(settings).director(town);
    town.units().forEach(simulation::robot);
    town.cars().forEach(simulation::robot);
    return simulation;
  }

  /** Lets cars come and go at all intersections. */
  static final class Town implements Director {

    private final List<Arm> arms = new ArrayList<>();
    private final List<RobotSpec> units = new ArrayList<>();
    private final int[] crossed;

    Town(int crossings, Rng rng) {
      crossed = new int[crossings];
      int side = (int) Math.ceil(Math.sqrt(crossings));
      for (int i = 0; i < crossings; i++) {
        int row = i / side;
        Point origin = new Point(APART_MM * (i % side), APART_MM * row);
        String xid = "crossing" + i;
        Participants posts = addUnits(i, xid, origin);
        for (Zone zone : Zone.values()) {
          arms.add(new Arm(i, zone, xid, "car" + i + "-" + zone + "-", origin, posts, rng));
        }
      }
    }

    private Participants addUnits(int crossing, String xid, Point origin) {
      SortedMap<RobotId, Point> posts = new TreeMap<>();
      for (Point at : Floor.roadsideUnits()) {
        posts.put(new RobotId("unit" + crossing + "-" + posts.size()), at);
      }
      Participants ids = Participants.of(posts.keySet());
      posts.forEach((id, at) ->
          units.add(
              new RobotSpec(
                  id,
                  Pose.of(at.plus(origin), 0),
                  true,
                  gvh -> new RoadsideUnit(gvh, xid, ids),
                  origin)));
      return ids;
    }

    List<RobotSpec> units() {
      return units;
    }

    /** The first car of each arm. */
    List<RobotSpec> cars() {
      return arms.stream().map(Arm::next).toList();
    }

    /** Number of cars that have crossed so far. */
    int crossed() {
      return Arrays.stream(crossed).sum();
    }

    /** At each intersection. */
    List<Integer> crossedAt() {
      return Arrays.stream(crossed).boxed().toList();
    }

    @Override
    public void direct(SimControl control) {
      for (Arm arm : arms) {
        if (arm.car != null && control.isFinished(arm.car)) {
          control.leave(arm.car);
          arm.car = null;
          crossed[arm.crossing]++;
        }
        if (arm.car == null && control.isFree(arm.start())) {
          control.join(arm.next());
        }
      }
      control.at(control.nowNs() + LOOK_EVERY_NS, () -> direct(control));
    }
  }

  /** One arm of an intersection, with the car that came in on it. */
  private static final class Arm {
    private final int crossing;
    private final Zone zone;
    private final String xid;
    private final String prefix;
    private final Point origin;
    private final Participants units;
    private final Rng rng;
    private final List<Route> routes = new ArrayList<>();
    private int count;
    private @Nullable RobotId car;

    Arm(
        int crossing,
        Zone zone,
        String xid,
        String prefix,
        Point origin,
        Participants units,
        Rng rng) {
      this.crossing = crossing;
      this.zone = zone;
      this.xid = xid;
      this.prefix = prefix;
      this.origin = origin;
      this.units = units;
      this.rng = rng.fork(prefix);
      Route.all().stream().filter(route -> route.from() == zone).forEach(routes::add);
    }

    Pose start() {
      Pose local = Crossing.placePose(zone, Crossing.PLACES - 1);
      return Pose.of(local.at().plus(origin), local.headingRad());
    }

    /** The next car of this arm. */
    RobotSpec next() {
      Route route = routes.get(rng.nextInt(routes.size()));
      Car local = Car.on(route, Crossing.PLACES - 1, prefix + count, 0);
      count++;
      car = local.id();
      return new RobotSpec(
          local.id(), start(), true, gvh -> new FlowingCar(gvh, xid, local.trip(), units), origin);
    }
  }
}
