package org.starl.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Demo;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.request.RunRequest;
import org.starl.sim.fault.FaultGrammar;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.Parameters;

/** {@code starl completion}. */
@Command(
    name = "completion",
    description =
        "Prints a script with which a shell completes commands, options, apps, settings and faults. It"
            + " has the apps that are there now.",
    footer = {
      "",
      "Example: starl completion bash > ~/.local/share/bash-completion/completions/starl",
      "         starl completion zsh > ~/.starl-completion; source ~/.starl-completion in ~/.zshrc",
      "         starl completion fish > ~/.config/fish/completions/starl.fish"
    })
final class CompletionCommand extends BaseCommand implements Runnable {

  /** A setting's value follows without a blank. */
  private static final String BASH =
      """

      function _starl() {
        _complete_starl
        [ -n "$ZSH_VERSION" ] || [ "${#COMPREPLY[@]}" -ne 1 ] || [[ "${COMPREPLY[0]}" != *= ]] || compopt -o nospace
      }
      complete -F _starl -o default starl
      """;

  /** Whether the words before the cursor begin with a command. */
  private static final String FISH =
      """
      function __starl_at
        set -l words (commandline -opc)
        set -l last (math 1 + (count $argv))
        test "$words[2..$last]" = "$argv"
      end
      """;

  private enum Shell {
    BASH,
    ZSH,
    FISH
  }

  @Parameters(
      index = "0",
      paramLabel = "SHELL",
      description = "The shell: ${COMPLETION-CANDIDATES}.")
  private @Nullable Shell shell;

  @Override
  public void run() {
    CommandLine all = Main.commandLine(demos());
    if (shell == Shell.FISH) {
      out().print(FISH + String.join("\n", fish(all, "")) + "\n");
    } else {
      addValues(all);
      out().print(AutoComplete.bash(all.getCommandName(), all) + BASH);
    }
  }

  private void addValues(CommandLine command) {
    CommandSpec spec = command.getCommandSpec();
    for (OptionSpec option : List.copyOf(spec.options())) {
      List<String> values = values(option);
      // picocli cannot replace an option of a group.
      if (option.group() == null && (!values.isEmpty() || isFile(option))) {
        OptionSpec.Builder builder = OptionSpec.builder(option);
        spec.remove(option);
        spec.add(
            (values.isEmpty() ? builder.type(Path.class) : builder.completionCandidates(values))
                .build());
      }
    }
    for (PositionalParamSpec place : List.copyOf(spec.positionalParameters())) {
      List<String> values = values(place);
      if (!values.isEmpty() || isFile(place)) {
        PositionalParamSpec.Builder builder = PositionalParamSpec.builder(place);
        spec.remove(place);
        spec.add(
            (values.isEmpty() ? builder.type(Path.class) : builder.completionCandidates(values))
                .build());
      }
    }
    command.getSubcommands().values().forEach(this::addValues);
  }

  private static boolean isFile(ArgSpec arg) {
    return arg.paramLabel().matches("(FILE|FOLDER|DIR|TRACE).*");
  }

  /** The values that are known here; else those that the option's type has. */
  private List<String> values(ArgSpec arg) {
    List<String> values = new ArrayList<>();
    switch (arg.paramLabel()) {
      case "APP", "APP|PRIMITIVE", "APP|PRIMITIVE|FILE.yaml", "APP|PRIMITIVE|FILE.yaml|TRACE" ->
          values.addAll(demos().names());
      case "FAULT" -> FaultGrammar.kinds().forEach(kind -> values.add(kind.usage()));
      case "KEY=VALUE" -> {
        TreeSet<String> keys = new TreeSet<>();
        RunRequest.known().forEach(setting -> keys.add(setting.key() + "="));
        for (Demo demo : demos().all()) {
          demo.parameters().forEach(parameter -> keys.add(parameter.key() + "="));
        }
        values.addAll(keys);
      }
      default -> {
        if (arg.completionCandidates() != null) {
          arg.completionCandidates().forEach(values::add);
        }
      }
    }
    return values;
  }

  /**
   * A line of fish for each command, option and value.
   *
   * @param path the command's words after {@code starl}; empty for the main command
   */
  private List<String> fish(CommandLine command, String path) {
    List<String> lines = new ArrayList<>();
    String at =
        path.isEmpty()
            ? "complete -c starl -n 'test (count (commandline -opc)) -eq 1' "
            : "complete -c starl -n '__starl_at " + path + "' ";
    CommandSpec spec = command.getCommandSpec();
    for (OptionSpec option : spec.options()) {
      StringBuilder line = new StringBuilder(at);
      for (String name : option.names()) {
        line.append(name.startsWith("--") ? "-l " : "-s ").append(name.replaceFirst("^-+", ""));
        line.append(' ');
      }
      line.append(option.arity().max() == 0 ? "" : isFile(option) ? "-r " : "-x ");
      lines.add(line + values(values(option)) + "-d " + quoted(summary(option.description())));
    }
    for (PositionalParamSpec place : spec.positionalParameters()) {
      List<String> values = values(place);
      if (!values.isEmpty()) {
        lines.add(at + "-k " + values(values));
      }
    }
    command
        .getSubcommands()
        .forEach((name, sub) -> {
          String[] description = sub.getCommandSpec().usageMessage().description();
          lines.add(at + "-f -a " + name + " -d " + quoted(summary(description)));
          lines.addAll(fish(sub, (path + " " + name).strip()));
        });
    return lines;
  }

  private static String values(List<String> values) {
    // fish expands the words of the argument: each is quoted, too.
    List<String> words = values.stream().map(CompletionCommand::quoted).toList();
    return words.isEmpty() ? "" : "-a " + quoted(String.join(" ", words)) + " ";
  }

  private static String quoted(String text) {
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'";
  }

  /** The first sentence. */
  private static String summary(String[] description) {
    String text = String.join(" ", description).replace("%%", "%");
    int end = text.indexOf(". ");
    return end < 0 ? text : text.substring(0, end);
  }
}
