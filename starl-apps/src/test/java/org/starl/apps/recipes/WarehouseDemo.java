package org.starl.apps.recipes;

import java.util.List;
import org.starl.apps.Demo;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.Form;
import org.starl.primitives.ledger.LedgerSpec;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.paths.TubesSpec;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;

/** Robots of a warehouse at their homes. */
public final class WarehouseDemo implements Demo {

  static final int ROBOTS = 8;

  private static final Parameter ORDERS =
      new Parameter("orders", "8", "crates to carry", Form.whole(1, 40));

  @Override
  public String name() {
    return "warehouse";
  }

  @Override
  public String summary() {
    return "robots carry crates through an aisle";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(ORDERS);
  }

  @Override
  public Envelope envelope() {
    return Envelope.MOVING;
  }

  @Override
  public Plan plan(Request request, SimSettings settings) {
    Simulation.Builder simulation = Simulation.builder().settings(settings);
    int robots = request.robots().orElse(ROBOTS);
    fill(simulation, robots, request.whole(ORDERS), WarehouseApp.Bug.NONE);
    return Plan.of(simulation);
  }

  static void fill(Simulation.Builder simulation, int robots, int orders, WarehouseApp.Bug bug) {
    simulation.obstacles(WarehouseFloor.walls());
    for (int i = 0; i < robots; i++) {
      int number = i;
      RobotId id = new RobotId(simulation.settings().robotName() + i);
      Pose start =
          new Pose(WarehouseFloor.home(i).at().xMm(), WarehouseFloor.home(i).at().yMm(), 0);
      simulation.robot(
          new RobotSpec(id, start, true, gvh -> new WarehouseApp(gvh, number, orders, bug)));
    }
    simulation
        .monitor(() -> new WarehouseSpec(orders))
        .monitor(WarehouseSpec::oneWay)
        .monitor(LedgerSpec::new)
        .monitor(MutexSpec::new)
        .monitor(TubesSpec::new);
  }
}
