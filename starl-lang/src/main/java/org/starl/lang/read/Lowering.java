package org.starl.lang.read;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Action.Conjunct;
import org.starl.lang.tree.Action.Effect;
import org.starl.lang.tree.Action.Fairness;
import org.starl.lang.tree.Action.Selector;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.Component;
import org.starl.lang.tree.Automaton.Declared;
import org.starl.lang.tree.Automaton.Invariant;
import org.starl.lang.tree.Automaton.Progress;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Expr.Operator;
import org.starl.lang.tree.Exprs;
import org.starl.lang.tree.Lifting;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Primitive;
import org.starl.lang.tree.Program;
import org.starl.lang.tree.Program.Branch;
import org.starl.lang.tree.Program.Instance;
import org.starl.lang.tree.Program.Location;
import org.starl.lang.tree.Program.Statement;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Constructor;
import org.starl.lang.tree.Type.Field;

/**
 * Makes the automaton of all processes that run a program: each variable becomes a map from their ids,
 * each branch an action, each primitive a used automaton. What a call asks of the program becomes an
 * invariant, at the place of the call.
 */
final class Lowering {

  /** The type of the locations. */
  static final String LOCATION = "Location";

  private static final String LOC = "loc";

  /** Where a process is whose program has begun anew: it goes on as another process. */
  private static final String OVER = "over";

  /** Names in the automaton that the program may not have. */
  static final Set<String> NAMES = Set.of(LOC, OVER, "s", "a");

  private static final Type IDS = new Type.Opaque(Program.IDS);
  private static final List<Field> SELF = List.of(new Field(Program.SELF, IDS));

  private final Program program;
  private final boolean asksProgress;
  private final Map<String, Instance> instances = new LinkedHashMap<>();
  private final Type.Sum location;
  private final List<Action> actions = new ArrayList<>();
  private final List<Invariant> invariants = new ArrayList<>();
  private final List<Progress> assumed = new ArrayList<>();
  private final Set<String> names = new TreeSet<>();

  /**
   * @param asksProgress whether the source says what is to happen; else nothing is fair or assumed
   */
  Lowering(Program program, boolean asksProgress) {
    this.program = program;
    this.asksProgress = asksProgress;
    program.instances().forEach(each -> instances.put(each.name(), each));
    List<Constructor> constructors = new ArrayList<>();
    program.locations().forEach(each -> constructors.add(new Constructor(each.name(), List.of())));
    if (restarts().findFirst().isPresent()) {
      constructors.add(new Constructor(OVER, List.of()));
    }
    location = new Type.Sum(program.name(), LOCATION, List.copyOf(constructors));
    List<InstanceLowering> lowered =
        instances.values().stream().map(each -> new InstanceLowering(each, this::unique)).toList();
    lowered.forEach(each -> invariants.addAll(each.invariants()));
    program.locations().forEach(this::addActions);
    restarts().findFirst().ifPresent(this::addRests);
    lowered.forEach(each -> actions.addAll(each.steps(this::renamed, asksProgress)));
    if (asksProgress) {
      lowered.forEach(each -> assumed.addAll(each.assumed()));
    }
  }

  private Stream<Branch> restarts() {
    return program.locations().stream()
        .flatMap(each -> each.branches().stream())
        .filter(Branch::isRestart);
  }

  // --- the automaton

  /**
   * The automaton.
   *
   * @param own the invariants of the source, beside those of its primitives
   * @param asked what is to happen, as far as it is read
   * @param isWhole whether value parameters are left out that nothing reads
   */
  Automaton automaton(
      List<Invariant> own, List<Invariant> constraints, ProgressReader asked, boolean isWhole) {
    List<Invariant> all = Stream.concat(invariants.stream(), own.stream()).toList();
    List<Declared> types = new ArrayList<>(program.types());
    types.add(new Declared(location, List.of()));
    List<Expr> start = start();
    Set<String> mentioned = new TreeSet<>();
    start.forEach(each -> mention(each, mentioned));
    Stream.of(all, constraints, asked.ends)
        .flatMap(List::stream)
        .forEach(each -> mention(each.condition(), mentioned));
    List<Progress> progress = Stream.concat(assumed.stream(), asked.all.stream()).toList();
    progress.forEach(
        each -> List.of(each.from(), each.to()).forEach(side -> mention(side, mentioned)));
    actions.forEach(action -> mention(action, mentioned));
    List<Field> values = new ArrayList<>(valueParameters());
    Set<Field> used = usedParameters();
    values.removeIf(each -> isWhole && !mentioned.contains(each.name()) && !used.contains(each));
    Map<String, Automaton> uses = new LinkedHashMap<>();
    instances.forEach((name, instance) -> uses.put(name, instance.primitive().automaton()));
    List<String> typeParameters = new ArrayList<>(program.typeParameters());
    if (Stream.concat(state().stream().map(Component::type), values.stream().map(Field::type))
        .anyMatch(Lowering::hasText)) {
      typeParameters.add(Program.TEXT);
    }
    return new Automaton(
        program.name(),
        List.copyOf(typeParameters),
        List.copyOf(values),
        List.of(),
        List.of(),
        List.copyOf(types),
        state(),
        java.util.Collections.unmodifiableMap(uses),
        program.functions(),
        start,
        List.copyOf(actions),
        all,
        constraints,
        List.copyOf(asked.ends),
        progress,
        List.of(),
        "",
        Map.of(),
        program.comment(),
        program.pos());
  }

