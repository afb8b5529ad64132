package org.starl.cli.lang;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.Digest;
import org.starl.cli.command.ExitStatus;
import org.starl.input.BadInput;
import org.starl.input.TextFile;
import org.starl.lang.read.Source;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Program;
import picocli.CommandLine.Parameters;

/** A command on the units of a source. */
abstract class SourceCommand extends BaseCommand implements Callable<Integer> {

  @Parameters(paramLabel = "FILE.starl", description = "The source.")
  private String name = "";

  private final SourceReader reader = new SourceReader();
  private List<Program> programs = List.of();

  /** The source's file, as the user has named it. */
  final String file() {
    return name;
  }

  @Override
  public final Integer call() throws IOException {
    Path path = Path.of(name);
    TextFile.read(path, "expected a source of automata (.starl)"); // tells what is no text
    Source source;
    try {
      source = reader.source(path);
    } catch (SourceErrors e) {
      e.errors().forEach(err()::println);
      return ExitStatus.BAD_INPUT;
    }
    programs = source.programs();
    try {
      return run(source);
    } catch (StackOverflowError e) {
      throw new BadInput(
          file()
              + ": an expression nests too deeply, or an automaton is too long; expected shorter ones,"
              + " or a larger stack: STARL_JAVA_OPTS=-Xss64m");
    }
  }

  /** A digest of the source, and of the files beside it that it uses. */
  final String digest() {
    return Digest.of("", reader.files());
  }

  /** Where the branches of a program are whose actions have these names. */
  final List<String> places(Automaton automaton, Set<String> actions) {
    if (programs.stream().noneMatch(each -> each.name().equals(automaton.name()))) {
      return List.of(); // an automaton's actions have their names in the source
    }
    return automaton.actions().stream()
        .filter(action -> actions.contains(action.name()))
        .map(action -> "  " + action.name() + " is at " + file() + ":" + action.pos())
        .toList();
  }

  /**
   * Runs the command.
   *
   * @param source of at least one automaton
   * @return the exit status
   */
  abstract int run(Source source) throws IOException;
}
