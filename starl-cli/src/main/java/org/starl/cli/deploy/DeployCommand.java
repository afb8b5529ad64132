package org.starl.cli.deploy;

import org.starl.cli.command.BaseCommand;
import picocli.CommandLine.Command;
import picocli.CommandLine.ParameterException;

/** {@code starl deploy}. */
@Command(
    name = "deploy",
    description =
        "Runs an app on real robots, as a deployment file describes; see docs/deployment.md.",
    subcommands = {
      DeployCheckCommand.class,
      DeployMergeCommand.class,
      DeployPlanCommand.class,
      DeployRunCommand.class,
      DeployTakeCommand.class,
      DeployWorldCommand.class
    },
    footer = {"", "Example: starl deploy check scenarios/deployment/crossing.yaml"})
public final class DeployCommand extends BaseCommand implements Runnable {

  @Override
  public void run() {
    throw new ParameterException(spec().commandLine(), "no command");
  }
}
