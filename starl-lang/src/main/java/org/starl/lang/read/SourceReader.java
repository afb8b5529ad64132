package org.starl.lang.read;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.antlr.v4.runtime.BaseErrorListener;
import org.antlr.v4.runtime.CharStreams;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.RecognitionException;
import org.antlr.v4.runtime.Recognizer;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.tree.ParseTree;
import org.jspecify.annotations.Nullable;
import org.starl.lang.grammar.StarlLexer;
import org.starl.lang.grammar.StarlParser;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Primitive;
import org.starl.lang.tree.Program;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/** Reads sources. */
public final class SourceReader {

  static final String TOO_DEEP = "an expression nests too deeply; expected shorter expressions";

  /** It ends a line, too. */
  private static final Pattern LONE_RETURN = Pattern.compile("\r(?!\n)");

  private static final Set<Integer> BEGINNINGS =
      Set.of(
          StarlLexer.PRE,
          StarlLexer.EFF,
          StarlLexer.START,
          StarlLexer.STATE,
          StarlLexer.TYPE,
          StarlLexer.FUN,
          StarlLexer.INVARIANT,
          StarlLexer.CONSTRAINT,
          StarlLexer.ASSUME,
          StarlLexer.PROGRESS,
          StarlLexer.WHEN,
          StarlLexer.DO);

  private final Map<Path, Source> read = new LinkedHashMap<>();
  private final Library library;

  /** Knows StarL's own automata and primitives. */
  public SourceReader() {
    this(new Library());
  }

  SourceReader(Library library) {
    this.library = library;
  }

  /**
   * Reads a file, and the files beside it that its automata use.
   *
   * @return its automata, and those of its programs
   * @throws IOException if the file cannot be read
   * @throws SourceErrors if there is an error in it, or in a file that it uses
   */
  public List<Automaton> read(Path file) throws IOException, SourceErrors {
    return source(file).automata();
  }

  /**
   * Reads a file, as {@link #read(Path)} does; the result has no error.
   *
   * @throws IOException if the file cannot be read
   * @throws SourceErrors if there is an error in it, or in a file that it uses
   */
  public Source source(Path file) throws IOException, SourceErrors {
    Path path = file.toAbsolutePath().normalize();
    Source known = read.get(path);
    if (known != null) {
      return known;
    }
    read.put(path, Source.EMPTY); // a file that is being read gives nothing to those that it uses
    Source source = read(file.toString(), Files.readString(path).replaceFirst("^\uFEFF", ""), path);
    read.put(path, source);
    return source;
  }

  /** The paths of the files that were read, in this order. */
  public List<String> files() {
    return read.keySet().stream().map(Path::toString).toList();
  }

  /**
   * Reads a text that is no file.
   *
   * @param name for errors
   */
  public List<Automaton> read(String name, String text) throws SourceErrors {
    return read(name, text, null).automata();
  }

  /**
   * Reads a text that may be wrong, or stand beside files that it uses: for editors.
   *
   * @param path where it is, or would be, a file; null if nowhere
   */
  public Source look(String name, String text, @Nullable Path path) {
    Units units = new Units(name, path);
    try {
      units.addAll(text);
    } catch (StackOverflowError e) {
      units.problems.add(units.place(), TOO_DEEP);
    }
    return units.source();
  }

  private Source read(String name, String text, @Nullable Path path) throws SourceErrors {
    Source source = look(name, text, path);
    if (!source.errors().isEmpty()) {
      throw new SourceErrors(source.errors());
    }
    return source;
  }

  /** The units of one text, as far as it has been read. */
  private final class Units {

    private final Problems problems;
    private final @Nullable Path path;
    private final List<Automaton> automata = new ArrayList<>();
    private final List<Program> programs = new ArrayList<>();
    private final List<Primitive> primitives = new ArrayList<>();
    private @Nullable CommonTokenStream parsed;

    private Units(String name, @Nullable Path path) {
      problems = new Problems(name);
      this.path = path;
    }

