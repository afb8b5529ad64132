package org.starl.lang.eval;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.starl.lang.eval.Code.Frame;
import org.starl.lang.tree.Automaton.Invariant;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Type.Field;

/**
 * The start states of a machine. The condition is evaluated with states that are full of holes; where
 * an evaluation meets a hole, each value of it is tried. This method is Korat's (Boyapati, Khurshid,
 * Marinov, ISSTA 2002).
 */
public final class Starts {

  /** So many start states are gone through, at most. */
  public static final int MOST = 100_000;

  private static final String START = "start";

  /** A conjunct of the condition, for values of its variables; the name is that of an assumption. */
  private record Goal(
      String name, Code code, @Nullable Code place, @Nullable Code value, Frame frame) {}

  private final Machine machine;
  private final Object[] root;
  private final List<Hole> holes = new ArrayList<>();
  private final List<Goal> goals = new ArrayList<>();
  private String named = START;

  /** Each with the conditions that are not decided of it. */
  private final Map<Row, Set<String>> states = new LinkedHashMap<>();

  private final Set<String> open = new TreeSet<>();
  private final Set<String> cut = new TreeSet<>();
  private final Set<String> bounded = new TreeSet<>();

  /** The conditions on the way to a state that need values beyond the bounds. */
  private final List<String> passed = new ArrayList<>();

  /** The parts that have a value beyond the bounds now: what is found then is no state to visit. */
  private final Set<String> beyond = new TreeSet<>();

  Starts(Machine machine, Map<String, Object> given) {
    this.machine = machine;
    List<Machine.Part> parts = machine.parts();
    root = new Object[parts.size()];
    for (int i = 0; i < root.length; i++) {
      String name = parts.get(i).name();
      Object value =
          machine.domains().number(name).<Object>map(Num::of).orElseGet(() -> given.get(name));
      root[i] = value == null ? hollow(parts.get(i).domain(), i) : value;
    }
    Compiler compiler =
        new Compiler(machine.automaton(), machine.domains(), machine.parameters(), true);
    Frame frame = new Frame(root, root, machine.parameters().size(), new Object[0], 0);
    for (Expr range : machine.automaton().ranges()) {
      compiler.code(range, new Compiler.Scope()).of(frame); // an error if it is empty
    }
    for (Invariant assumption : machine.automaton().assumptions()) {
      named = assumption.name();
      expand(List.of(assumption.condition()), compiler, frame);
    }
    named = START;
    expand(machine.automaton().start(), compiler, frame);
    solve(0);
  }

  /** The start states, each once. */
  public List<Row> states() {
    return List.copyOf(states.keySet());
  }

  /** The parts that the condition leaves open, and of which all values are among the states. */
  public Set<String> open() {
    return Collections.unmodifiableSet(open);
  }

  /** The parts that the condition leaves open, and of which only the first value is. */
  public Set<String> cut() {
    return Collections.unmodifiableSet(cut);
  }

  /** The parts that may have values beyond the bounds in start states, which are not among them. */
  public Set<String> bounded() {
    return Collections.unmodifiableSet(bounded);
  }

  /** The assumptions, or the start, that could not be asked of this state: it may be none. */
  public Set<String> unasked(Row state) {
    return states.getOrDefault(state, Set.of());
  }

  /** The conditions that could not be asked of some states: they need values beyond the bounds. */
  public Map<String, Long> unasked() {
    return states.values().stream()
        .flatMap(Set::stream)
        .collect(Collectors.groupingBy(name -> name, TreeMap::new, Collectors.counting()));
  }

  private Object hollow(Domain domain, int part) {
    if (domain instanceof Domain.Maps map) {
      return new Row(
          IntStream.range(0, (int) map.arguments.size)
              .mapToObj(i -> hollow(map.result, part))
              .toArray());
    }
    if (domain instanceof Domain.Records rec) {
      return new Row(rec.fields.parts.stream().map(field -> hollow(field, part)).toArray());
    }
    Hole hole = new Hole(domain, part);
    holes.add(hole);
    return hole;
  }