  private static boolean hasText(Type type) {
    return switch (type.base()) {
      case Type.Opaque opaque -> opaque.name().equals(Program.TEXT);
      case Type.SetOf set -> hasText(set.element());
      case Type.ListOf list -> hasText(list.element());
      case Type.OptionOf option -> hasText(option.element());
      case Type.MapOf map ->
          hasText(map.result()) || map.arguments().stream().anyMatch(Lowering::hasText);
      case Type.Rec rec -> rec.fields().stream().anyMatch(field -> hasText(field.type()));
      case Type.Sum sum ->
          sum.constructors().stream()
              .flatMap(each -> each.fields().stream())
              .anyMatch(field -> hasText(field.type()));
      default -> false;
    };
  }

  private Set<Field> usedParameters() {
    Set<Field> fields = new LinkedHashSet<>();
    instances
        .values()
        .forEach(each -> fields.addAll(each.primitive().automaton().valueParameters()));
    return fields;
  }

  private List<Field> valueParameters() {
    List<Field> fields = new ArrayList<>(usedParameters());
    program
        .javaFunctions()
        .forEach(function -> {
          List<Type> arguments = function.parameters().stream().map(Field::type).toList();
          fields.add(
              new Field(
                  function.name(),
                  arguments.isEmpty()
                      ? function.result()
                      : new Type.MapOf(arguments, function.result())));
        });
    program.given().forEach(each -> fields.add(new Field(each.name(), ofEach(each.type()))));
    return fields;
  }

  private static void mention(Expr expr, Set<String> names) {
    if (expr instanceof Expr.Parameter parameter) {
      names.add(parameter.name());
    }
    Exprs.parts(expr).forEach(part -> mention(part, names));
  }

  private static void mention(Action action, Set<String> names) {
    action.pre().forEach(each -> mention(each.condition(), names));
    for (Effect effect : action.eff()) {
      switch (effect) {
        case Effect.Assign assign -> mention(assign.value(), names);
        case Effect.Step step -> step.arguments().forEach(each -> mention(each, names));
      }
    }
  }

  private static Type ofEach(Type type) {
    return new Type.MapOf(List.of(IDS), type);
  }

  private List<Component> state() {
    List<Component> state = new ArrayList<>();
    state.add(new Component(LOC, ofEach(location), List.of(), ""));
    program
        .variables()
        .forEach(each ->
            state.add(
                new Component(each.name(), ofEach(each.type()), each.comment(), each.note())));
    instances
        .values()
        .forEach(each -> state.add(new Component(each.name(), stateOf(each), each.comment(), "")));
    return List.copyOf(state);
  }

  private static Type stateOf(Instance instance) {
    return new Type.StateOf(instance.primitive().automaton());
  }

  private List<Expr> start() {
    List<Expr> start = new ArrayList<>();
    program.locations().stream()
        .findFirst()
        .ifPresent(first -> start.add(forAll(locIs(first.name(), program.pos()), program.pos())));
    program
        .variables()
        .forEach(each ->
            start.add(
                forAll(
                    binary(
                        Operator.EQUAL,
                        mine(each.name(), each.type(), each.pos()),
                        lower(each.start(), Map.of()),
                        each.pos()),
                    each.pos())));
    for (Instance each : instances.values()) {
      Primitive primitive = each.primitive();
      start.add(new Expr.Started(each.name(), primitive.automaton(), each.pos()));
      Guards.conjuncts(primitive.start()).forEach(one -> start.add(lift(each, one, each.pos())));
    }
    return List.copyOf(start);
  }

  // --- expressions

