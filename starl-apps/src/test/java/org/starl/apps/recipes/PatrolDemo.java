package org.starl.apps.recipes;

import java.util.Map;
import java.util.TreeMap;
import org.starl.apps.Demo;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.primitives.motion.MotionSpec;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;
import org.starl.spec.Require;

/** Four robots, three rounds. */
public final class PatrolDemo implements Demo {

  static final int ROBOTS = 4;
  static final int ROUNDS = 3;
  private static final long BOUND_NS = 900_000_000_000L;

  @Override
  public String name() {
    return "patrol";
  }

  @Override
  public String summary() {
    return "robots patrol on rings that share a corridor";
  }

  /** The faults of --chaos: a mutex with fixed members tolerates no crash. */
  @Override
  public Envelope envelope() {
    return Envelope.NETWORK;
  }

  @Override
  public Plan plan(Request request, SimSettings settings) {
    Simulation.Builder simulation = Simulation.builder().settings(settings);
    fill(simulation);
    return Plan.of(simulation);
  }

  /** Puts each robot at its home, and adds the monitors. */
  static void fill(Simulation.Builder simulation) {
    Map<RobotId, Point> homes = new TreeMap<>();
    for (int i = 0; i < ROBOTS; i++) {
      PatrolApp.Ring ring = PatrolApp.Ring.of(i);
      RobotId id = new RobotId(simulation.settings().robotName() + i);
      homes.put(id, ring.home().at());
      simulation.robot(
          new RobotSpec(
              id,
              Pose.of(ring.home().at(), StrictMath.PI),
              true,
              gvh -> new PatrolApp(gvh, ring, ROUNDS)));
    }
    simulation
        .monitor(() -> Require.neverTwoIn("alone_in_the_corridor", PatrolApp.CORRIDOR))
        .monitor(() -> new PatrolSpec(homes, ROUNDS, BOUND_NS))
        .monitor(MutexSpec::new)
        .monitor(() -> new MotionSpec(simulation.settings().motionParameters(0)));
  }
}