  private void expand(List<Expr> conditions, Compiler compiler, Frame frame) {
    conditions.forEach(each ->
        expand(
            each, compiler, frame, new Compiler.Scope(), Collections.singletonList(new Object[0])));
  }

  /** Adds the conjuncts of {@code expr} for each of the values of bound variables. */
  private void expand(
      Expr expr, Compiler compiler, Frame frame, Compiler.Scope scope, List<Object[]> bindings) {
    if (expr instanceof Expr.Binary and && and.operator() == Expr.Operator.AND) {
      expand(and.left(), compiler, frame, scope, bindings);
      expand(and.right(), compiler, frame, scope, bindings);
    } else if (expr instanceof Expr.Quantified all && all.forAll()) {
      List<Object[]> more = bindings;
      for (Domain domain : compiler.bind(all.variables(), scope, all.pos())) {
        more = extended(more, domain);
      }
      expand(all.body(), compiler, frame, scope, more);
      scope.pop(all.variables());
    } else if (expr instanceof Expr.Started started) {
      Frame inside = Compiler.inside(frame, compiler.component(started.used()), new Object[0]);
      expand(started.automaton().start(), compiler.used(started.used()), inside);
    } else {
      add(expr, compiler, frame, scope, bindings);
    }
  }

  private static List<Object[]> extended(List<Object[]> bindings, Domain domain) {
    if (bindings.size() * (long) domain.instances().size() > Domain.MOST) {
      throw new TooLarge(
          "start: more than %,d instances of a 'forall' at these sizes; give smaller sizes (--robots, --size, --nat, --time)"
              .formatted(Domain.MOST));
    }
    List<Object[]> more = new ArrayList<>();
    for (Object[] binding : bindings) {
      for (Object value : domain.instances()) {
        Object[] longer = Arrays.copyOf(binding, binding.length + 1);
        longer[binding.length] = value;
        more.add(longer);
      }
    }
    return more;
  }

  private void add(
      Expr expr, Compiler compiler, Frame frame, Compiler.Scope scope, List<Object[]> bindings) {
    Code code = compiler.code(expr, scope);
    Code place = null;
    Code value = null;
    if (expr instanceof Expr.Binary equal && equal.operator() == Expr.Operator.EQUAL) {
      place = compiler.place(equal.left(), scope);
      value = compiler.code(equal.right(), scope);
    }
    for (Object[] binding : bindings) {
      Object[] locals = Arrays.copyOf(binding, scope.most);
      goals.add(
          new Goal(
              named,
              code,
              place,
              value,
              new Frame(frame.root, frame.state, frame.offset, locals, 0)));
    }
  }

  private void solve(int number) {
    if (number == goals.size()) {
      addStates();
      return;
    }
    Goal goal = goals.get(number);
    List<Hole> filled = new ArrayList<>();
    List<Hole> outside = new ArrayList<>();
    List<String> added = List.of();
    int before = passed.size();
    try {
      if (isTrue(goal, filled, outside)) {
        filled.stream()
            .filter(hole -> hole.value != null && !hole.domain.contains(hole.value))
            .forEach(outside::add);
        added =
            outside.stream()
                .map(hole -> machine.parts().get(hole.part).name())
                .filter(name -> beyond.isEmpty() && beyond.add(name))
                .toList();
        solve(number + 1);
      }
    } catch (Hole.Needed needed) {
      tryAll(needed.hole, number);
    } finally {
      passed.subList(before, passed.size()).clear();
      added.forEach(beyond::remove);
      filled.forEach(hole -> hole.value = null);
    }
  }

  private void tryAll(Hole hole, int number) {
    String name = machine.parts().get(hole.part).name();
    machine.domains().requireFew(hole.domain, name);
    for (Object value : hole.domain.values()) {
      hole.value = value;
      solve(number);
    }
    if (hole.domain.hasMore()) {
      bounded.add(name);
    }
    boolean isFirst = beyond.add(name);
    for (Object value : hole.domain.others()) {
      hole.value = value;
      solve(number);
    }
    if (isFirst) {
      beyond.remove(name);
    }
    hole.value = null;
  }

