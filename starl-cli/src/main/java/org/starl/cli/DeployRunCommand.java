package org.starl.cli;

import java.io.IOException;
import java.util.concurrent.Callable;
import org.starl.input.BadInput;
import org.starl.launch.Console;
import org.starl.launch.GuardProcess;
import org.starl.launch.RobotRun;
import org.starl.robot.CreateWheelbase;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.Limits;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels.Create;
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
    if (!(entry.wheels() instanceof Create create)) {
      String text = ": this robot is simulated; run it with 'starl deploy world'";
      throw BadInput.at(deployment.file(), entry.line(), "robots." + robot + text);
    }
    Limits limits = deployment.limits();
    Wheelbase.Source wheels =
        CreateWheelbase.of(
            robot, create, limits, GuardProcess.links(create.port(), create.baud(), limits));
    Console console = new Console(out()::println);
    RobotRun run = options.robot(deployment, entry, app, wheels, console);
    UntilStopped stop = new UntilStopped(run::stop);
    int status = ExitStatus.VIOLATED;
    try {
      status = run.run() == null ? ExitStatus.GOOD : ExitStatus.VIOLATED;
      return status;
    } finally {
      console.close();
      stop.ended();
      if (console.isStuck()) {
        // The caller would wait for the output, too.
        Runtime.getRuntime().halt(status);
      }
    }
  }
}
