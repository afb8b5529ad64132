package org.starl.cli;

import static java.util.stream.Collectors.joining;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.starl.Version;
import org.starl.apps.Demos;
import org.starl.cli.bench.BenchCommand;
import org.starl.cli.campaign.CampaignCommand;
import org.starl.cli.campaign.CiCommand;
import org.starl.cli.campaign.ExploreCommand;
import org.starl.cli.campaign.MergeCommand;
import org.starl.cli.campaign.MutantsCommand;
import org.starl.cli.campaign.SweepCommand;
import org.starl.cli.command.Apps;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.MissingDependencyException;
import org.starl.cli.command.ProgressLine;
import org.starl.cli.command.UntilStopped;
import org.starl.cli.deploy.DeployCommand;
import org.starl.cli.deploy.KeygenCommand;
import org.starl.cli.deploy.SimulatedCreateCommand;
import org.starl.cli.lang.CheckCommand;
import org.starl.cli.lang.CompileCommand;
import org.starl.cli.lang.LanguageServerCommand;
import org.starl.cli.lang.ProveCommand;
import org.starl.cli.project.NewCommand;
import org.starl.cli.run.CompareCommand;
import org.starl.cli.run.DeterminismCommand;
import org.starl.cli.run.RecordCommand;
import org.starl.cli.run.ReplayCommand;
import org.starl.cli.run.RobotCommand;
import org.starl.cli.run.RunCommand;
import org.starl.cli.schema.SchemaCommand;
import org.starl.cli.serve.ServeCommand;
import org.starl.input.BadInput;
import org.starl.input.FailureText;
import org.starl.launch.StackTraces;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.HelpCommand;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.OverwrittenOptionException;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;
import picocli.CommandLine.UnmatchedArgumentException;

/** {@code starl}: programs, simulates and checks distributed robots. */
@Command(
    name = "starl",
    description = "Programs, simulates and checks distributed robots.",
    footer = {
      "",
      "Example: starl run intersection",
      "Run all tests: starl test",
      "Check all proofs: starl prove",
      "Build the app for phones: starl apk",
      "Install StarL for projects of your own: starl install"
    })
public final class Main implements BaseCommand.Root, Runnable {

  private static final List<Class<?>> COMMANDS =
      List.of(
          ListCommand.class,
          RunCommand.class,
          CampaignCommand.class,
          CiCommand.class,
          MutantsCommand.class,
          MergeCommand.class,
          SweepCommand.class,
          ExploreCommand.class,
          CheckCommand.class,
          ProveCommand.class,
          DeterminismCommand.class,
          RecordCommand.class,
          ReplayCommand.class,
          CompareCommand.class,
          ServeCommand.class,
          SchemaCommand.class,
          CompletionCommand.class,
          CompileCommand.class,
          LanguageServerCommand.class,
          NewCommand.class,
          BenchCommand.class,
          DeployCommand.class,
          KeygenCommand.class,
          RobotCommand.class,
          SimulatedCreateCommand.class,
          HelpCommand.class);

  @Option(
      names = "--stacktrace",
      scope = ScopeType.INHERIT,
      description = "Print the stack trace of an error, for bug reports.")
  private boolean stacktrace;

  @Spec private @Nullable CommandSpec spec;

  private final Demos demos;
  private final UntilStopped stop;

  private Main(Demos demos, UntilStopped stop) {
    this.demos = demos;
    this.stop = stop;
  }

  public static void main(String[] args) {
    Locale.setDefault(Locale.ROOT); // not all languages have the digits of traces and commands
    PrintWriter err = new PrintWriter(System.err, true, StandardCharsets.UTF_8);
    UntilStopped stop =
        new UntilStopped(
            done -> err.println("starl: interrupted" + (done.isEmpty() ? "" : " after " + done)));
    stop.listen();
    PrintWriter out =
        new PrintWriter(new StandardOutput(stop::ended), true, StandardCharsets.UTF_8);
    int status;
    try {
      status = run(stop, out, err, args);
    } finally {
      stop.ended();
    }
    System.exit(status);
  }

  /** Runs a command line, including the apps on the class path; returns its exit status. */
  public static int run(PrintWriter out, PrintWriter err, String... args) {
    return run(new UntilStopped(done -> {}), out, err, args);
  }

  private static int run(UntilStopped stop, PrintWriter out, PrintWriter err, String... args) {
    Demos demos;
    try {
      checkNames(args);
      demos = Apps.installed();
    } catch (BadInput error) {
      err.println("starl: " + error.getMessage());
      return ExitStatus.BAD_INPUT;
    }
    return run(demos, stop, out, err, args);
  }

  /**
   * Refuses names that Java cannot read in this locale: it would write into another folder.
   *
   * @throws BadInput at the first
   */
  private static void checkNames(String... args) {
    String locale = System.getProperty("sun.jnu.encoding", "UTF-8");
    List<String> names = new ArrayList<>(List.of(args));
    names.add(System.getProperty("user.dir", ""));
    for (String name : names) {
      if (name.indexOf('\uFFFD') >= 0 && !locale.equals("UTF-8")) {
        String problem = ": this locale's characters, " + locale + ", cannot name it; expected ";
        throw new BadInput(BadInput.quote(name) + problem + "LC_ALL=C.UTF-8");
      }
    }
  }

  /** Runs a command line with these apps. */
  static int run(Demos demos, PrintWriter out, PrintWriter err, String... args) {
    return run(demos, new UntilStopped(done -> {}), out, err, args);
  }

