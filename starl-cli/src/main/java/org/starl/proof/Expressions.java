package org.starl.proof;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.StringJoiner;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Term;

/** Writes values of an automaton as PVS expressions. */
final class Expressions {

  /** The library's theory, and function, of functions with one value. */
  static final String CONSTANTLY = "constantly";

  private final List<Formal> formals;
  private final Identifiers identifiers;
  private boolean usesConstantly;

  /** A type parameter of the theory, such as {@code PIDS}, and the Java class of its constants. */
  record Formal(String type, Class<?> values) {}

  Expressions(List<Formal> formals, Identifiers identifiers) {
    this.formals = formals;
    this.identifiers = identifiers;
  }

  /** Whether an expression that was made needs {@link #CONSTANTLY}. */
  boolean usesConstantly() {
    return usesConstantly;
  }

  /** Whether the value is a constant of a type parameter. */
  boolean isConstant(Object value) {
    return formals.stream().anyMatch(formal -> formal.values().isInstance(value));
  }

  /** Whether the theory has values of this type: robots show others too. */
  boolean isValue(Object value) {
    return switch (value) {
      case Long number -> true;
      case Boolean truth -> true;
      case SortedSet<?> set -> true;
      case Fun<?, ?> fun -> true;
      case Term term -> true;
      case Record record -> components(record).stream().allMatch(this::isValue);
      default -> isConstant(value);
    };
  }

  /** The value as an expression; its type follows from its class. */
  String of(Object value) {
    return of(value, value.getClass());
  }

  private String of(Object value, Type type) {
    if (isConstant(value)) {
      return identifiers.of(value);
    }
    return switch (value) {
      case Long number -> number.toString();
      case Boolean truth -> truth ? "TRUE" : "FALSE";
      case SortedSet<?> set -> set(set.isEmpty() ? "" : type(set.first().getClass()), set);
      case Fun<?, ?> fun when type instanceof ParameterizedType known ->
          fun(fun, known.getActualTypeArguments());
      case Term term -> term(term);
      case Record record -> record(record, ", ");
      default ->
          throw new IllegalArgumentException(
              value.getClass() + ": not a value of a theory: " + value);
    };
  }

  private String set(String type, Iterable<?> members) {
    StringJoiner equals = new StringJoiner(" OR ", "{x: " + type + " | ", "}");
    equals.setEmptyValue("emptyset");
    members.forEach(member -> equals.add("x = " + of(member)));
    return equals.toString();
  }

  private String fun(Fun<?, ?> fun, Type[] types) {
    String domain = type(types[0]);
    if (Boolean.FALSE.equals(fun.defaultValue())) {
      List<Object> members = new ArrayList<>();
      fun.forEach((argument, isIn) -> members.add(argument));
      return set(domain, members);
    }
    String indent = "\n          ";
    StringJoiner cases = new StringJoiner(indent + "ELS", indent, indent + "ELSE ");
    cases.setEmptyValue(" ");
    fun.forEach(
        (argument, value) -> cases.add("IF i = " + of(argument) + " THEN " + of(value, types[1])));
    String elsewhere = of(fun.defaultValue(), types[1]);
    if (cases.toString().isBlank() && isForm(fun.defaultValue())) {
      usesConstantly = true;
      return CONSTANTLY + "(" + elsewhere + ")";
    }
    String end = cases.toString().isBlank() ? "" : " ENDIF";
    return "LAMBDA (i: " + domain + "):" + cases + elsewhere + end;
  }

  /** Whether PVS takes the value for one of a smaller type, of which pvs/check refuses a function. */
  private static boolean isForm(Object value) {
    return value instanceof Term || value instanceof Record;
  }

  private String term(Term term) {
    StringJoiner text = new StringJoiner(", ", term.name() + "(", ")");
    text.setEmptyValue(term.name());
    term.args().forEach(arg -> text.add(of(arg)));
    return text.toString();
  }

  /** A state as an expression, one component a line. */
  String ofState(Record state) {
    return record(state, ",\n       ");
  }

  private String record(Record record, String separator) {
    StringJoiner text = new StringJoiner(separator, "(# ", " #)");
    for (RecordComponent component : record.getClass().getRecordComponents()) {
      String value = of(valueOf(component, record), component.getGenericType());
      text.add(component.getName() + " := " + value);
    }
    return text.toString();
  }

  /** The values of its components, in order. */
  static List<Object> components(Record of) {
    List<Object> values = new ArrayList<>();
    for (RecordComponent component : of.getClass().getRecordComponents()) {
      values.add(valueOf(component, of));
    }
    return values;
  }

  private static Object valueOf(RecordComponent component, Record of) {
    try {
      return component.getAccessor().invoke(of);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(component + " cannot be read", e);
    }
  }

  private String type(Type type) {
    if (type.equals(Long.class)) {
      return "nat";
    }
    return formals.stream()
        .filter(formal -> type.equals(formal.values()))
        .map(Formal::type)
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException(type + ": not a type of a theory"));
  }
}
