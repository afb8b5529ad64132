package org.starl.cli;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.launch.RobotProcess;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** One robot of {@code starl run --processes}, which starts this command. */
@Command(
    name = RobotCommand.NAME,
    hidden = true,
    description = "One robot as a process; 'starl run --processes' starts this.",
    mixinStandardHelpOptions = true)
final class RobotCommand implements Callable<Integer> {

  static final String NAME = "robot";

  @Mixin private RunOptions options = new RunOptions();

  @Mixin private SeedOption seed = new SeedOption();

  @Parameters(index = "1", description = "The robot's name.")
  private String robot = "";

  @Parameters(index = "2", description = "The folder of its stable storage.")
  private String folder = "";

  @Parameters(index = "3", description = "How many times its app runs.")
  private int rounds;

  @Spec private @Nullable CommandSpec spec;

  @Override
  public Integer call() throws IOException {
    RunRequest chosen = options.chosen(Main.demos(Objects.requireNonNull(spec)));
    long seedNumber = seed.value();
    RobotProcess.run(
        () -> chosen.plan(seedNumber).simulation().build().plan(),
        new RobotId(robot),
        Path.of(folder),
        rounds,
        System.in,
        new FileOutputStream(FileDescriptor.out));
    return ExitStatus.GOOD;
  }
}
