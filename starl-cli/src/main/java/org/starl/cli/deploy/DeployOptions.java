package org.starl.cli.deploy;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.function.Consumer;
import org.starl.cli.command.OptionValues;
import org.starl.cli.request.DeployedApp;
import org.starl.input.BadInput;
import org.starl.input.FailureText;
import org.starl.launch.DeploymentFile;
import org.starl.launch.RobotRun;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.RobotEntry;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The options of commands that run a deployment's robots or its world. */
final class DeployOptions {

  private static final int MAX_STARTS = 10_000;

  @Parameters(index = "0", paramLabel = "FILE", description = "A deployment file.")
  private String file = "";

  @Option(
      names = "--folder",
      paramLabel = "DIR",
      defaultValue = ".",
      description = "The folder of the traces and the robots' storage (default: ${DEFAULT-VALUE}).")
  private String folder = ".";

  @Option(
      names = "--rounds",
      paramLabel = "N",
      defaultValue = "1",
      description =
          "Number of times that a robot runs its app, each time with a new start of its program"
              + " (default: ${DEFAULT-VALUE}). Only simulated robots can run it more than once,"
              + " because the world puts their bodies back.")
  private String rounds = "1";

  Deployment deployment() {
    return DeploymentFile.read(file);
  }

  /**
   * @throws BadInput unless it is a number from 1 to 1000000
   */
  int rounds() {
    return OptionValues.whole("--rounds", rounds, 1, 1_000_000);
  }

  /** A new trace: {@code bot0.trace}, or {@code bot0.2.trace} if that exists. */
  OutputStream trace(String name) throws IOException {
    for (int start = 1; start < MAX_STARTS; start++) {
      Path path = folder().resolve(name + (start == 1 ? "" : "." + start) + ".trace");
      if (!Files.exists(path)) {
        return new BufferedOutputStream(
            Files.newOutputStream(path, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE));
      }
    }
    throw new IOException(
        "%s has %s traces of %s already; expected an empty --folder"
            .formatted(folder, MAX_STARTS, name));
  }

  /** The run of one robot, with a new trace. The run closes the trace when it ends. */
  RobotRun robot(
      Deployment deployment,
      RobotEntry entry,
      DeployedApp app,
      Wheelbase.Source wheels,
      Consumer<String> console)
      throws IOException {
    RobotRun.Settings settings =
        new RobotRun.Settings(
            deployment,
            entry,
            DeploymentFile.keys(deployment, entry),
            app::plan,
            wheels,
            folder().resolve(entry.id() + ".storage"),
            rounds());
    return new RobotRun(settings, trace(entry.id().name()), console);
  }

  private Path folder() {
    try {
      return Files.createDirectories(Path.of(folder));
    } catch (IOException e) {
      throw new BadInput("--folder: " + folder + ": " + FailureText.of(e) + "; expected a folder");
    }
  }
}
