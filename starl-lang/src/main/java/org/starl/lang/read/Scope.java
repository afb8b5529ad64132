package org.starl.lang.read;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.antlr.v4.runtime.ParserRuleContext;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Signature;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Constructor;
import org.starl.lang.tree.Type.Field;

/** The names that are known in one automaton, as far as it has been read. */
final class Scope {

  /** A constructor and the sum that it belongs to. */
  record Known(Type.Sum sum, Constructor constructor) {}

  final String automaton;
  final Map<String, Type> types = new LinkedHashMap<>();
  final Map<String, Type> values = new LinkedHashMap<>();
  final Map<String, Type> state = new LinkedHashMap<>();
  final Map<String, Automaton> uses = new LinkedHashMap<>();
  final Map<String, Signature> functions = new LinkedHashMap<>();
  final Map<String, Known> constructors = new LinkedHashMap<>();

  /** The value parameters that bounds of types may have. */
  final Set<String> numbers = new TreeSet<>();

  /** See {@link Automaton#ranges}. */
  final List<Expr> ranges = new ArrayList<>();

  /** The types that are declared further down. */
  final Set<String> later = new TreeSet<>();

  /** Names whose declaration is wrong: what uses them need not be told. */
  final Set<String> wrong = new TreeSet<>();

  /** As {@link #wrong}, of types. */
  final Set<String> wrongTypes = new TreeSet<>();

  /** Where the names are declared, but those of variables and of what is used. */
  final Map<String, Pos> places = new LinkedHashMap<>();

  private final List<Field> bound = new ArrayList<>();

  Scope(String automaton) {
    this.automaton = automaton;
    types.put("bool", Type.Bool.BOOL);
    for (Type.Num number : Type.Num.values()) {
      types.put(number.toString(), number);
    }
  }

  /** What {@code read} reads to declare a name, which is wrong if that cannot be read. */
  <T> T declaring(String name, Supplier<T> read) {
    wrong.add(name);
    T value = read.get();
    wrong.remove(name);
    return value;
  }

  /** The types of an automaton that is known, and of those that it uses. */
  Scope(Automaton known) {
    this(known.name());
    addTypes(known);
  }

  /** Makes all names of an automaton known, as in its own source. */
  void enter(Automaton known) {
    addTypes(known);
    known
        .valueParameters()
        .forEach(field -> {
          values.put(field.name(), field.type());
          if (field.type() == Type.Num.NAT) {
            numbers.add(field.name());
          }
        });
    known.state().forEach(component -> state.put(component.name(), component.type()));
    uses.putAll(known.uses());
    known.functions().forEach(f -> functions.put(f.signature().name(), f.signature()));
  }

  /** The types of a used automaton are known by their names, if these are free. */
  void knowTypes(Automaton used) {
    used.types().forEach(each -> types.putIfAbsent(each.type().name(), each.type()));
    used.uses().values().forEach(this::knowTypes);
  }

  private void addTypes(Automaton known) {
    known.typeParameters().forEach(name -> types.put(name, new Type.Opaque(name)));
    known.types().forEach(each -> add(each.type()));
    known.uses().values().forEach(this::addTypes);
  }

  private void add(Type.Named type) {
    types.putIfAbsent(type.name(), type);
    if (type instanceof Type.Sum sum) {
      sum.constructors().forEach(c -> constructors.putIfAbsent(c.name(), new Known(sum, c)));
    }
  }

  /** What {@code name} is already; empty if it is free. */
  Optional<String> taken(String name) {
    if (Language.WORDS.contains(name)) {
      return Optional.of("a function of the language");
    }
    if (types.containsKey(name)) {
      return Optional.of("a type");
    }
    if (values.containsKey(name)) {
      return Optional.of("a parameter");
    }
    if (state.containsKey(name)) {
      return Optional.of("a component of the state");
    }
    if (functions.containsKey(name)) {
      return Optional.of("a function");
    }
    if (constructors.containsKey(name)) {
      return Optional.of("a value of " + constructors.get(name).sum());
    }
    return bound(name).map(field -> "a variable");
  }

  /** The innermost variable of this name. */
  Optional<Field> bound(String name) {
    for (int i = bound.size() - 1; i >= 0; i--) {
      if (bound.get(i).name().equals(name)) {
        return Optional.of(bound.get(i));
      }
    }
    return Optional.empty();
  }

  /** The automaton in the component {@code name}, which is one of {@link #uses}. */
  Automaton used(String name) {
    return Objects.requireNonNull(uses.get(name), name);
  }

  /** Where {@code name} is declared; {@code here}, if that is in another file. */
  Pos place(String name, ParserRuleContext here) {
    Pos place = places.get(name);
    return place != null ? place : Problems.pos(here);
  }

  void push(List<Field> fields) {
    bound.addAll(fields);
  }

  void pop(List<Field> fields) {
    bound.subList(bound.size() - fields.size(), bound.size()).clear();
  }

  /** All names that an expression may use here. */
  List<String> names() {
    List<String> names = new ArrayList<>(Language.WORDS);
    bound.forEach(field -> names.add(field.name()));
    names.addAll(values.keySet());
    names.addAll(state.keySet());
    names.addAll(functions.keySet());
    names.addAll(constructors.keySet());
    return names;
  }
}
