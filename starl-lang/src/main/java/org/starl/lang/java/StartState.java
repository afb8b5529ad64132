package org.starl.lang.java;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.Component;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Exprs;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/**
 * Finds a start state in the conditions on it: equations of a component, or of all values of a map.
 * What they leave open has the first value of its type: 0, false, empty.
 */
final class StartState {

  private final ExpressionWriter writer;

  /** A part of the state. */
  private static final class Part {
    private final Type type;
    private @Nullable Code value;
    private @Nullable Part result;
    private final Map<String, Part> fields = new TreeMap<>();

    private Part(Type type) {
      this.type = type;
    }

    private Part result() {
      Part known = result;
      if (known == null) {
        known = new Part(((Type.MapOf) type.base()).result());
        result = known;
      }
      return known;
    }

    private Code code(JavaTypes types, Pos pos) {
      if (value != null) {
        return value;
      }
      if (type.base() instanceof Type.StateOf used) {
        return new Code.New(
            types.of(type, pos),
            used.automaton().state().stream()
                .map(c -> field(c.name(), c.type()).code(types, pos))
                .toList());
      }
      Part all = result;
      if (all != null) {
        return types.constant((Type.MapOf) type.base(), all.code(types, pos), pos);
      }
      if (!fields.isEmpty() && type.base() instanceof Type.Rec rec) {
        return new Code.New(
            types.of(type, pos),
            rec.fields().stream().map(f -> field(f.name(), f.type()).code(types, pos)).toList());
      }
      return types.any(type, pos);
    }

    private Part field(String name, Type of) {
      return fields.computeIfAbsent(name, wanted -> new Part(of));
    }
  }

  private final Map<String, Part> components = new TreeMap<>();

  /** Equations that read components, with the variables of which they are; these are made true last. */
  private final Map<Expr.Binary, List<Field>> late = new LinkedHashMap<>();

  /**
   * @param writer is given the Java of components, which are no variables yet
   */
  StartState(Function<Function<Expr, @Nullable Code>, ExpressionWriter> writer) {
    this.writer = writer.apply(this::started);
  }

  /** {@code new States(...)}. */
  Code of(Automaton automaton) {
    for (Component component : automaton.state()) {
      components.put(component.name(), new Part(component.type()));
    }
    automaton.start().forEach(condition -> hold(condition, List.of()));
    while (!late.isEmpty()) {
      Expr.Binary next =
          late.keySet().stream()
              .filter(each -> late.keySet().stream().noneMatch(other -> reads(each.right(), other)))
              .findFirst()
              .orElseThrow(() -> dependent(ofCircle()));
      hold(next, Objects.requireNonNull(late.remove(next)), true);
    }
    return new Code.New(
        "States",
        automaton.state().stream()
            .map(c -> part(c.name()).code(writer.types(), automaton.pos()))
            .toList());
  }

  private Part part(String component) {
    return Objects.requireNonNull(components.get(component), component);
  }

  private @Nullable Code started(Expr at) {
    if (at instanceof Expr.Call call && call.function().readsState()) {
      throw dependent(at);
    }
    return at instanceof Expr.Component of ? part(of.name()).code(writer.types(), at.pos()) : null;
  }

  /** An equation that depends on itself: each reads the component of another one. */
  private Expr.Binary ofCircle() {
    List<Expr.Binary> all = List.copyOf(late.keySet());
    Expr.Binary at = all.getFirst();
    for (int i = 0; i < all.size(); i++) {
      Expr right = at.right();
      at = all.stream().filter(each -> reads(right, each)).findFirst().orElseThrow();
    }
    return at;
  }

  private static NotExecutable dependent(Expr at) {
    return new NotExecutable(
        at.pos(),
        "this start value depends on itself, or on a function of the state; expected others");
  }

  /** Whether {@code at} reads the component that an equation is of. */
  private static boolean reads(Expr at, Expr.Binary equation) {
    return components(at).stream().anyMatch(components(equation.left())::contains);
  }

  private static Set<String> components(Expr at) {
    Set<String> names = new TreeSet<>();
    if (at instanceof Expr.Component of) {
      names.add(of.name());
    }
    Exprs.parts(at).forEach(part -> names.addAll(components(part)));
    return names;
  }

  private void hold(Expr condition, List<Field> variables) {
    hold(condition, variables, false);
  }

