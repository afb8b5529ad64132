package org.starl.lang.java;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.lang.read.SourceError;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.tree.Automaton;

/** The executable form of automata, as files of Java. */
public final class JavaSources {

  private JavaSources() {}

  /**
   * The files of an automaton.
   *
   * @param source the name of its source, for the first line of each file and for errors: {@code
   *     pvs/starl/Mutex_decls.starl}
   * @return texts, by paths that are relative to the folder of Java sources
   * @throws SourceErrors if a part of the automaton has no executable form
   */
  public static Map<String, String> of(Automaton automaton, String source) throws SourceErrors {
    try {
      Names names = Names.of(automaton);
      Map<String, String> files = new TreeMap<>();
      JavaTypes own = new JavaTypes(automaton, names, false);
      add(
          names.automaton(),
          names,
          own,
          new AutomatonWriter(automaton, own, names).body(),
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
    text.line(0, "package " + names.packageName() + ";").blank();
    for (String each : types.imports()) {
      text.line(0, "import " + each + ";");
    }
    files.put(names.packageName().replace('.', '/') + "/" + name + ".java", text.blank() + body);
  }
}
