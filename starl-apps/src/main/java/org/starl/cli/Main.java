package org.starl.cli;

import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import org.jspecify.annotations.Nullable;
import org.starl.sim.BadInput;
import org.starl.sim.Version;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/** {@code starl}: programs, simulates and checks distributed robots. */
@Command(
    name = "starl",
    description = "Programs, simulates and checks distributed robots.",
    mixinStandardHelpOptions = true,
    version = "StarL " + Version.STARL,
    subcommands = {
      ListCommand.class,
      RunCommand.class,
      CampaignCommand.class,
      DeterminismCommand.class,
      RecordCommand.class,
      BenchCommand.class
    },
    footer = {"", "Example: starl run intersection", "Every test: starl test"})
public final class Main implements Runnable {

  @Option(
      names = "--stacktrace",
      scope = ScopeType.INHERIT,
      description = "Show where an error came from, for bug reports.")
  private boolean stacktrace;

  @Spec private @Nullable CommandSpec spec;

  private Main() {}

  public static void main(String[] args) {
    PrintWriter out = new PrintWriter(System.out, true, StandardCharsets.UTF_8);
    PrintWriter err = new PrintWriter(System.err, true, StandardCharsets.UTF_8);
    System.exit(run(out, err, args));
  }

  /** Runs a command line and returns its exit status. */
  public static int run(PrintWriter out, PrintWriter err, String... args) {
    Main main = new Main();
    CommandLine commandLine = new CommandLine(main);
    commandLine.setOut(out).setErr(err);
    commandLine.setCaseInsensitiveEnumValuesAllowed(true);
    commandLine.setParameterExceptionHandler(Main::refuse);
    commandLine.setExecutionExceptionHandler(
        (error, command, parsed) -> main.report(error, command.getErr()));
    int status = commandLine.execute(args);
    out.flush();
    err.flush();
    return status;
  }

  @Override
  public void run() {
    if (spec != null) {
      throw new ParameterException(spec.commandLine(), "no command; see 'starl --help'");
    }
  }

  private static int refuse(ParameterException error, String[] args) {
    String line = String.valueOf(error.getMessage()).lines().findFirst().orElse("bad arguments");
    error.getCommandLine().getErr().println("starl: " + line);
    return ExitStatus.BAD_INPUT;
  }

  private int report(Exception error, PrintWriter err) {
    if (stacktrace) {
      err.println(StackTraces.of(error));
    }
    if (error instanceof BadInput) {
      err.println("starl: " + error.getMessage());
      return ExitStatus.BAD_INPUT;
    }
    String message = error.getMessage();
    String line = message == null ? error.toString() : message;
    err.println("starl: " + line + (stacktrace ? "" : " (--stacktrace shows where)"));
    return ExitStatus.VIOLATED;
  }
}
