package org.starl.cli.deploy;

import java.io.IOException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.starl.cli.command.BaseCommand;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.FailureText;
import org.starl.robot.udp.KeyFile;
import org.starl.robot.udp.RobotKey;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code starl keygen}. */
@Command(
    name = "keygen",
    description = {
      "Creates a key in a new file that only its owner can read.",
      "With --robot, the key of one robot: copy the printed line into the deployment file, and the"
          + " file to that robot only. A robot that is stolen can then speak in its own name only.",
      "Without, one key for all robots of a deployment: any program that has it can act as any of"
          + " them."
    },
    footer = {
      "",
      "Examples: starl keygen --robot bot0 bot0.key",
      "          starl keygen crossing.key"
    })
public final class KeygenCommand extends BaseCommand implements Runnable {

  @Option(names = "--robot", paramLabel = "NAME", description = "The robot that gets the key.")
  private @Nullable String robot;

  @Parameters(index = "0", paramLabel = "FILE", description = "The new key file.")
  private String file = "";

  @Override
  public void run() {
    if (robot != null && !RobotId.isValid(robot)) {
      throw new BadInput("--robot: " + BadInput.quote(robot) + ": expected a robot's name");
    }
    try {
      if (robot == null) {
        KeyFile.generate(Path.of(file));
        out().println(file + ": a new key; copy it to every robot over a secure channel");
      } else {
        String publicKey = RobotKey.generate(Path.of(file)).toString();
        out().println("    publicKey: " + publicKey);
        err()
            .println(
                "%s: a new key: put it on %s only, as %s.key in the deployment file's folder; the"
                        .formatted(file, robot, robot)
                    + " line above belongs beneath robots."
                    + robot);
      }
    } catch (IOException e) {
      throw new BadInput(FailureText.of(file, e));
    }
  }
}
