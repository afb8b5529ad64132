package org.starl.lang.read;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.antlr.v4.runtime.BaseErrorListener;
import org.antlr.v4.runtime.CharStreams;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.RecognitionException;
import org.antlr.v4.runtime.Recognizer;
import org.jspecify.annotations.Nullable;
import org.starl.lang.grammar.StarlLexer;
import org.starl.lang.grammar.StarlParser;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Pos;

/** Reads sources. */
public final class SourceReader {

  private final Map<Path, List<Automaton>> read = new LinkedHashMap<>();

  /**
   * Reads a file, and the files beside it that its automata use.
   *
   * @throws IOException if the file cannot be read
   * @throws SourceErrors if there is an error in it, or in a file that it uses
   */
  public List<Automaton> read(Path file) throws IOException, SourceErrors {
    Path path = file.toAbsolutePath().normalize();
    List<Automaton> known = read.get(path);
    if (known != null) {
      return known;
    }
    read.put(path, List.of()); // a file that is being read gives nothing to those that it uses
    List<Automaton> automata = read(file.toString(), Files.readString(path), path);
    read.put(path, automata);
    return automata;
  }

  /**
   * Reads a text that is no file.
   *
   * @param name for errors
   */
  public List<Automaton> read(String name, String text) throws SourceErrors {
    return read(name, text, null);
  }

  /**
   * Reads a text that may be wrong, or stand beside files that it uses: for editors.
   *
   * @param path where it is, or would be, a file; null if nowhere
   */
  public Source look(String name, String text, @Nullable Path path) {
    Problems problems = new Problems(name);
    List<Automaton> automata = automata(name, text, path, problems);
    return new Source(automata, problems.inOrder(), problems.references());
  }

  private List<Automaton> read(String name, String text, @Nullable Path path) throws SourceErrors {
    Source source = look(name, text, path);
    if (!source.errors().isEmpty()) {
      throw new SourceErrors(source.errors());
    }
    return source.automata();
  }

  private List<Automaton> automata(
      String name, String text, @Nullable Path path, Problems problems) {
    StarlLexer lexer = new StarlLexer(CharStreams.fromString(text, name));
    CommonTokenStream tokens = new CommonTokenStream(lexer);
    StarlParser parser = new StarlParser(tokens);
    BaseErrorListener listener =
        new BaseErrorListener() {
          @Override
          public void syntaxError(
              Recognizer<?, ?> recognizer,
              @Nullable Object symbol,
              int line,
              int column,
              String message,
              @Nullable RecognitionException e) {
            problems.add(new Pos(line, column + 1), SyntaxMessage.of(message));
          }
        };
    lexer.removeErrorListeners();
    lexer.addErrorListener(listener);
    parser.removeErrorListeners();
    parser.addErrorListener(listener);
    StarlParser.FileContext file = parser.file();
    List<Automaton> automata = new ArrayList<>();
    if (problems.isEmpty()) {
      SourceText source = new SourceText(tokens);
      for (StarlParser.UnitContext unit : file.unit()) {
        automata.add(
            new AutomatonReader(
                    unit, source, problems, wanted -> find(wanted, automata, path, problems))
                .read());
      }
      if (automata.isEmpty()) {
        problems.add(new Pos(1, 1), "no automaton here; expected 'automaton' and its name");
      }
    }
    return List.copyOf(automata);
  }

  private Optional<Automaton> find(
      String wanted, List<Automaton> before, @Nullable Path path, Problems problems) {
    Optional<Automaton> here = before.stream().filter(a -> a.name().equals(wanted)).findFirst();
    if (here.isPresent() || path == null) {
      return here;
    }
    Path beside = path.resolveSibling(wanted + ".starl");
    if (!Files.isRegularFile(beside)) {
      return Optional.empty();
    }
    try {
      return read(beside).stream().filter(a -> a.name().equals(wanted)).findFirst();
    } catch (SourceErrors e) {
      e.errors().forEach(problems::add);
      throw new Wrong();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
