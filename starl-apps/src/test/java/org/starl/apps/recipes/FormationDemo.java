package org.starl.apps.recipes;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.Demo;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.AgreementSpec;
import org.starl.primitives.barrier.BarrierSpec;
import org.starl.primitives.paths.TubesSpec;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;

/** Four robots in a row drive to their places in a formation. */
public final class FormationDemo implements Demo {

  static final int ROBOTS = 4;

  @Override
  public String name() {
    return "formation";
  }

  @Override
  public String summary() {
    return "robots agree on a formation and drive to their places";
  }

  /** The faults of --chaos: each robot must come to its place, so none may crash. */
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

  /** Puts the robots in a row, in the reverse order of their places, and adds the monitors. */
  static void fill(Simulation.Builder simulation) {
    List<RobotId> team = new ArrayList<>();
    for (int i = 0; i < ROBOTS; i++) {
      int number = i;
      RobotId id = new RobotId(simulation.settings().robotName() + i);
      team.add(id);
      Pose start = new Pose(4000 - 1000 * i, 400, StrictMath.PI / 2);
      simulation.robot(new RobotSpec(id, start, true, gvh -> new FormationApp(gvh, number)));
    }
    simulation
        .monitor(() -> new FormationSpec(List.copyOf(team)))
        .monitor(AgreementSpec::new)
        .monitor(BarrierSpec::new)
        .monitor(TubesSpec::new);
  }
}
