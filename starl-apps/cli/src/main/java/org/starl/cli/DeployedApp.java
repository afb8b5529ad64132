package org.starl.cli;

import java.util.List;
import org.starl.apps.Demos;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.RobotEntry;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimulationPlan;

/** The app of a deployment, with its parameters. */
final class DeployedApp {

  private final Deployment deployment;
  private final RunRequest request;

  private DeployedApp(Deployment deployment, RunRequest request) {
    this.deployment = deployment;
    this.request = request;
  }

  /**
   * @throws BadInput if the app or a parameter is unknown, or a value is invalid
   */
  static DeployedApp of(Deployment deployment, Demos demos) {
    ScenarioFile file =
        new ScenarioFile(
            deployment.file(), deployment.app(), deployment.parameters(), deployment.lines());
    return new DeployedApp(deployment, file.request(demos).build());
  }

  /**
   * Its robots, monitors and world, new ones at each call.
   *
   * @throws BadInput if a value is invalid, or the deployment has other robots
   */
  SimulationPlan blueprint() {
    SimulationPlan blueprint;
    try {
      blueprint = request.plan(deployment.seed()).simulation().build().plan();
    } catch (BadInput e) {
      throw new BadInput(deployment.where("app") + e.getMessage());
    }
    List<RobotId> known = blueprint.robots().stream().map(RobotSpec::id).toList();
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