  private static Expr self(Pos pos) {
    return new Expr.Variable(Program.SELF, IDS, pos);
  }

  private static Expr mine(String name, Type type, Pos pos) {
    return new Expr.At(new Expr.Component(name, ofEach(type), pos), List.of(self(pos)), type, pos);
  }

  private Expr locIs(String name, Pos pos) {
    Constructor constructor = location.constructor(name).orElseThrow();
    Expr there = new Expr.Make(constructor, List.of(), location, pos);
    return binary(Operator.EQUAL, mine(LOC, location, pos), there, pos);
  }

  private static Expr binary(Operator operator, Expr left, Expr right, Pos pos) {
    return new Expr.Binary(operator, left, right, Type.Bool.BOOL, pos);
  }

  private static Expr forAll(Expr body, Pos pos) {
    return new Expr.Quantified(true, SELF, body, pos);
  }

  /** An expression of the program about one process, as one about all. */
  private Expr lower(Expr expr, Map<String, Expr> assigned) {
    return switch (expr) {
      case Expr.Component component -> {
        Expr value = assigned.get(component.name());
        yield value != null ? value : mine(component.name(), component.type(), component.pos());
      }
      case Expr.Get get
          when get.of() instanceof Expr.Component of && instances.containsKey(of.name()) -> {
        Instance instance = Objects.requireNonNull(instances.get(of.name()));
        Expr value = instance.primitive().value(get.field()).orElseThrow().value();
        yield lift(instance, value, get.pos());
      }
      case Expr.Parameter parameter
          when program.given().stream().anyMatch(g -> g.name().equals(parameter.name())) ->
          new Expr.At(
              new Expr.Parameter(parameter.name(), ofEach(parameter.type()), parameter.pos()),
              List.of(self(parameter.pos())),
              parameter.type(),
              parameter.pos());
      default -> Exprs.rebuild(expr, part -> lower(part, assigned));
    };
  }

  static Expr lift(Instance instance, Expr expr, Pos pos) {
    return new Lifting(instance.name(), instance.primitive().automaton(), pos).lift(expr);
  }

  // --- actions

  private void addActions(Location at) {
    List<Branch> before = new ArrayList<>();
    for (Branch branch : at.branches()) {
      new Taken(at, branch, before).add();
      before.add(branch);
    }
  }

  private String unique(String wanted) {
    String name = wanted;
    for (int i = 2; !names.add(name); i++) {
      name = wanted + "_" + i;
    }
    return name;
  }

  /** A branch as an action. */
  private final class Taken {

    private final Location at;
    private final Branch branch;
    private final List<Conjunct> pre = new ArrayList<>();
    private final List<Effect> eff = new ArrayList<>();
    private final Map<String, Expr> assigned = new LinkedHashMap<>();

    private final boolean isOutcome;

    private Taken(Location at, Branch branch, List<Branch> before) {
      this.at = at;
      this.branch = branch;
      String text = LOC + "(" + Program.SELF + ") = " + at.name();
      pre.add(new Conjunct(locIs(at.name(), branch.pos()), text));
      List<Expr> rest = new ArrayList<>(Guards.conjuncts(branch.guard()));
      Optional<Guards.Happened> happened =
          rest.stream().flatMap(each -> Guards.outcome(each, instances).stream()).findFirst();
      rest.removeIf(each -> Guards.outcome(each, instances).isPresent());
      isOutcome = happened.isPresent();
      if (happened.isEmpty()) {
        before.forEach(
            this::addNot); // first: the guard may have a value only where these are false
      }
      happened.ifPresent(this::addOutcome);
      if (!rest.isEmpty()) {
        pre.add(
            new Conjunct(lower(Exprs.all(rest, branch.guard().pos()), Map.of()), branch.text()));
      }
    }

    /** It may happen whatever can be read of the primitives. */
    private void addOutcome(Guards.Happened happened) {
      Instance instance = Objects.requireNonNull(instances.get(happened.instance()));
      Automaton automaton = instance.primitive().automaton();
      Action action = happened.outcome().action();
      List<Expr> arguments =
          happened.outcome().arguments().stream()
              .map(each -> lift(instance, each, branch.pos()))
              .toList();
      Expr can =
          new Expr.Enabled(instance.name(), automaton, action, arguments, branch.guard().pos());
      pre.add(new Conjunct(can, instance.name() + "." + happened.outcome().name()));
      eff.add(
          new Effect.Step(
              Optional.empty(),
              instance.name(),
              automaton,
              action,
              arguments,
              branch.guard().pos()));
    }

