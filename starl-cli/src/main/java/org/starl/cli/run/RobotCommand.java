package org.starl.cli.run;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.request.RunOptions;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.SeedOption;
import org.starl.id.RobotId;
import org.starl.launch.RobotProcess;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** One robot of {@code starl run --processes}, which starts this command. */
@Command(
    name = RobotCommand.NAME,
    hidden = true,
    description = "One robot as a process; 'starl run --processes' starts this.")
public final class RobotCommand extends BaseCommand implements Callable<Integer> {

  static final String NAME = "robot";

  @Mixin private RunOptions.OfApp options = new RunOptions.OfApp();

  @Mixin private SeedOption seed = new SeedOption();

  @Parameters(index = "1", description = "The robot's name.")
  private String robot = "";

  @Parameters(index = "2", description = "The folder of its stable storage.")
  private String folder = "";

  @Parameters(index = "3", description = "How many times its app runs.")
  private int rounds;

  @Override
  public Integer call() throws IOException {
    RunRequest request = options.request(demos());
    long seedNumber = seed.value();
    RobotProcess.run(
        () -> request.plan(seedNumber).simulation().build().plan(),
        new RobotId(robot),
        Path.of(folder),
        rounds,
        System.in,
        new FileOutputStream(FileDescriptor.out));
    return ExitStatus.GOOD;
  }
}
