package org.starl.cli;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.apps.Demos;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.launch.DeploymentCheck;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.RobotEntry;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
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
    if (deployment.app().isEmpty()) {
      throw BadInput.at(
          deployment.file(), 1, "has no 'app:'; expected an app of 'starl list' on this machine");
    }
    Map<String, String> parameters = new LinkedHashMap<>(deployment.parameters());
    if (deployment.limits().reactionMs() > 0) {
      // The app's maps and monitors allow for it too, here and when the traces are merged.
      parameters.putIfAbsent(Setting.REACTION.key(), deployment.limits().reactionMs() + "ms");
    }
    ScenarioFile file =
        new ScenarioFile(deployment.file(), deployment.app(), parameters, deployment.lines());
    return new DeployedApp(deployment, file.request(demos).build());
  }

  /**
   * Its robots, monitors and world, new ones at each call.
   *
   * @throws BadInput if a value is invalid, or the deployment has other robots
   */
  SimulationPlan plan() {
    SimulationPlan plan;
    try {
      plan = request.plan(deployment.seed()).simulation().build().plan();
    } catch (BadInput e) {
      throw new BadInput(deployment.where("app") + e.getMessage());
    }
    List<RobotId> known = plan.robots().stream().map(RobotSpec::id).toList();
    for (RobotEntry robot : deployment.robots().values()) {
      if (!known.contains(robot.id())) {
        String text = "robots." + robot.id() + ": expected the app's robots, " + known;
        throw BadInput.at(deployment.file(), robot.line(), text);
      }
    }
    for (RobotId robot : known) {
      if (!deployment.robots().containsKey(robot)) {
        throw new BadInput(
            deployment.where("app") + "robots: has no " + robot + "; expected the app's, " + known);
      }
    }
    return plan;
  }

  /**
   * Refuses robots without the ports that the app needs.
   *
   * @throws BadInput with the first problem
   */
  void requirePorts() {
    for (String problem : DeploymentCheck.ofPorts(deployment, plan().objects())) {
      throw new BadInput(problem);
    }
  }
}
