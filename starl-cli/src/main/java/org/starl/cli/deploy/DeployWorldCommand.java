package org.starl.cli.deploy;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Callable;
import java.util.concurrent.LinkedBlockingQueue;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.request.DeployedApp;
import org.starl.input.BadInput;
import org.starl.launch.Console;
import org.starl.launch.RobotRun;
import org.starl.launch.WorldServer;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code starl deploy world}. */
@Command(
    name = "world",
    description =
        "Simulates the bodies of a deployment until it is stopped: one floor, a simulated Create at"
            + " the far end of each serial link, and a NatNet server in place of the cameras. Also"
            + " runs the programs of robots that are simulated without a Create.",
    footer = {"", "Example: starl deploy world mixed.yaml"})
final class DeployWorldCommand extends BaseCommand implements Callable<Integer> {

  private static final String WORLD = "world";

  @Mixin private DeployOptions options = new DeployOptions();

  /** Reasons to end; the empty string if the user stopped it. */
  private final BlockingQueue<String> ends = new LinkedBlockingQueue<>();

  @Override
  public Integer call() throws IOException, InterruptedException {
    Deployment deployment = options.deployment();
    DeployedApp app = DeployedApp.of(deployment, demos());
    if (deployment.simulated().isEmpty()) {
      throw new BadInput(
          deployment.file()
              + ": no robot is simulated; expected one with 'kind: simulated' or 'simulatedAt:'");
    }
    app.require();
    options.rounds();
    Console console = new Console(out()::println);
    stop().calls(() -> ends.add(""));
    try (OutputStream trace = options.trace(WORLD);
        WorldServer world =
            new WorldServer(
                deployment,
                app.plan(),
                trace,
                line -> console.accept(WORLD + ": " + line),
                error -> ends.add(String.valueOf(error)))) {
      console.accept(WORLD + ": runs");
      String reason = runPrograms(deployment, app, world, console);
      if (!reason.isEmpty()) {
        err().println(WORLD + ": " + reason);
      }
      return reason.isEmpty() ? ExitStatus.GOOD : ExitStatus.VIOLATED;
    } finally {
      console.close();
      if (console.isStuck()) {
        // The caller would wait for the output, too.
        Runtime.getRuntime().halt(ExitStatus.VIOLATED);
      }
    }
  }

  /** Runs the robots that are simulated without a Create; returns the reason of the end. */
  private String runPrograms(
      Deployment deployment, DeployedApp app, WorldServer world, Console console)
      throws IOException, InterruptedException {
    List<RobotRun> robots = new ArrayList<>();
    try {
      for (RobotEntry entry : deployment.robots().values()) {
        if (entry.wheels() instanceof Wheels.Simulated) {
          RobotRun robot = options.robot(deployment, entry, app, world.wheels(entry.id()), console);
          Thread thread = new Thread(() -> run(robot, entry), entry.id() + " run");
          thread.setDaemon(true);
          thread.start();
          robots.add(robot);
        }
      }
      return ends.take();
    } finally {
      robots.forEach(RobotRun::stop);
      robots.forEach(RobotRun::close);
    }
  }

  /** Runs a robot. If it fails, the whole command ends, as in the simulator. */
  private void run(RobotRun robot, RobotEntry entry) {
    try {
      Throwable failure = robot.run();
      if (failure != null) {
        ends.add(entry.id() + ": " + failure);
      }
    } catch (IOException e) {
      ends.add(entry.id() + ": " + e.getMessage());
    }
  }
}
