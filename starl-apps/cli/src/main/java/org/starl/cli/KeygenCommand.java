package org.starl.cli;

import java.io.IOException;
import java.nio.file.Path;
import org.starl.input.BadInput;
import org.starl.robot.udp.KeyFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** {@code starl keygen}. */
@Command(
    name = "keygen",
    description =
        "Creates the key of a deployment, in a new file that only its owner can read. Any program"
            + " with the key can act as a robot of the deployment.",
    footer = {"", "Example: starl keygen crossing.key"})
final class KeygenCommand extends BaseCommand implements Runnable {

  @Parameters(index = "0", paramLabel = "FILE", description = "The new key file.")
  private String file = "";

  @Override
  public void run() {
    try {
      KeyFile.generate(Path.of(file));
    } catch (IOException e) {
      String message = String.valueOf(e.getMessage());
      throw new BadInput(
          message.startsWith(file) ? message : file + ": cannot be created: " + message);
    }
    out().println(file + ": a new key; copy it to every robot over a secure channel");
  }
}
