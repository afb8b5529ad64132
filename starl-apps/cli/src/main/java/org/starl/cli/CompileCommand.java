package org.starl.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.lang.java.JavaSources;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code starl compile}. */
@Command(
    name = "compile",
    description = {
      "Checks the automata of a .starl file, and makes Java of them.",
      "Errors are printed one a line, as FILE:LINE:COLUMN: what was found; what was expected. Then no"
          + " file is written."
    },
    footer = {
      "",
      "Example: starl compile pvs/starl/Mutex_decls.starl --java starl-primitives/src/main/java"
    })
final class CompileCommand extends BaseCommand implements Callable<Integer> {

  @Parameters(index = "0", paramLabel = "FILE", description = "The source.")
  private String file = "";

  @Option(
      names = "--java",
      paramLabel = "FOLDER",
      description =
          "Write the executable form of each automaton below this folder of Java sources: the class"
              + " that the source names, and its actions.")
  private @Nullable String java;

  @Override
  public Integer call() throws IOException {
    Map<String, String> files = new TreeMap<>();
    try {
      for (Automaton automaton : automata()) {
        if (java != null) {
          files.putAll(JavaSources.of(automaton, file));
        }
        out().println(automaton.name() + ": " + automaton.actions().size() + " actions");
      }
    } catch (SourceErrors e) {
      e.errors().forEach(err()::println);
      return ExitStatus.BAD_INPUT;
    }
    for (Map.Entry<String, String> each : files.entrySet()) {
      write("--java", Path.of(String.valueOf(java)).resolve(each.getKey()), each.getValue());
    }
    return ExitStatus.GOOD;
  }

  private List<Automaton> automata() throws SourceErrors {
    try {
      return new SourceReader().read(Path.of(file));
    } catch (IOException | InvalidPathException e) {
      throw new BadInput(
          BadInput.quote(file) + ": cannot be read (" + e + "); expected a .starl file");
    }
  }

  private void write(String option, Path path, String text) throws IOException {
    try (OutputFile output = new OutputFile(option, path.toString())) {
      output.stream().write(text.getBytes(StandardCharsets.UTF_8));
    }
    out().println(path);
  }
}
