package org.starl.lang.java;

import java.util.Locale;
import org.starl.lang.tree.Automaton;

/**
 * Names of the generated classes.
 *
 * @param packageName theirs
 * @param automaton {@code MutexAutomaton}
 * @param action {@code MutexAction}
 * @param constant {@code MUTEX_DECLS}
 */
record Names(String packageName, String automaton, String action, String constant) {

  private static final String SUFFIX = "Automaton";

  static Names of(Automaton automaton) {
    String full = automaton.javaClass();
    int dot = full.lastIndexOf('.');
    if (dot < 0
        || !full.endsWith(SUFFIX)
        || !full.matches("[a-z]\\w*(\\.[a-z]\\w*)*\\.[A-Z]\\w*")) {
      throw new NotExecutable(
          automaton.pos(),
          (full.isEmpty()
                  ? "automaton '" + automaton.name() + "' names no Java class"
                  : "'" + full + "' is no Java class of an automaton")
              + "; expected a line: java \"a.package.NameAutomaton\"");
    }
    String simple = full.substring(dot + 1);
    return new Names(
        full.substring(0, dot),
        simple,
        simple.substring(0, simple.length() - SUFFIX.length()) + "Action",
        automaton.name().replaceAll("([a-z])([A-Z])", "$1_$2").toUpperCase(Locale.ROOT));
  }
}
