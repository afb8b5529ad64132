package org.starl.lang.java;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.Declared;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/** Writes the types that an automaton or a program declares. */
final class TypesWriter {

  private final Automaton automaton;
  private final JavaTypes types;
  private final JavaText out;

  TypesWriter(Automaton automaton, JavaTypes types, JavaText out) {
    this.automaton = automaton;
    this.types = types;
    this.out = out;
  }

  void write() {
    automaton.types().forEach(this::type);
  }

  private List<String> fields(List<Field> fields) {
    return fields.stream()
        .map(f -> types.of(f.type(), automaton.pos()) + " " + JavaTypes.name(f.name()))
        .toList();
  }

  private void type(Declared declared) {
    if (types.isGiven(declared.type())) {
      return;
    }
    switch (declared.type()) {
      case Type.Rec rec -> {
        out.blank().doc(2, declared.comment(), List.of());
        out.head(2, "public record " + rec.name(), fields(rec.fields()), List.of(" {}"));
      }
      case Type.Sum sum when sum.isEnum() -> {
        out.blank().doc(2, declared.comment(), List.of());
        out.line(2, "public enum " + sum.name() + " {");
        for (int i = 0; i < sum.constructors().size(); i++) {
          boolean isLast = i == sum.constructors().size() - 1;
          out.line(4, JavaTypes.name(sum.constructors().get(i).name()) + (isLast ? "" : ","));
        }
        out.line(2, "}");
      }
      case Type.Sum sum -> {
        out.blank().doc(2, declared.comment(), List.of());
        sum(sum);
      }
      default -> {
        // Another name of a type is no type of Java.
      }
    }
  }

  private void sum(Type.Sum sum) {
    String term = types.use("org.starl.spec.automaton.Term");
    out.line(2, "public sealed interface " + sum.name() + " extends " + term + " {");
    Map<String, List<Field>> constructors = new LinkedHashMap<>();
    for (Type.Constructor each : sum.constructors()) {
      String name = JavaTypes.name(each.name());
      constructors.put(name, each.fields());
      out.blank();
      if (JavaTypes.isContextual(name)) {
        out.line(4, "// The theory's name; in module declarations it is a keyword.");
        out.line(4, "@SuppressWarnings(\"NamedLikeContextualKeyword\")");
      }
      out.head(
          4, "record " + name, fields(each.fields()), List.of("implements " + sum.name(), " {"));
      out.line(6, "@Override").line(6, "public String toString() {");
      out.line(8, "return text();").line(6, "}").line(4, "}");
    }
    ActionWriter.args(4, constructors, types, out);
    out.line(2, "}");
  }
}
