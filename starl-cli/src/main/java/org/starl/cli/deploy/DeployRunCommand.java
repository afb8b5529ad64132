package org.starl.cli.deploy;

import java.io.IOException;
import java.util.concurrent.Callable;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.request.DeployedApp;
import org.starl.input.BadInput;
import org.starl.launch.Console;
import org.starl.launch.GuardProcess;
import org.starl.launch.RobotRun;
import org.starl.robot.CreateWheelbase;
import org.starl.robot.Ros2;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.Limits;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code starl deploy run}. */
@Command(
    name = "run",
    description =
        "Runs one robot of a deployment on this machine, in real time, until it is stopped. SIGTERM"
            + " and Ctrl-C stop the wheels first.",
    footer = {"", "Example: starl deploy run crossing.yaml --robot bot0"})
final class DeployRunCommand extends BaseCommand implements Callable<Integer> {

  @Mixin private DeployOptions options = new DeployOptions();

  @Option(
      names = "--robot",
      paramLabel = "NAME",
      required = true,
      description = "The robot to run.")
  private String robot = "";

  private Wheelbase.Source wheels(Deployment deployment, RobotEntry entry) {
    Limits limits = deployment.limits();
    return switch (entry.wheels()) {
      case Wheels.Create create ->
          CreateWheelbase.of(
              robot, create, limits, GuardProcess.links(create.port(), create.baud(), limits));
      case Wheels.Ros2 base -> Ros2.of(deployment).wheels(entry, base, limits, GuardProcess::start);
      case Wheels.Simulated simulated -> {
        String text = ": this robot is simulated; run it with 'starl deploy world'";
        throw BadInput.at(deployment.file(), entry.line(), "robots." + robot + text);
      }
    };
  }

  @Override
  public Integer call() throws IOException {
    Deployment deployment = options.deployment();
    RobotEntry entry = deployment.robot(robot);
    DeployedApp app = DeployedApp.of(deployment, demos());
    app.require();
    if (options.rounds() > 1 && !deployment.simulated().contains(entry)) {
      throw new BadInput(
          "--rounds: %s: expected 1, because only simulated robots can start again; %s is real"
              .formatted(options.rounds(), robot));
    }
    if (Ros2.isNeeded(deployment)) {
      Ros2.of(deployment);
    }
    Wheelbase.Source wheels = wheels(deployment, entry);
    Console console = new Console(out()::println);
    RobotRun run = options.robot(deployment, entry, app, wheels, console);
    stop().calls(run::stop);
    int status = ExitStatus.VIOLATED;
    try {
      status = run.run() == null ? ExitStatus.GOOD : ExitStatus.VIOLATED;
      return status;
    } finally {
      console.close();
      if (console.isStuck()) {
        // The caller would wait for the output, too.
        Runtime.getRuntime().halt(status);
      }
    }
  }
}
