package org.starl.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.starl.input.TextFile;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;
import picocli.CommandLine.Parameters;

/** A command on the automata of a source. */
abstract class SourceCommand extends BaseCommand implements Callable<Integer> {

  @Parameters(paramLabel = "FILE.starl", description = "The source.")
  private String name = "";

  /** The source's file, as the user has named it. */
  final String file() {
    return name;
  }

  @Override
  public final Integer call() throws IOException {
    Path path = Path.of(name);
    TextFile.read(path, "expected a source of automata (.starl)"); // tells what is no text
    List<Automaton> automata;
    try {
      automata = new SourceReader().read(path);
    } catch (SourceErrors e) {
      e.errors().forEach(err()::println);
      return ExitStatus.BAD_INPUT;
    }
    return run(automata);
  }

  /**
   * Runs the command.
   *
   * @param automata at least one
   * @return the exit status
   */
  abstract int run(List<Automaton> automata) throws IOException;
}
