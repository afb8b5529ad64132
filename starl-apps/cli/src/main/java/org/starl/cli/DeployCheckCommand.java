package org.starl.cli;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.starl.launch.DeploymentCheck;
import org.starl.launch.DeploymentFile;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels.Create;
import org.starl.sim.SimulationPlan;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code starl deploy check}. */
@Command(
    name = "check",
    description =
        "Checks a deployment without running it: file, app, parameters, key and hosts. With"
            + " --robot, also the device, address and port of that robot's machine.",
    mixinStandardHelpOptions = true,
    footer = {"", "Example: starl deploy check crossing.yaml --robot bot0 --probe"})
final class DeployCheckCommand extends BaseCommand implements Callable<Integer> {

  @Parameters(index = "0", paramLabel = "FILE", description = "A deployment file.")
  private String file = "";

  @Option(
      names = "--robot",
      paramLabel = "NAME",
      description = "The robot of this machine: also check its device, address and port.")
  private @Nullable String robot;

  @Option(
      names = "--probe",
      description = "Also connect to the TCP servers: the world, and the Creates' serial servers.")
  private boolean probes;

  @Mixin private JsonOption json = new JsonOption();

  @Override
  public Integer call() {
    Deployment deployment = DeploymentFile.read(file);
    RobotEntry here = robot == null ? null : deployment.robot(robot);
    SimulationPlan blueprint = DeployedApp.of(deployment, demos()).blueprint();
    DeploymentFile.key(deployment);
    List<String> problems = new ArrayList<>(DeploymentCheck.of(deployment, here, probes));
    problems.addAll(DeploymentCheck.ofMotion(deployment, blueprint.settings().motionParameters(0)));
    PrintWriter out = out();
    PrintWriter err = err();
    if (json.isOn()) {
      Map<String, Object> result = new LinkedHashMap<>();
      result.put("file", file);
      result.put("app", deployment.app());
      result.put("robots", deployment.robots().keySet().stream().map(String::valueOf).toList());
      result.put("problems", problems);
      out.println(Json.line(result));
    } else {
      problems.forEach(problem -> err.println("starl: " + problem));
      if (problems.isEmpty()) {
        summary(deployment).forEach(out::println);
      }
    }
    return problems.isEmpty() ? ExitStatus.GOOD : ExitStatus.BAD_INPUT;
  }

  private static List<String> summary(Deployment deployment) {
    List<String> lines = new ArrayList<>();
    for (RobotEntry entry : deployment.robots().values()) {
      String wheels =
          entry.wheels() instanceof Create create
              ? create.model()
                  + " at "
                  + create.port()
                  + (create.simulatedAt() == null ? "" : ", simulated at " + create.simulatedAt())
              : "simulated";
      lines.add(
          entry.id()
              + ": radio "
              + (entry.address() == null ? "found by beacons" : entry.address())
              + ", "
              + wheels);
    }
    lines.add(
        deployment.file()
            + ": no problem found: "
            + deployment.app()
            + " with "
            + deployment.robots().size()
            + (deployment.robots().size() == 1 ? " robot" : " robots")
            + (deployment.key() == null
                ? ", no key: any computer on the network can send messages"
                : ", sealed"));
    return lines;
  }
}
