package org.starl.cli.request;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import org.starl.apps.Demos;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.launch.DeploymentCheck;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.Limits;
import org.starl.robot.file.Positions;
import org.starl.robot.file.RobotEntry;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.SimulationFailed;
import org.starl.sim.SimulationPlan;
import org.starl.time.Time;

/** The app of a deployment, with its parameters. */
public final class DeployedApp {

  private final Deployment deployment;
  private final RunRequest request;

  private DeployedApp(Deployment deployment, RunRequest request) {
    this.deployment = deployment;
    this.request = request;
  }

  /**
   * @throws BadInput if the app or a parameter is unknown, or a value is invalid
   */
  public static DeployedApp of(Deployment deployment, Demos demos) {
    if (deployment.app().isEmpty()) {
      throw BadInput.at(
          deployment.file(), 1, "has no 'app:'; expected an app of 'starl list' on this machine");
    }
    RunRequest.Builder request =
        RunRequest.Builder.of(demos, deployment.app(), deployment.where(ScenarioFile.APP), "");
    simulated(deployment, deployment.app(), request);
    return new DeployedApp(deployment, request.build());
  }

  /**
   * Gives a request what a deployment says: the settings with which the simulator has the limits and
   * errors of the real robots, and, if the deployment is for this app, its parameters and number of
   * robots. So maps, distances and monitors allow for them in simulated runs, on robots and when
   * traces are merged.
   *
   * @throws BadInput if a value is invalid, or the parameters have such a setting with another value
   */
  static void simulated(Deployment deployment, String app, RunRequest.Builder request) {
    Map<String, String> given = app.equals(deployment.app()) ? deployment.parameters() : Map.of();
    Map<String, String> errors = errors(deployment);
    Map<String, String> all = new LinkedHashMap<>(errors);
    all.put(Setting.MESSAGE_LOSS.key(), Quantities.numberText(deployment.network().loss()));
    if (app.equals(deployment.app())) {
      all.put(Setting.ROBOTS.key(), Integer.toString(deployment.robots().size()));
      // Drawn starts stay where the file has them: bodies on a real floor are not drawn again.
      all.put(Setting.START_SPACING.key(), Setting.START_SPACING.defaultText());
    }
    given.forEach((key, value) -> {
      request.set(deployment.where(key), key, value);
      all.remove(key);
      String own = errors.get(key);
      if (own != null && !settings(key, value).equals(settings(key, own))) {
        throw deployment.error(key, value, own + ", as the deployment's own lines say");
      }
    });
    all.forEach((key, value) -> request.set(deployment.where("limits"), key, value));
  }

  private static SimSettings settings(String key, String value) {
    return SimSettings.builder().set(key, value).build();
  }

  /** The errors and limits of its robots, as settings of the simulator. */
  private static Map<String, String> errors(Deployment deployment) {
    Limits limits = deployment.limits();
    Positions positions = deployment.positions();
    Map<String, String> settings = new LinkedHashMap<>();
    settings.put(
        Setting.REACTION.key(), Quantities.durationText(limits.reactionMs() * Time.NS_PER_MS));
    settings.put(Setting.SPEED_ERROR.key(), Quantities.numberText(limits.speedError()));
    settings.put(Setting.MAX_SPEED.key(), Quantities.speedText(limits.speedMmPerS()));
    settings.put(Setting.POSITION_NOISE.key(), Quantities.distanceText(positions.errorMm()));
    settings.put(Setting.HEADING_NOISE.key(), Quantities.angleText(positions.errorRad()));
    return settings;
  }

  /**
   * Its robots, monitors and world, new ones at each call.
   *
   * @throws BadInput if a value is invalid, or the deployment has other robots
   */
  public SimulationPlan plan() {
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

  /** The areas of the floor that the app's drawing names. */
  public SortedMap<String, Rectangle> areas() {
    return request.plan(deployment.seed()).layer().areas();
  }

  /**
   * Starts all programs at the scenario's starts, and simulates them until {@code endNs}.
   *
   * @return a line for each problem
   */
  public List<String> rehearse(long endNs, SimObserver observer) {
    List<String> problems = new ArrayList<>();
    try {
      SimResult result =
          request
              .plan(deployment.seed())
              .simulation()
              .endNs(endNs)
              .observer(observer)
              .build()
              .run();
      // At the early end, a specification of the whole run may lack what comes later.
      result.spec().violations().stream()
          .filter(violation -> result.isFinished() || violation.timeNs() < result.endNs())
          .forEach(violation -> problems.add("simulated: VIOLATED: " + violation));
    } catch (BadInput | SimulationFailed e) {
      problems.add(String.valueOf(e.getMessage()));
    }
    problems.replaceAll(problem -> deployment.where(ScenarioFile.APP) + problem);
    return problems;
  }

  /**
   * Refuses robots without the ports that the app needs, and starts at which no program can begin.
   *
   * @throws BadInput with the first problem
   */
  public void require() {
    List<String> problems = new ArrayList<>(DeploymentCheck.ofPorts(deployment, plan().objects()));
    problems.addAll(rehearse(1, new SimObserver() {}));
    if (!problems.isEmpty()) {
      throw new BadInput(problems.get(0));
    }
  }
}
