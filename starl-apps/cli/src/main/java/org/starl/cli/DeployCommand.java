package org.starl.cli;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code starl deploy}. */
@Command(
    name = "deploy",
    description =
        "Runs an app on real robots that a deployment file describes; see docs/deployment.md.",
    mixinStandardHelpOptions = true,
    subcommands = {
      DeployCheckCommand.class,
      DeployMergeCommand.class,
      DeployRunCommand.class,
      DeployWorldCommand.class
    },
    footer = {"", "Example: starl deploy check scenarios/deployment/crossing.yaml"})
final class DeployCommand implements Runnable {

  @Spec private @Nullable CommandSpec spec;

  @Override
  public void run() {
    throw new ParameterException(Objects.requireNonNull(spec).commandLine(), "no command");
  }
}
