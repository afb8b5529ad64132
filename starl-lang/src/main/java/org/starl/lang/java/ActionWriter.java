package org.starl.lang.java;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Type.Field;

/** Writes the body of {@code XAction}. */
final class ActionWriter {

  private final Automaton automaton;
  private final JavaTypes types;
  private final Names names;
  private final JavaText out = new JavaText();

  ActionWriter(Automaton automaton, JavaTypes types, Names names) {
    this.automaton = automaton;
    this.types = types;
    this.names = names;
  }

  /** All that follows the imports. */
  String body() {
    out.doc(0, List.of("The actions of " + automaton.name() + "."), List.of());
    out.line(
        0,
        "public sealed interface %s extends %s {"
            .formatted(names.action(), types.use("org.starl.spec.automaton.Action")));
    Map<String, List<Field>> records = new LinkedHashMap<>();
    for (Action action : automaton.actions()) {
      String name = types.type(action.name());
      List<String> about = new ArrayList<>(action.comment());
      if (!action.note().isEmpty()) {
        about.add(action.note());
      }
      out.blank().doc(2, about, List.of());
      List<String> parameters =
          action.parameters().stream()
              .map(p -> types.of(p.type(), action.pos()) + " " + JavaTypes.name(p.name()))
              .toList();
      out.head(2, "record " + name, parameters, List.of("implements " + names.action(), " {}"));
      records.put(name, action.parameters());
    }
    args(2, records, types, out);
    return out.line(0, "}").toString();
  }

  /** {@code args()} of a sealed interface of records. */
  static void args(int indent, Map<String, List<Field>> records, JavaTypes types, JavaText out) {
    String list = types.use("java.util.List");
    out.blank().line(indent, "@Override").line(indent, "default List<Object> args() {");
    out.line(indent + 2, "return switch (this) {");
    records.forEach((name, fields) ->
        out.of(
            indent + 4,
            name + " a",
            Code.call(
                list + ".of",
                fields.stream()
                    .map(f -> Code.name("a").field(JavaTypes.name(f.name())))
                    .toArray(Code[]::new))));
    out.line(indent + 2, "};").line(indent, "}");
  }
}
