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
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;
import org.starl.lang.grammar.StarlLexer;
import org.starl.lang.grammar.StarlParser;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

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
    List<Automaton> automata = new ArrayList<>();
    try {
      addAll(automata, name, text, path, problems);
    } catch (StackOverflowError e) {
      problems.add(new Pos(1, 1), "an expression nests too deeply; expected shorter expressions");
    }
    return new Source(List.copyOf(automata), problems.inOrder(), problems.references());
  }

  private List<Automaton> read(String name, String text, @Nullable Path path) throws SourceErrors {
    Source source = look(name, text, path);
    if (!source.errors().isEmpty()) {
      throw new SourceErrors(source.errors());
    }
    return source.automata();
  }

  private void addAll(
      List<Automaton> automata, String name, String text, @Nullable Path path, Problems problems) {
    CommonTokenStream tokens = tokens(name, text, problems);
    StarlParser.FileContext file = parser(tokens, problems).file();
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
  }

  /**
   * Reads an expression that is in no file.
   *
   * @param automaton whose types it may use
   * @param variables other names that it may use
   * @param name for errors
   */
  public static Expr readExpression(
      Automaton automaton, List<Field> variables, Type wanted, String name, String text)
      throws SourceErrors {
    Problems problems = new Problems(name);
    CommonTokenStream tokens = tokens(name, text, problems);
    StarlParser.ExpressionContext tree = parser(tokens, problems).expression();
    if (problems.isEmpty() && tokens.LA(1) != Token.EOF) {
      Token found = tokens.LT(1);
      problems.add(
          Problems.pos(found), "found '" + found.getText() + "'; expected the end of the value");
    }
    if (problems.isEmpty()) {
      Scope scope = new Scope(automaton);
      scope.push(variables);
      try {
        return new ExpressionReader(scope, problems).read(tree, wanted);
      } catch (Wrong told) {
        throw new SourceErrors(problems.inOrder());
      }
    }
    throw new SourceErrors(problems.inOrder());
  }

  private static CommonTokenStream tokens(String name, String text, Problems problems) {
    StarlLexer lexer = new StarlLexer(CharStreams.fromString(text, name));
    lexer.removeErrorListeners();
    lexer.addErrorListener(listener(problems));
    return new CommonTokenStream(lexer);
  }

  private static StarlParser parser(CommonTokenStream tokens, Problems problems) {
    StarlParser parser = new StarlParser(tokens);
    parser.removeErrorListeners();
    parser.addErrorListener(listener(problems));
    return parser;
  }

  private static BaseErrorListener listener(Problems problems) {
    return new BaseErrorListener() {
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
