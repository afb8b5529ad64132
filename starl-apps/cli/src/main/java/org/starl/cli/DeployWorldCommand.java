package org.starl.cli;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Callable;
import java.util.concurrent.LinkedBlockingQueue;
import org.jspecify.annotations.Nullable;
import org.starl.deployment.DeploymentFile;
import org.starl.deployment.RobotRun;
import org.starl.deployment.WorldProcess;
import org.starl.input.BadInput;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code starl deploy world}. */
@Command(
    name = "world",
    description =
        "The world of a deployment's simulated bodies, until it is stopped: one floor, a simulated"
            + " Create at the far end of each link, a NatNet server in place of cameras; and the"
            + " programs of the robots that are simulated without a Create.",
    mixinStandardHelpOptions = true,
    footer = {"", "Example: starl deploy world mixed.yaml"})
final class DeployWorldCommand implements Callable<Integer> {

  private static final String WORLD = "world";

  @Parameters(index = "0", paramLabel = "FILE", description = "A deployment file.")
  private String file = "";

  @Option(
      names = "--folder",
      paramLabel = "DIR",
      defaultValue = ".",
      description = "Where world.trace, NAME.trace and NAME.storage are (default: here).")
  private String folder = ".";

  @Option(
      names = "--rounds",
      paramLabel = "N",
      defaultValue = "1",
      description = "How often each robot that is run here runs its app.")
  private String rounds = "1";

  @Spec private @Nullable CommandSpec spec;

  @Override
  public Integer call() throws IOException, InterruptedException {
    CommandSpec command = Objects.requireNonNull(spec);
    Deployment deployment = DeploymentFile.read(file);
    DeployedApp app = DeployedApp.of(deployment, Main.demos(command));
    if (deployment.simulated().isEmpty()) {
      throw new BadInput(
          file + ": no robot is simulated; expected one with 'kind: simulated' or 'simulatedAt:'");
    }
    DeployFolder here = DeployFolder.of(folder);
    int count = (int) Numbers.whole("--rounds", rounds, 1, 1_000_000);
    PrintWriter out = command.commandLine().getOut();
    BlockingQueue<String> end = new LinkedBlockingQueue<>();
    UntilStopped stop = new UntilStopped(() -> end.add(""));
    try (OutputStream trace = here.trace(WORLD);
        WorldProcess world =
            new WorldProcess(
                deployment,
                app.blueprint(),
                trace,
                line -> out.println(WORLD + ": " + line),
                error -> end.add(String.valueOf(error)))) {
      out.println(WORLD + ": runs");
      String why = new Programs(deployment, app, here, count, world, out, end).run();
      if (!why.isEmpty()) {
        command.commandLine().getErr().println(WORLD + ": " + why);
      }
      return why.isEmpty() ? ExitStatus.GOOD : ExitStatus.VIOLATED;
    } finally {
      stop.over();
    }
  }

  /** Of the robots that are simulated without a Create. */
  private record Programs(
      Deployment deployment,
      DeployedApp app,
      DeployFolder here,
      int rounds,
      WorldProcess world,
      PrintWriter out,
      BlockingQueue<String> end) {

    /** Runs them until the end; why it ended, empty if somebody wanted it. */
    String run() throws IOException, InterruptedException {
      List<RobotRun> robots = new ArrayList<>();
      try {
        for (RobotEntry entry : deployment.robots().values()) {
          if (entry.wheels() instanceof Wheels.Simulated) {
            robots.add(start(entry));
          }
        }
        return end.take();
      } finally {
        robots.forEach(RobotRun::stop);
        robots.forEach(RobotRun::close);
      }
    }

    private RobotRun start(RobotEntry entry) throws IOException {
      String name = entry.id().name();
      RobotRun.Settings settings =
          new RobotRun.Settings(
              deployment,
              entry,
              DeploymentFile.key(deployment),
              app::blueprint,
              world.wheels(entry.id()),
              here.storage(name),
              rounds);
      RobotRun run = new RobotRun(settings, here.trace(name), out::println);
      Thread thread = new Thread(() -> run(run, name), name + " run");
      thread.setDaemon(true);
      thread.start();
      return run;
    }

    /** What a robot cannot go on after ends all, as in the simulator. */
    private void run(RobotRun run, String name) {
      try {
        Throwable failure = run.run();
        if (failure != null) {
          end.add(name + ": " + failure);
        }
      } catch (IOException e) {
        end.add(name + ": " + e.getMessage());
      }
    }
  }
}
