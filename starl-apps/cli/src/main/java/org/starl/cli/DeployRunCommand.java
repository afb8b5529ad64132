package org.starl.cli;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.starl.deployment.ByteLinks;
import org.starl.deployment.DeploymentFile;
import org.starl.deployment.RobotRun;
import org.starl.input.BadInput;
import org.starl.robot.CreateWheelbase;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels.Create;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code starl deploy run}. */
@Command(
    name = "run",
    description =
        "Runs one robot of a deployment on this machine, in real time, until it is stopped: SIGTERM and"
            + " ctrl-C stop the wheels first.",
    mixinStandardHelpOptions = true,
    footer = {"", "Example: starl deploy run crossing.yaml --robot bot0"})
final class DeployRunCommand implements Callable<Integer> {

  @Parameters(index = "0", paramLabel = "FILE", description = "A deployment file.")
  private String file = "";

  @Option(names = "--robot", paramLabel = "NAME", required = true, description = "The robot.")
  private String robot = "";

  @Option(
      names = "--folder",
      paramLabel = "DIR",
      defaultValue = ".",
      description = "Where NAME.trace and NAME.storage are (default: here).")
  private String folder = ".";

  @Option(
      names = "--rounds",
      paramLabel = "N",
      defaultValue = "1",
      description =
          "How often the robot runs its app, each time as a new start; more than once where the world"
              + " is simulated and can put it back to its place.")
  private String rounds = "1";

  @Spec private @Nullable CommandSpec spec;

  @Override
  public Integer call() throws IOException {
    CommandSpec command = Objects.requireNonNull(spec);
    Deployment deployment = DeploymentFile.read(file);
    RobotEntry entry = Objects.requireNonNull(DeployCheckCommand.entry(deployment, robot));
    DeployedApp app = DeployedApp.of(deployment, Main.demos(command));
    app.blueprint();
    int count = (int) Numbers.whole("--rounds", rounds, 1, 1_000_000);
    if (count > 1 && !deployment.simulated().contains(entry)) {
      throw new BadInput("--rounds: " + rounds + ": expected 1: nobody puts " + robot + " back");
    }
    if (!(entry.wheels() instanceof Create create)) {
      throw new BadInput(
          file
              + ":"
              + entry.line()
              + ": robots."
              + robot
              + ": is simulated; 'starl deploy world' runs it");
    }
    DeployFolder here = DeployFolder.of(folder);
    RobotRun.Settings settings =
        new RobotRun.Settings(
            deployment,
            entry,
            DeploymentFile.key(deployment),
            app::blueprint,
            CreateWheelbase.of(
                robot, create, deployment.limits(), ByteLinks.of(create.port(), create.baud())),
            here.storage(robot),
            count);
    PrintWriter out = command.commandLine().getOut();
    OutputStream trace = here.trace(robot);
    RobotRun run = new RobotRun(settings, trace, out::println);
    UntilStopped stop = new UntilStopped(run::stop);
    try (trace) {
      return run.run() == null ? ExitStatus.GOOD : ExitStatus.VIOLATED;
    } finally {
      stop.over();
    }
  }
}