    private void addAll(String text) {
      CommonTokenStream tokens = tokens(problems.file(), text, problems);
      parsed = tokens;
      StarlParser.FileContext file = parser(tokens, problems).file();
      if (!problems.isEmpty()) {
        return;
      }
      SourceText source = new SourceText(tokens);
      for (ParseTree unit : file.children) {
        add(unit, source);
      }
      if (automata.isEmpty() && primitives.isEmpty() && problems.isEmpty()) {
        problems.add(new Pos(1, 1), "no automaton or program here; expected one");
      }
    }

    /** Where the condition, effect or declaration begins that the parser is in. */
    private Pos place() {
      CommonTokenStream tokens = Objects.requireNonNull(parsed);
      int i = tokens.LA(1) == Token.EOF ? 0 : tokens.index(); // all of it is parsed
      while (i > 0 && !BEGINNINGS.contains(tokens.get(i).getType())) {
        i--;
      }
      return Problems.pos(tokens.get(i));
    }

    private void add(ParseTree unit, SourceText source) {
      if (unit instanceof StarlParser.UnitContext at) {
        requireNew(at.name);
        automata.add(new AutomatonReader(at, source, problems, this::find, this::isOpen).read());
      } else if (unit instanceof StarlParser.PrimitiveContext at) {
        new PrimitiveReader(at, source, problems, this::find, known())
            .read()
            .ifPresent(primitives::add);
      } else if (unit instanceof StarlParser.ProgramContext at) {
        requireNew(at.name);
        ProgramReader reader = new ProgramReader(at, source, problems, known());
        Program program = reader.read();
        if (problems.isEmpty()) {
          programs.add(program);
          automata.add(reader.automaton(program));
        }
      }
    }

    /** A second one would be found by no name, and its files would replace those of the first. */
    private void requireNew(StarlParser.IdContext name) {
      String text = name.getText();
      if (automata.stream().anyMatch(each -> each.name().equals(text))) {
        problems.add(name, "'" + text + "' is here twice; expected different names");
      }
    }

    /** The primitives of this text, and StarL's. */
    private List<Primitive> known() {
      List<Primitive> all = new ArrayList<>(primitives);
      if (!problems.file().equals(Library.PRIMITIVES)) {
        all.addAll(library.primitives());
      }
      return all;
    }

    private Optional<Automaton> find(String wanted) {
      Optional<Automaton> here = automata.stream().filter(a -> a.name().equals(wanted)).findFirst();
      return here.isPresent() ? here : SourceReader.this.find(wanted, path, problems);
    }

    private boolean isOpen(String wanted) {
      Path beside = path == null ? null : path.resolveSibling(wanted + ".starl");
      return beside != null && Source.EMPTY.equals(read.get(beside.toAbsolutePath().normalize()));
    }

    private Source source() {
      return new Source(
          List.copyOf(automata),
          List.copyOf(programs),
          List.copyOf(primitives),
          problems.inOrder(),
          problems.references());
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
    StarlLexer lexer =
        new StarlLexer(CharStreams.fromString(LONE_RETURN.matcher(text).replaceAll("\n"), name));
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

      private int lastLine;

      @Override
      public void syntaxError(
          Recognizer<?, ?> recognizer,
          @Nullable Object symbol,
          int line,
          int column,
          String message,
          @Nullable RecognitionException e) {
        if (line != lastLine) { // others follow from the first one on a line
          Token found = symbol instanceof Token token ? token : null;
          Parser at = recognizer instanceof Parser parser ? parser : null;
          problems.add(new Pos(line, column + 1), SyntaxMessage.of(message, found, at));
        }
        lastLine = line;
      }
    };
  }

  private Optional<Automaton> find(String wanted, @Nullable Path path, Problems problems) {
    Path beside = path == null ? null : path.resolveSibling(wanted + ".starl");
    if (beside == null || !Files.isRegularFile(beside)) {
      return library.automaton(wanted);
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
