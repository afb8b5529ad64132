package org.starl.cli.deploy;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.JsonOption;
import org.starl.cli.request.DeployedApp;
import org.starl.id.RobotId;
import org.starl.launch.DeploymentCheck;
import org.starl.launch.DeploymentFile;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels.Create;
import org.starl.robot.file.Wheels.Ros2;
import org.starl.sim.SimObserver;
import org.starl.sim.SimulationPlan;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Moved;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code starl deploy check}. */
@Command(
    name = "check",
    description =
        "Checks a deployment without running it: file, app, parameters, starts, key and hosts;"
            + " simulates its first seconds. With --robot, also the device, address and port of that robot's machine.",
    footer = {"", "Example: starl deploy check crossing.yaml --robot bot0 --probe"})
final class DeployCheckCommand extends BaseCommand implements Callable<Integer> {

  private static final int SIMULATED_S = 20;

  @Parameters(index = "0", paramLabel = "FILE", description = "A deployment file.")
  private String file = "";

  @Option(
      names = "--robot",
      paramLabel = "NAME",
      description = "The robot of this machine: also check its device, address and port.")
  private @Nullable String robot;

  @Option(
      names = "--probe",
      description =
          "Also connect to the TCP servers (the world, the Creates' serial servers), and wait up to"
              + " 3 s for the cameras.")
  private boolean probes;

  @Mixin private JsonOption json = new JsonOption();

  @Override
  public Integer call() {
    Deployment deployment = DeploymentFile.read(file);
    RobotEntry here = robot == null ? null : deployment.robot(robot);
    DeployedApp app = DeployedApp.of(deployment, demos());
    SimulationPlan plan = app.plan();
    if (here != null) {
      DeploymentFile.keys(deployment, here);
    } else if (deployment.key() != null) {
      DeploymentFile.keys(deployment, deployment.robots().values().iterator().next());
    }
    DeploymentFile.linesKey(deployment);
    List<String> problems = new ArrayList<>(DeploymentCheck.of(deployment, here, probes));
    problems.addAll(DeploymentCheck.ofPorts(deployment, plan.objects()));
    problems.addAll(DeploymentCheck.ofMotion(deployment, plan.settings().motionParameters(0)));
    Set<RobotId> moved = new TreeSet<>();
    problems.addAll(app.rehearse(SIMULATED_S * Time.NS_PER_S, watch(moved)));
    Map<String, Object> result = new LinkedHashMap<>();
    result.put("file", file);
    result.put("app", deployment.app());
    result.put("robots", deployment.robots().keySet().stream().map(String::valueOf).toList());
    result.put("problems", problems);
    json.print(out(), result, problems.isEmpty() ? summary(deployment, moved.size()) : List.of());
    if (!json.isOn()) {
      problems.forEach(problem -> err().println("starl: " + problem));
    }
    return problems.isEmpty() ? ExitStatus.GOOD : ExitStatus.BAD_INPUT;
  }

  private static SimObserver watch(Set<RobotId> moved) {
    return new SimObserver() {
      @Override
      public void observed(TraceEvent event) {
        if (event instanceof Moved move
            && (move.linearMmPerS() != 0 || move.angularRadPerS() != 0)) {
          moved.add(move.robot());
        }
      }
    };
  }

  private static List<String> summary(Deployment deployment, int moved) {
    List<String> lines = new ArrayList<>();
    for (RobotEntry entry : deployment.robots().values()) {
      Object address = entry.address() == null ? "found by beacons" : entry.address();
      lines.add(entry.id() + ": radio " + address + ", " + wheels(entry));
    }
    int robots = deployment.robots().size();
    lines.add(
        "simulated for %s s with these limits and errors: %s of %s moved"
            .formatted(SIMULATED_S, moved, robots));
    lines.add(
        "%s: no problem found: %s with %s %s, %s"
            .formatted(
                deployment.file(),
                deployment.app(),
                robots,
                robots == 1 ? "robot" : "robots",
                deployment.isSealed()
                    ? deployment.hasSeparateKeys()
                        ? "sealed, each robot with its own key"
                        : "sealed with one key: a captured robot can act as any other"
                    : "no key: any computer on the network can send messages"));
    return lines;
  }

  private static String wheels(RobotEntry entry) {
    if (entry.wheels() instanceof Ros2 ros2) {
      return "ROS 2: %s %s, %s"
          .formatted(ros2.command().type(), ros2.command().name(), ros2.odometry().name());
    }
    if (!(entry.wheels() instanceof Create create)) {
      return "simulated";
    }
    String simulated = create.simulatedAt() == null ? "" : ", simulated at " + create.simulatedAt();
    return create.model() + " at " + create.port() + simulated;
  }
}
