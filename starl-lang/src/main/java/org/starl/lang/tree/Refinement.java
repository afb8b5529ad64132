package org.starl.lang.tree;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.starl.lang.tree.Action.Effect;
import org.starl.lang.tree.Automaton.Component;
import org.starl.lang.tree.Automaton.Invariant;
import org.starl.lang.tree.Type.Field;

/**
 * That an automaton refines another, abstract one: a function maps its states to states of that, its
 * start states to start states, and each of its steps to a step, or to none.
 *
 * @param name of the abstract state
 * @param values the components of the abstract state, by their names; one of an automaton that is used
 *     there by its path, {@code mux.crit_set}
 * @param steps the abstract steps that an action takes, under conditions that exclude each other; an
 *     action without a step changes nothing of the abstract state
 */
public record Refinement(
    String name,
    Automaton of,
    Map<String, Expr> values,
    Map<String, List<Effect.Step>> steps,
    Pos pos) {

  /** Its name among those of invariants. */
  public String title() {
    return "refinement " + name;
  }

  /** Whether an abstract step is written there. */
  public boolean isStep(Pos at) {
    return steps.values().stream().flatMap(List::stream).anyMatch(step -> step.pos().equals(at));
  }

  /** The paths of an automaton's components, of those that it uses the components' own, and their types. */
  public static Map<String, Type> paths(Automaton of) {
    Map<String, Type> all = new LinkedHashMap<>();
    for (Component each : of.state()) {
      if (each.type() instanceof Type.StateOf used) {
        paths(used.automaton()).forEach((path, type) -> all.put(each.name() + "." + path, type));
      } else {
        all.put(each.name(), each.type());
      }
    }
    return all;
  }

  /**
   * The automaton with the abstract state as a component, which starts as what the state maps to. Its
   * actions also take the abstract steps. It refines the other one if each abstract step is enabled, and
   * {@link #mapping} and {@link #start} hold.
   */
  public Automaton beside(Automaton a) {
    List<Component> state = new ArrayList<>(a.state());
    state.add(new Component(name, new Type.StateOf(of), List.of(), ""));
    Map<String, Automaton> uses = new LinkedHashMap<>(a.uses());
    uses.put(name, of);
    List<Expr> start = new ArrayList<>(a.start());
    start.add(mapping().condition());
    List<Invariant> invariants = new ArrayList<>(a.invariants());
    invariants.add(mapping());
    return new Automaton(
        a.name(),
        a.typeParameters(),
        a.valueParameters(),
        a.assumptions(),
        Stream.concat(a.ranges().stream(), of.ranges().stream()).toList(),
        a.types(),
        List.copyOf(state),
        uses,
        a.functions(),
        List.copyOf(start),
        a.actions().stream().map(this::beside).toList(),
        List.copyOf(invariants),
        a.constraints(),
        a.ends(),
        a.progress(),
        a.refinements(),
        a.javaClass(),
        a.javaTypes(),
        a.comment(),
        a.pos());
  }

  private Action beside(Action a) {
    List<Effect> eff = new ArrayList<>(a.eff());
    eff.addAll(steps.getOrDefault(a.name(), List.of()));
    return new Action(
        a.name(),
        a.parameters(),
        a.pre(),
        List.copyOf(eff),
        a.fairness(),
        a.comment(),
        a.note(),
        a.pos());
  }

  /** That the abstract state is what the state maps to. */
  public Invariant mapping() {
    List<Expr> equal = new ArrayList<>();
    values.forEach((path, value) -> equal.add(equal(place(path, value.pos()), value)));
    return new Invariant(title(), Exprs.all(equal, pos), List.of(), pos);
  }

  /** That a state that maps to the abstract one may be the first: the abstract assumptions hold, too. */
  public Invariant start() {
    Stream<Expr> assumed = of.assumptions().stream().map(Invariant::condition);
    List<Expr> all =
        Stream.concat(assumed, Stream.of(new Expr.Started(name, of, pos)))
            .map(each -> at(each, pos))
            .toList();
    return new Invariant(title(), Exprs.all(all, pos), List.of(), pos);
  }

  private static Expr at(Expr expr, Pos pos) {
    return Exprs.rebuild(expr, pos, part -> at(part, pos));
  }

  /** The component of the abstract state that has this path. */
  public Expr place(String path, Pos at) {
    Expr place = new Expr.Component(name, new Type.StateOf(of), at);
    Automaton automaton = of;
    for (String part : path.split("\\.", -1)) {
      Type type = automaton.component(part).orElseThrow().type();
      place = new Expr.Get(place, part, type, at);
      automaton = type instanceof Type.StateOf used ? used.automaton() : automaton;
    }
    return place;
  }

  /** Maps are equal at each argument: so the place that differs can be told. */
  private static Expr equal(Expr place, Expr value) {
    Pos pos = value.pos();
    if (!(place.type().base() instanceof Type.MapOf map)) {
      return new Expr.Binary(Expr.Operator.EQUAL, place, value, Type.Bool.BOOL, pos);
    }
    List<Field> variables = new ArrayList<>();
    if (value instanceof Expr.MapOf made) {
      variables.addAll(made.variables());
    } else {
      map.arguments().forEach(each -> variables.add(new Field("x" + variables.size(), each)));
    }
    List<Expr> at = new ArrayList<>();
    variables.forEach(each -> at.add(new Expr.Variable(each.name(), each.type(), pos)));
    Expr left = new Expr.At(place, at, map.result(), pos);
    Expr right =
        value instanceof Expr.MapOf made
            ? made.body()
            : new Expr.At(value, at, ((Type.MapOf) value.type().base()).result(), pos);
    return new Expr.Quantified(true, List.copyOf(variables), equal(left, right), pos);
  }
}
