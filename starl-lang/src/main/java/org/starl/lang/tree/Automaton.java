package org.starl.lang.tree;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.starl.lang.tree.Type.Field;

/**
 * An automaton of a source, checked.
 *
 * @param typeParameters the opaque types
 * @param valueParameters values and functions that are given from outside
 * @param assumptions what is known of the values of its parameters
 * @param ranges of each range with parameters in its bounds the first number, as one that must be
 *     in it
 * @param types the types that it declares, in order, with their comments
 * @param state the components of its state, those of used automata included, in order
 * @param uses the automata that it is composed with, by component
 * @param start the conjuncts that hold of a start state
 * @param constraints a search goes on from the states in which all of them hold
 * @param ends each holds wherever no action is possible: there is no deadlock
 * @param progress what is to happen in each run, and what is assumed to
 * @param refinements the automata that it refines
 * @param javaClass the full name of its executable form; empty if the source names none
 * @param javaTypes the Java types that stand for types of the source
 * @param comment the lines of comment before it
 */
public record Automaton(
    String name,
    List<String> typeParameters,
    List<Field> valueParameters,
    List<Invariant> assumptions,
    List<Expr> ranges,
    List<Declared> types,
    List<Component> state,
    Map<String, Automaton> uses,
    List<Function> functions,
    List<Expr> start,
    List<Action> actions,
    List<Invariant> invariants,
    List<Invariant> constraints,
    List<Invariant> ends,
    List<Progress> progress,
    List<Refinement> refinements,
    String javaClass,
    Map<Type, JavaType> javaTypes,
    List<String> comment,
    Pos pos) {

  /** A type with a name. */
  public record Declared(Type.Named type, List<String> comment) {}

  /**
   * A component of the state.
   *
   * @param comment the lines of comment before it
   * @param note the comment at the end of its line; empty if there is none
   */
  public record Component(String name, Type type, List<String> comment, String note) {}

  /**
   * The Java type that stands for a type of the source.
   *
   * @param name its full name
   * @param start a constant of it that start states have where any value will do; may be empty
   */
  public record JavaType(String name, String start) {}

  /** What is to hold in every state that can be reached, or of every parameter; or, as a constraint, of the states that a search looks at. */
  public record Invariant(String name, Expr condition, List<String> comment, Pos pos) {}

  /**
   * Where {@code from} holds, {@code to} holds then or later, for all values of their parameters. Both
   * are conditions in the form of actions without effects.
   *
   * @param isAssumed whether runs in which it does not are left out
   * @param isOfStart whether this is said of start states alone
   */
  public record Progress(
      String name, boolean isAssumed, boolean isOfStart, Action from, Action to) {}

  /** Both sides of each progress, in order. */
  public List<Action> sides() {
    return progress.stream().flatMap(each -> Stream.of(each.from(), each.to())).toList();
  }

  /** The names of what is asked of its runs, and not of its states. */
  public List<String> claims() {
    return Stream.concat(
            ends.stream().map(Invariant::name),
            progress.stream().filter(each -> !each.isAssumed()).map(Progress::name))
        .toList();
  }

  /** Which runs it has: {@code fair: release}, {@code assumed: Releases}. */
  public List<String> fairness() {
    Map<String, List<String>> names = new TreeMap<>();
    for (Action each : actions) {
      each.fairness()
          .map(fairness -> fairness.isStrong() ? "strongly fair" : "fair")
          .ifPresent(how -> names.computeIfAbsent(how, key -> new ArrayList<>()).add(each.name()));
    }
    progress.stream()
        .filter(Progress::isAssumed)
        .forEach(p -> names.computeIfAbsent("assumed", key -> new ArrayList<>()).add(p.name()));
    return names.entrySet().stream()
        .map(each -> each.getKey() + ": " + String.join(", ", each.getValue()))
        .toList();
  }

  /** With the states of the automata that it refines as components: see {@link Refinement#beside}. */
  public Automaton refined() {
    Automaton all = this;
    for (Refinement each : refinements) {
      all = all.component(each.name()).isPresent() ? all : each.beside(all);
    }
    return all;
  }

  /** What is to hold of each start state. */
  public List<Invariant> starts() {
    return refinements.stream().map(Refinement::start).toList();
  }

  /** The value parameters in the bounds of ranges. */
  public Set<String> numbers() {
    Set<String> names = new TreeSet<>();
    ranges.forEach(each -> names.addAll(each.type().parameters()));
    return names;
  }

  /**
   * Its parameters, with what is assumed of them, but those of types with ranges, which may have no
   * value: it has no state.
   *
   * @param asked the ranges that it has
   */
  public Automaton ofParameters(List<Expr> asked) {
    List<Field> known =
        valueParameters.stream().filter(each -> each.type().parameters().isEmpty()).toList();
    List<String> names = known.stream().map(Field::name).toList();
    return new Automaton(
        name,
        typeParameters,
        known,
        assumptions.stream()
            .flatMap(each ->
                Exprs.conjuncts(each.condition())
                    .map(part -> new Invariant(each.name(), part, each.comment(), each.pos())))
            .filter(each -> names.containsAll(Exprs.parameters(each.condition())))
            .toList(),
        asked,
        types,
        List.of(),
        Map.of(),
        List.of(),
        List.of(),
        List.of(),
        List.of(),
        List.of(),
        List.of(),
        List.of(),
        List.of(),
        "",
        Map.of(),
        List.of(),
        pos);
  }

  /** With another executable form, and other executable forms of what it uses. */
  public Automaton inJava(
      String otherClass, Map<Type, JavaType> otherTypes, Map<String, Automaton> otherUses) {
    return new Automaton(
        name,
        typeParameters,
        valueParameters,
        assumptions,
        ranges,
        types,
        state,
        otherUses,
        functions,
        start,
        actions,
        invariants,
        constraints,
        ends,
        progress,
        refinements,
        otherClass,
        otherTypes,
        comment,
        pos);
  }

  /** The ranges that may be empty: see {@link #ranges}. */
  public List<Expr> maybeEmpty() {
    return ranges.stream().filter(each -> ((Type.Range) each.type()).mayBeEmpty()).toList();
  }

  /** The action of this name. */
  public Optional<Action> action(String wanted) {
    return actions.stream().filter(a -> a.name().equals(wanted)).findFirst();
  }

  /** The component of this name. */
  public Optional<Component> component(String wanted) {
    return state.stream().filter(c -> c.name().equals(wanted)).findFirst();
  }

  /** The function of this name. */
  public Optional<Function> function(String wanted) {
    return functions.stream().filter(f -> f.signature().name().equals(wanted)).findFirst();
  }

  /** All its expressions. */
  public Stream<Expr> expressions() {
    return Stream.of(
            functions().stream().map(Function::body),
            start().stream(),
            Stream.concat(actions().stream(), sides().stream())
                .flatMap(action ->
                    Stream.concat(
                        action.pre().stream().map(Action.Conjunct::condition),
                        action.eff().stream().flatMap(effect -> effect.parts().stream()))),
            Stream.of(assumptions(), invariants(), constraints(), ends())
                .flatMap(List::stream)
                .map(Invariant::condition))
        .flatMap(of -> of);
  }
}
