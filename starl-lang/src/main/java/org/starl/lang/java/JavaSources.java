package org.starl.lang.java;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.lang.read.Source;
import org.starl.lang.read.SourceError;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Program;

/** The executable form of automata, and programs, as files of Java. */
public final class JavaSources {

  // With the lines before it a file has 500.
  private static final int LONG_LINES = 480;

  private JavaSources() {}

  /**
   * The files of all programs, and of all automata; beside a program, of those that name a class.
   *
   * @param file the name of the source, for the first line of each file and for errors: {@code
   *     pvs/starl/Mutex_decls.starl}
   * @return texts, by paths that are relative to the folder of Java sources
   * @throws SourceErrors if a part of a unit has no executable form
   */
  public static Map<String, String> of(Source source, String file) throws SourceErrors {
    List<String> programs = source.programs().stream().map(Program::name).toList();
    List<Automaton> automata = new ArrayList<>(source.automata());
    // A program stands for its automaton; an automaton beside it may be for proofs alone.
    automata.removeIf(each ->
        programs.contains(each.name()) || (!programs.isEmpty() && each.javaClass().isEmpty()));
    automata.removeIf(each -> Uses.unnamed(source.automata()).contains(each.name()));
    Map<String, String> files = new TreeMap<>();
    for (Program program : source.programs()) {
      files.putAll(of(program, file));
    }
    requireClasses(automata, file);
    List<String> here = source.automata().stream().map(Automaton::name).toList();
    for (Automaton automaton : automata) {
      files.putAll(of(automaton, here, file));
    }
    return files;
  }

  /** Each has its own: the files of the second would replace those of the first. */
  private static void requireClasses(List<Automaton> automata, String file) throws SourceErrors {
    Map<String, Automaton> owners = new TreeMap<>();
    for (Automaton each : automata) {
      Automaton owner = owners.putIfAbsent(each.javaClass(), each);
      if (owner != null && !each.javaClass().isEmpty()) {
        String message =
            "'%s' is the Java class of '%s' already; expected another one"
                .formatted(each.javaClass(), owner.name());
        throw new SourceErrors(List.of(new SourceError(file, each.pos(), message)));
      }
    }
  }

  /**
   * The files of an automaton that uses none of its source.
   *
   * @param source the name of its source, as above
   * @return texts, by paths that are relative to the folder of Java sources
   * @throws SourceErrors if a part of the automaton has no executable form
   */
  public static Map<String, String> of(Automaton automaton, String source) throws SourceErrors {
    return of(automaton, List.of(), source);
  }

  private static Map<String, String> of(Automaton automaton, List<String> here, String source)
      throws SourceErrors {
    try {
      Names.of(automaton);
      Automaton named = Uses.named(automaton);
      Map<String, String> files = new TreeMap<>(files(named, source));
      Uses.beside(named)
          .forEach(used ->
              files.putAll(
                  files(used, here.contains(used.name()) ? source : used.name() + ".starl")));
      return files;
    } catch (NotExecutable e) {
      throw new SourceErrors(
          List.of(new SourceError(source, e.pos(), String.valueOf(e.getMessage()))));
    }
  }

  private static Map<String, String> files(Automaton automaton, String source) {
    Names names = Names.of(automaton);
    String file = source.substring(source.lastIndexOf('/') + 1);
    Map<String, String> files = new TreeMap<>();
    JavaTypes own = new JavaTypes(automaton, names, false);
    add(
        names.automaton(),
        names,
        own,
        new AutomatonWriter(automaton, own, names, file).body(),
        source,
        files);
    JavaTypes actions = new JavaTypes(automaton, names, true);
    add(
        names.action(),
        names,
        actions,
        new ActionWriter(automaton, actions, names).body(),
        source,
        files);
    return files;
  }

  /**
   * The file of a program.
   *
   * @param source the name of its source, as above
   * @return its text, by its path relative to the folder of Java sources
   * @throws SourceErrors if a part of the program has no Java form
   */
  public static Map<String, String> of(Program program, String source) throws SourceErrors {
    try {
      Names names = Names.of(program);
      String file = source.substring(source.lastIndexOf('/') + 1);
      ProgramWriter writer = new ProgramWriter(program, file, names);
      String body = writer.body();
      Map<String, String> files = new TreeMap<>();
      add(names.automaton(), names, writer.types(), body, source, files);
      return files;
    } catch (NotExecutable e) {
      throw new SourceErrors(
          List.of(new SourceError(source, e.pos(), String.valueOf(e.getMessage()))));
    }
  }

  private static void add(
      String name,
      Names names,
      JavaTypes types,
      String body,
      String source,
      Map<String, String> files) {
    String file = source.substring(source.lastIndexOf('/') + 1);
    JavaText text = new JavaText();
    text.line(0, "// Generated from " + file + " by 'starl compile': change that file instead.");
    if (body.lines().count() > LONG_LINES) {
      text.line(0, "// Longer than 500 lines because its source is one automaton.");
    }
    text.line(0, "package " + names.packageName() + ";").blank();
    for (String each : types.imports()) {
      text.line(0, "import " + each + ";");
    }
    files.put(names.packageName().replace('.', '/') + "/" + name + ".java", text.blank() + body);
  }
}