  private static int run(
      Demos demos, UntilStopped stop, PrintWriter out, PrintWriter err, String... args) {
    Main main = new Main(demos, stop);
    CommandLine commandLine = commandLine(main, commands(args));
    commandLine.setOut(out).setErr(err);
    commandLine.setCaseInsensitiveEnumValuesAllowed(true);
    commandLine.setParameterExceptionHandler(Main::refuse);
    commandLine.setExecutionExceptionHandler(
        (error, command, parsed) -> main.report(error, command.getErr()));
    int status = commandLine.execute(args);
    if (out.checkError()) { // flushes, too
      err.println("starl: standard output cannot be written; expected a file or a pipe with room");
      status = ExitStatus.BAD_INPUT;
    }
    err.flush();
    return status;
  }

  /** All commands. */
  static CommandLine commandLine(Demos demos) {
    return commandLine(new Main(demos, new UntilStopped(done -> {})), COMMANDS);
  }

  private static CommandLine commandLine(Main main, List<Class<?>> commands) {
    CommandLine commandLine = new CommandLine(main);
    commands.forEach(commandLine::addSubcommand);
    addHelp(commandLine);
    commandLine.setUsageHelpWidth(Math.clamp(ProgressLine.columns(), 55, 80)); // its least
    return commandLine;
  }

  /**
   * The command that the first word names; else all of them, which {@code help} needs too. The parser
   * reads the options of each command that it has by reflection, which is most of its work.
   */
  private static List<Class<?>> commands(String... args) {
    String first = args.length == 0 ? "" : args[0];
    for (Class<?> command : COMMANDS) {
      if (command != HelpCommand.class
          && command.getAnnotation(Command.class).name().equals(first)) {
        return List.of(command);
      }
    }
    return COMMANDS;
  }

  private static void addHelp(CommandLine command) {
    CommandSpec spec = command.getCommandSpec();
    if (command.getCommand() instanceof HelpCommand) { // has its own option --help
      spec.usageMessage().description("Prints the help text of a command.");
    } else {
      spec.mixinStandardHelpOptions(true).version("StarL " + Version.STARL);
    }
    command.getSubcommands().values().forEach(Main::addHelp);
  }

  @Override
  public UntilStopped stop() {
    return stop;
  }

  @Override
  public Demos demos() {
    return demos;
  }

  @Override
  public void run() {
    if (spec != null) {
      throw new ParameterException(
          spec.commandLine(),
          "no command; begin with 'starl run hello', 'starl list' or 'starl new my-robots'");
    }
  }

  private static int refuse(ParameterException error, String[] args) {
    CommandSpec command = error.getCommandLine().getCommandSpec();
    String help = "; see '" + command.qualifiedName() + " --help'";
    error.getCommandLine().getErr().println("starl: " + problem(error) + help);
    return ExitStatus.BAD_INPUT;
  }

  /** What the parser refuses: what was given, and what was expected. */
  private static String problem(ParameterException error) {
    String given = error.getValue() == null ? "" : BadInput.quote(error.getValue()) + ": ";
    ArgSpec at = error.getArgSpec();
    return switch (error) {
      case UnmatchedArgumentException more ->
          BadInput.quote(more.getUnmatched().getFirst()) + ": " + hint(more);
      case MissingParameterException less when !less.getMissing().isEmpty() ->
          "expected "
              + less.getMissing().stream()
                  .map(Main::form)
                  .collect(joining(less.getMissing().get(0).group() == null ? " " : " or "));
      case OverwrittenOptionException twice -> form(twice.getOverwritten()) + ": expected it once";
      case ParameterException other when at != null ->
          form(at) + ": " + given + "expected " + values(at);
      case ParameterException other when !given.isEmpty() -> given + "expected a command";
      default -> String.valueOf(error.getMessage());
    };
  }

  private static String form(ArgSpec argument) {
    boolean isFlag = argument.arity().max() == 0;
    return argument instanceof OptionSpec option
        ? option.longestName() + (isFlag ? "" : "=" + option.paramLabel())
        : argument.paramLabel();
  }

  private static String values(ArgSpec argument) {
    Object[] names = argument.type().getEnumConstants();
    return names != null
        ? "one of " + Arrays.stream(names).map(Object::toString).collect(joining(", "))
        : argument.arity().max() == 0 ? "no value" : argument.paramLabel();
  }

  private static String hint(UnmatchedArgumentException unmatched) {
    List<String> near = unmatched.getSuggestions();
    if (!near.isEmpty()) {
      return "did you mean " + String.join(" or ", near) + "?";
    }
    Set<String> commands = unmatched.getCommandLine().getSubcommands().keySet();
    return "expected "
        + (commands.isEmpty() ? "nothing more" : "one of " + String.join(" ", commands));
  }

  private int report(Exception error, PrintWriter err) {
    if (stacktrace) {
      err.print(StackTraces.of(error));
    }
    if (error instanceof BadInput) {
      err.println("starl: " + error.getMessage());
      return ExitStatus.BAD_INPUT;
    }
    if (error instanceof IOException && error.getMessage() != null) {
      // A file that cannot be written: nothing was violated.
      err.println(
          "starl: "
              + (error instanceof FileSystemException file && file.getFile() != null
                  ? FailureText.of(file.getFile(), error)
                  : error.getMessage()));
      return ExitStatus.BAD_INPUT;
    }
    if (error instanceof MissingDependencyException) {
      err.println("starl: " + error.getMessage());
      return ExitStatus.MISSING_DEPENDENCY;
    }
    String message = error.getMessage();
    String line = message == null ? error.toString() : message;
    err.println("starl: " + line + (stacktrace ? "" : " (--stacktrace shows details)"));
    return ExitStatus.VIOLATED;
  }
}
