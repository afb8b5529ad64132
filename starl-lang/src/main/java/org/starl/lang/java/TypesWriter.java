package org.starl.lang.java;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.Declared;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/** Writes the types that an automaton or a program declares. */
record TypesWriter(Automaton automaton, JavaTypes types, JavaText out) {

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
        String name = types.type(rec.name());
        String comparable = "implements Comparable<" + name + ">";
        out.head(2, "public record " + name, fields(rec.fields()), List.of(comparable, " {"));
        ordered(name, rec.fields());
        out.line(2, "}");
      }
      case Type.Sum sum when sum.isEnum() -> {
        out.blank().doc(2, declared.comment(), List.of());
        out.line(2, "public enum " + types.type(sum.name()) + " {");
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
    String type = types.type(sum.name());
    String above = term + ", Comparable<" + type + ">";
    out.line(2, "public sealed interface " + type + " extends " + above + " {");
    Map<String, List<Field>> constructors = new LinkedHashMap<>();
    for (Type.Constructor each : sum.constructors()) {
      String name = JavaTypes.form(sum, each.name());
      constructors.put(name, each.fields());
      out.blank();
      if (JavaTypes.isContextual(name)) {
        out.line(4, "// The theory's name; in module declarations it is a keyword.");
        out.line(4, "@SuppressWarnings(\"NamedLikeContextualKeyword\")");
      }
      out.head(4, "record " + name, fields(each.fields()), List.of("implements " + type, " {"));
      out.line(6, "@Override").line(6, "public String toString() {");
      out.line(8, "return text();").line(6, "}").line(4, "}");
    }
    ActionWriter.args(4, constructors, types, out);
    begun("default", type).line(6, "return " + sets() + ".compare(this, that);").line(4, "}");
    out.line(2, "}");
  }

  /** By its fields, in their order. */
  private void ordered(String type, List<Field> fields) {
    JavaText text = begun("public", type);
    for (int i = 0; i < fields.size(); i++) {
      String field = JavaTypes.name(fields.get(i).name());
      String order = "order = %s.compare(this.%s, that.%s);".formatted(sets(), field, field);
      if (i == 0) {
        text.line(6, "int " + order);
      } else {
        text.line(6, "if (order == 0) {").line(8, order).line(6, "}");
      }
    }
    text.line(6, "return order;").line(4, "}");
  }

  /** {@code compareTo}: values are elements of sets, and arguments of maps. */
  private JavaText begun(String word, String type) {
    out.blank().line(4, "@Override");
    return out.line(4, word + " int compareTo(" + type + " that) {");
  }

  private String sets() {
    return types.use("org.starl.spec.automaton.Sets");
  }
}
