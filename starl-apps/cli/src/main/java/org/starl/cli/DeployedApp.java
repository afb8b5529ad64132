package org.starl.cli;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.Demos;
import org.starl.apps.Plan;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.RobotEntry;
import org.starl.sim.Blueprint;
import org.starl.sim.RobotSpec;

/** The app that a deployment names, with its parameters. */
final class DeployedApp {

  private final Deployment deployment;
  private final Chosen chosen;

  private DeployedApp(Deployment deployment, Chosen chosen) {
    this.deployment = deployment;
    this.chosen = chosen;
  }

  /** @throws BadInput if there is no such app, or a parameter is none of its own, or cannot be read */
  static DeployedApp of(Deployment deployment, Demos demos) {
    ScenarioFile file =
        new ScenarioFile(
            deployment.file(), deployment.app(), deployment.parameters(), deployment.lines());
    return new DeployedApp(deployment, file.request(demos).build());
  }

  /**
   * Its run, a fresh one at each call.
   *
   * @throws BadInput if a value cannot be used, or its robots are not those of the deployment
   */
  Plan plan() {
    Plan plan;
    try {
      plan = chosen.plan(deployment.seed());
    } catch (BadInput e) {
      throw new BadInput(deployment.where("app") + e.getMessage());
    }
    return plan;
  }

  /** The same, as robots, monitors and a world. */
  Blueprint blueprint() {
    Blueprint blueprint = plan().simulation().build().blueprint();
    List<RobotId> known = new ArrayList<>();
    blueprint.robots().stream().map(RobotSpec::id).forEach(known::add);
    for (RobotEntry robot : deployment.robots().values()) {
      if (!known.contains(robot.id())) {
        throw new BadInput(
            deployment.file()
                + ":"
                + robot.line()
                + ": robots."
                + robot.id()
                + ": expected the app's robots, "
                + known);
      }
    }
    for (RobotId robot : known) {
      if (!deployment.robots().containsKey(robot)) {
        throw new BadInput(
            deployment.where("app") + "robots: has no " + robot + "; expected the app's, " + known);
      }
    }
    return blueprint;
  }
}
