package org.starl.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.robot.udp.KeyFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code starl keygen}. */
@Command(
    name = "keygen",
    description =
        "Makes the key of a deployment, in a new file that only its owner may read. Any program with"
            + " the key can act as a robot of the deployment.",
    mixinStandardHelpOptions = true,
    footer = {"", "Example: starl keygen crossing.key"})
final class KeygenCommand implements Runnable {

  @Parameters(index = "0", paramLabel = "FILE", description = "The file to make.")
  private String file = "";

  @Spec private @Nullable CommandSpec spec;

  @Override
  public void run() {
    try {
      KeyFile.generate(Path.of(file));
    } catch (IOException e) {
      String message = String.valueOf(e.getMessage());
      throw new BadInput(
          message.startsWith(file) ? message : file + ": cannot be made: " + message);
    }
    Objects.requireNonNull(spec)
        .commandLine()
        .getOut()
        .println(file + ": a new key; copy it to every robot over a secure channel");
  }
}