  /**
   * What is beyond the bounds is not asked of a start state, and noted; what a map is there is not: the
   * state does not say it.
   *
   * @param outside a hole that has a value beyond the bounds
   */
  private boolean isTrue(Goal goal, List<Hole> filled, List<Hole> outside) {
    Object part = null;
    try {
      if (goal.place != null && goal.value != null) {
        part = goal.place.of(goal.frame);
        return fill(part, goal.value.of(goal.frame), filled);
      }
      return goal.code.test(goal.frame);
    } catch (Beyond e) {
      Hole hole = firstOpen(part);
      if (hole != null && !e.isArgument()) {
        outside.add(hole);
      } else if (!e.isArgument() || !goal.name.equals(START)) {
        passed.add(goal.name);
      }
      return true;
    }
  }

  private static @Nullable Hole firstOpen(@Nullable Object part) {
    if (part instanceof Row row) {
      for (Object item : row.items()) {
        Hole open = firstOpen(item);
        if (open != null) {
          return open;
        }
      }
    }
    return part instanceof Hole hole && hole.value == null ? hole : null;
  }

  /** Whether {@code part} is equal to {@code value}, which becomes the value of its holes. */
  private static boolean fill(Object part, Object value, List<Hole> filled) {
    if (part instanceof Hole hole) {
      if (hole.value == null) {
        if (!hole.domain.isOpen() && !hole.domain.contains(value)) {
          return false; // a number outside of a range
        }
        hole.value = value;
        filled.add(hole);
      }
      return value.equals(hole.value);
    }
    if (part instanceof Row row && value instanceof Row values && row.size() == values.size()) {
      return IntStream.range(0, row.size()).allMatch(i -> fill(row.get(i), values.get(i), filled));
    }
    return part.equals(value);
  }

  /** Adds the states of all values of the holes that are still open. */
  private void addStates() {
    if (!beyond.isEmpty()) {
      bounded.addAll(beyond);
      return;
    }
    Map<Integer, List<Hole>> free = new TreeMap<>();
    holes.stream()
        .filter(hole -> hole.value == null)
        .forEach(hole -> free.computeIfAbsent(hole.part, at -> new ArrayList<>()).add(hole));
    List<Hole> tried = new ArrayList<>();
    long count = 1;
    for (Map.Entry<Integer, List<Hole>> each : free.entrySet()) {
      String name = machine.parts().get(each.getKey()).name();
      long all =
          each.getValue().stream()
              .mapToLong(hole -> hole.domain.size())
              .reduce(count, Domain::times);
      if (all <= MOST && !cut.contains(name)) {
        open.add(name);
        if (each.getValue().stream().anyMatch(hole -> hole.domain.isOpen())) {
          bounded.add(name);
        }
        tried.addAll(each.getValue());
        count = all;
      } else {
        requireNoParameter(each.getKey());
        cut.add(name);
        open.remove(name);
        each.getValue().forEach(hole -> hole.value = hole.domain.make(0));
      }
    }
    addStates(tried, 0);
    free.values().forEach(all -> all.forEach(hole -> hole.value = null));
  }

  private void requireNoParameter(int part) {
    if (part < machine.parameters().size()) {
      Field parameter = machine.parameters().get(part);
      throw new TooLarge(
          "value parameter '%s': more than %,d values at these sizes; give one: --value '%s=...', of type %s"
              .formatted(parameter.name(), MOST, parameter.name(), parameter.type()));
    }
  }

  private void addStates(List<Hole> tried, int number) {
    if (number < tried.size()) {
      Hole hole = tried.get(number);
      for (Object value : hole.domain.values()) {
        hole.value = value;
        addStates(tried, number + 1);
      }
    } else {
      states.merge(
          (Row) Compiler.filled(new Row(root.clone())),
          new TreeSet<>(passed),
          (known, other) -> other.isEmpty() ? other : known);
      if (states.size() > MOST) {
        throw new TooLarge(
            "start: more than %,d start states at these sizes; expected a start that leaves less open, or smaller sizes (--robots, --size, --nat, --time)"
                .formatted(MOST));
      }
    }
  }
}