  /** Makes {@code condition} true for all values of the variables. */
  private void hold(Expr condition, List<Field> variables, boolean isLate) {
    switch (condition) {
      case Expr.Binary e when e.operator() == Expr.Operator.AND -> {
        hold(e.left(), variables);
        hold(e.right(), variables);
      }
      case Expr.Quantified e when e.forAll() ->
          hold(e.body(), Stream.concat(variables.stream(), e.variables().stream()).toList());
      case Expr.Started e ->
          set(part(e.used()), Code.name(ExpressionWriter.machine(e.used())).then("start"), e.pos());
      case Expr.Binary e
          when e.operator() == Expr.Operator.EQUAL && !isLate && !components(e.right()).isEmpty() ->
          late.put(e, variables);
      case Expr.Binary e when isOwnForEach(e, variables) -> {
        Expr.At at = (Expr.At) e.left();
        Field variable = variables.getLast();
        Code of =
            new Code.Lambda(
                JavaTypes.variable(variable.name()),
                writer.under(variable, () -> writer.of(e.right())));
        set(
            place(at.map(), List.of()),
            writer.finite().each(variable, of, at.type(), e.pos()),
            e.pos());
      }
      case Expr.Binary e when e.operator() == Expr.Operator.EQUAL ->
          set(place(e.left(), variables), writer.of(e.right()), e.pos());
      case Expr.Is e when e.constructor().fields().isEmpty() ->
          set(
              place(e.of(), variables),
              writer
                  .types()
                  .make(
                      (Type.Sum) e.of().type().base(), e.constructor().name(), List.of(), e.pos()),
              e.pos());
      case Expr.Not e -> set(place(e.of(), variables), Code.Text.FALSE, e.pos());
      default -> set(place(condition, variables), Code.Text.TRUE, condition.pos());
    }
  }

  /** Whether it gives each argument of a component a value of its own. */
  private static boolean isOwnForEach(Expr.Binary at, List<Field> variables) {
    return at.operator() == Expr.Operator.EQUAL
        && variables.size() == 1
        && Exprs.mentions(at.right(), variables.getFirst().name())
        && at.left() instanceof Expr.At left
        && left.map() instanceof Expr.Component
        && areAll(left.arguments(), variables);
  }

  /**
   * Whether {@code map} is a component whose arguments, of a type without an end, have values of their
   * own at the start.
   */
  static boolean isOwnForEach(Automaton automaton, JavaTypes types, Expr map) {
    return map.type().base() instanceof Type.MapOf of
        && types.all(of.arguments().getFirst(), map.pos()) == null
        && isOwnForEach(automaton, map);
  }

  private static boolean isOwnForEach(Automaton automaton, Expr map) {
    if (map instanceof Expr.Get get && get.of().type().base() instanceof Type.StateOf used) {
      Expr own = new Expr.Component(get.field(), get.type(), get.pos());
      return isOwnForEach(used.automaton(), own);
    }
    return map instanceof Expr.Component component
        && automaton.start().stream()
            .anyMatch(each -> isOwnForEach(each, component.name(), List.of()));
  }

  private static boolean isOwnForEach(Expr condition, String component, List<Field> variables) {
    return switch (condition) {
      case Expr.Binary e when e.operator() == Expr.Operator.AND ->
          isOwnForEach(e.left(), component, variables)
              || isOwnForEach(e.right(), component, variables);
      case Expr.Quantified e ->
          isOwnForEach(
              e.body(),
              component,
              Stream.concat(variables.stream(), e.variables().stream()).toList());
      case Expr.Binary e when isOwnForEach(e, variables) ->
          ((Expr.At) e.left()).map() instanceof Expr.Component of && of.name().equals(component);
      default -> false;
    };
  }

  private static void set(Part part, Code value, Pos pos) {
    Code before = part.value;
    if (before != null && !before.equals(value)) {
      throw new NotExecutable(pos, "the start state has two values here; expected one");
    }
    part.value = value;
  }

  private Part place(Expr at, List<Field> variables) {
    return switch (at) {
      case Expr.Component e -> part(e.name());
      case Expr.At e when areAll(e.arguments(), variables) -> place(e.map(), variables).result();
      case Expr.At e when e.arguments().stream().allMatch(Expr.Numeral.class::isInstance) ->
          place(e.map(), variables).result();
      case Expr.Get e -> place(e.of(), variables).field(e.field(), e.type());
      default ->
          throw new NotExecutable(
              at.pos(),
              "no start state is found from this condition; expected equations such as"
                  + " 'owner = none', or 'forall i: PIDS :: held(i) = {}'");
    };
  }

  private static boolean areAll(List<Expr> arguments, List<Field> variables) {
    TreeSet<String> names = new TreeSet<>();
    arguments.forEach(each -> {
      if (each instanceof Expr.Variable v
          && variables.stream().anyMatch(f -> f.name().equals(v.name()))) {
        names.add(v.name());
      }
    });
    return names.size() == arguments.size();
  }
}