    /** An outcome that is not taken says nothing. */
    private void addNot(Branch earlier) {
      List<Expr> guard = Guards.conjuncts(earlier.guard());
      if (guard.stream().noneMatch(each -> Guards.outcome(each, instances).isPresent())) {
        Expr holds = lower(earlier.guard(), Map.of());
        pre.add(new Conjunct(new Expr.Not(holds, branch.pos()), "not (" + earlier.text() + ")"));
      }
    }

    private void add() {
      for (Statement statement : branch.statements()) {
        switch (statement) {
          case Statement.Assign assign ->
              assigned.put(assign.variable(), lower(assign.value(), assigned));
          case Statement.Call call -> add(call);
        }
      }
      String to = branch.isRestart() ? OVER : branch.to();
      Constructor constructor = location.constructor(to).orElseThrow();
      List<Effect> all = new ArrayList<>();
      all.add(change(LOC, new Expr.Make(constructor, List.of(), location, branch.toPos())));
      assigned.forEach((name, value) -> all.add(change(name, value)));
      all.addAll(eff);
      String name = at.name() + (branch.isRestart() ? "_restarts" : "_to_" + to);
      actions.add(
          new Action(
              unique(name),
              SELF,
              List.copyOf(pre),
              List.copyOf(all),
              fairness(),
              List.of(),
              "",
              branch.pos()));
    }

    /**
     * A process goes on if at all times some guard of its location holds. An outcome need not come, and
     * does not come for ever: beside it, if a guard holds again and again.
     */
    private Optional<Fairness> fairness() {
      return asksProgress && !isOutcome
          ? Optional.of(
              new Fairness(
                  at.branches().stream()
                      .flatMap(each -> Guards.conjuncts(each.guard()).stream())
                      .anyMatch(each -> Guards.outcome(each, instances).isPresent()),
                  at.name(),
                  List.of(0)))
          : Optional.empty();
    }

    private Effect change(String component, Expr value) {
      List<Selector> place = List.of(new Selector.At(List.of(self(value.pos()))));
      return new Effect.Assign(component, place, value, value.pos());
    }

    /** The step, and that what is asked of the caller holds. */
    private void add(Statement.Call call) {
      Instance instance = Objects.requireNonNull(instances.get(call.instance()));
      Automaton automaton = instance.primitive().automaton();
      List<Expr> given = call.arguments().stream().map(each -> lower(each, assigned)).toList();
      Lifting lifting =
          new Lifting(instance.name(), automaton, call.pos()).with(call.call().parameters(), given);
      List<Expr> arguments = call.call().arguments().stream().map(lifting::lift).toList();
      Action action = call.call().action();
      List<Expr> asked = new ArrayList<>(call.call().pre().stream().map(lifting::lift).toList());
      asked.add(new Expr.Enabled(instance.name(), automaton, action, arguments, call.pos()));
      eff.add(
          new Effect.Step(
              Optional.empty(), instance.name(), automaton, action, arguments, call.pos()));
      List<Expr> when = pre.stream().map(Conjunct::condition).toList();
      Expr may =
          binary(
              Operator.IMPLIES,
              Exprs.all(when, call.pos()),
              Exprs.all(asked, call.pos()),
              call.pos());
      invariants.add(
          new Invariant(
              unique(at.name() + "_may_" + call.call().name()),
              forAll(may, call.pos()),
              List.of(call.text()),
              call.pos()));
    }
  }

  /** A variable has no name of the program's. */
  private Field renamed(Field field) {
    boolean isTaken =
        program.variables().stream().anyMatch(each -> each.name().equals(field.name()))
            || instances.containsKey(field.name())
            || valueParameters().stream().anyMatch(each -> each.name().equals(field.name()))
            || program.functions().stream()
                .anyMatch(each -> each.signature().name().equals(field.name()))
            || location.constructor(field.name()).isPresent();
    return isTaken ? new Field(field.name() + "_", field.type()) : field;
  }

  // --- invariants

  /** An attempt that is over leaves nothing behind in the primitives. */
  private void addRests(Branch restart) {
    for (Instance instance : instances.values()) {
      Expr rest = lift(instance, instance.primitive().rest(), restart.toPos());
      if (!(rest instanceof Expr.Bool)) {
        Pos pos = restart.toPos();
        invariants.add(
            new Invariant(
                unique("restart_leaves_" + instance.name()),
                forAll(binary(Operator.IMPLIES, locIs(OVER, pos), rest, pos), pos),
                List.of(),
                pos));
      }
    }
  }
}
