package org.starl.lang.java;

import java.util.Locale;
import java.util.stream.Stream;
import javax.lang.model.SourceVersion;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Program;
import org.starl.lang.tree.Type.Field;

/**
 * Names of the generated classes.
 *
 * @param packageName theirs
 * @param automaton {@code MutexAutomaton}; of a program its class
 * @param action {@code MutexAction}
 * @param constant {@code MUTEX_DECLS}
 */
record Names(String packageName, String automaton, String action, String constant) {

  /** The end of the names of classes of automata. */
  static final String SUFFIX = "Automaton";

  private static final String CLASS = "[a-z]\\w*(\\.[a-z]\\w*)*\\.[A-Z]\\w*";

  static Names of(Program program) {
    String full = program.javaClass();
    int dot = full.lastIndexOf('.');
    if (!full.matches(CLASS) || !SourceVersion.isName(full)) {
      throw new NotExecutable(
          program.pos(),
          (full.isEmpty()
                  ? "program '" + program.name() + "' names no Java class"
                  : "'" + full + "' is no Java class")
              + "; expected a line: java \"a.package.Name\"");
    }
    return new Names(full.substring(0, dot), full.substring(dot + 1), "", "");
  }

  static Names of(Automaton automaton) {
    String full = automaton.javaClass();
    int dot = full.lastIndexOf('.');
    if (!full.endsWith(SUFFIX) || !full.matches(CLASS) || !SourceVersion.isName(full)) {
      throw new NotExecutable(
          automaton.pos(),
          (full.isEmpty()
                  ? "automaton '" + automaton.name() + "' names no Java class"
                  : "'" + full + "' is no Java class of an automaton")
              + "; expected a line: java \"a.package.NameAutomaton\"");
    }
    String simple = full.substring(dot + 1);
    String constant =
        automaton.name().replaceAll("([a-z])([A-Z])", "$1_$2").toUpperCase(Locale.ROOT);
    boolean isTaken =
        Stream.concat(
                automaton.valueParameters().stream().map(Field::name),
                automaton.types().stream().map(each -> each.type().name()))
            .anyMatch(constant::equals);
    return new Names(
        full.substring(0, dot),
        simple,
        simple.substring(0, simple.length() - SUFFIX.length()) + "Action",
        isTaken ? constant + "_" : constant);
  }
}
