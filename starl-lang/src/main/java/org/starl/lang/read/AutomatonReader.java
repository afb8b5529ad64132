package org.starl.lang.read;

import static org.starl.lang.read.Problems.pos;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.antlr.v4.runtime.ParserRuleContext;
import org.starl.lang.grammar.StarlParser;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Action.Conjunct;
import org.starl.lang.tree.Action.Effect;
import org.starl.lang.tree.Action.Selector;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.Component;
import org.starl.lang.tree.Automaton.Invariant;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Function;
import org.starl.lang.tree.Refinement;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/** Reads one automaton: first the names that it declares, then what they mean. */
final class AutomatonReader extends PartsReader {

  private final StarlParser.UnitContext unit;
  private final java.util.function.Function<String, Optional<Automaton>> others;
  private final Predicate<String> isOpen;
  private final List<Invariant> assumptions = new ArrayList<>();
  private final List<Component> state = new ArrayList<>();
  private final List<Refinement> refinements = new ArrayList<>();

  /**
   * @param others finds the automata that this one uses or refines
   * @param isOpen whether an automaton is in a file that is being read
   */
  AutomatonReader(
      StarlParser.UnitContext unit,
      SourceText source,
      Problems problems,
      java.util.function.Function<String, Optional<Automaton>> others,
      Predicate<String> isOpen) {
    super(unit, unit.name.getText(), unit.part(), source, problems);
    this.unit = unit;
    this.others = others;
    this.isOpen = isOpen;
  }

  /** Its result is complete only if no problem was told. */
  Automaton read() {
    List<String> typeParameters = new ArrayList<>();
    List<StarlParser.ValueParameterContext> valueParameters = new ArrayList<>();
    if (unit.parameters() != null) {
      for (StarlParser.ParameterContext parameter : unit.parameters().parameter()) {
        if (parameter instanceof StarlParser.TypeParameterContext type) {
          typeParameters.add(newName(type.name));
          scope.types.put(type.name.getText(), new Type.Opaque(type.name.getText()));
        } else if (parameter instanceof StarlParser.ValueParameterContext value) {
          valueParameters.add(value);
          if (value.type().getText().equals(Type.Num.NAT.toString())) {
            scope.numbers.add(value.name.getText());
          }
        }
      }
    }
    readTypes();
    List<Field> values = new ArrayList<>();
    List<String> numbers = List.copyOf(scope.numbers);
    scope.numbers.clear(); // a parameter's type may have those before it alone
    for (StarlParser.ValueParameterContext at : valueParameters) {
      orTold(() -> {
        String name = newName(at.name);
        Field field = new Field(name, scope.declaring(name, () -> types.type(at.type())));
        scope.values.put(field.name(), field.type());
        if (numbers.contains(field.name())) {
          scope.numbers.add(field.name());
        }
        return values.add(field);
      });
    }
    scope.numbers.addAll(numbers);
    each( // before there are other names: it may speak of parameters alone
        StarlParser.AssumePartContext.class,
        at -> assumptions.add(condition(at, at.name, at.expression())));
    each(StarlParser.StatePartContext.class, at -> at.component().forEach(this::component));
    each(StarlParser.UsesPartContext.class, this::use);
    readJava();
    List<Function> functions = functions();
    List<Expr> start = new ArrayList<>();
    each(
        StarlParser.StartPartContext.class,
        at ->
            at.expression()
                .forEach(conjunct -> orTold(() -> start.add(expressions.bool(conjunct)))));
    List<Action> actions = new ArrayList<>();
    each(StarlParser.ActionPartContext.class, at -> actions.add(action(at)));
    List<Invariant> invariants = invariants();
    List<Invariant> constraints = constraints();
    ProgressReader progress = new ProgressReader(this);
    progress.read(invariants);
    RefinementReader refines = new RefinementReader(this, actions);
    each(
        StarlParser.RefinesPartContext.class,
        at -> refinements.add(refines.read(at, instance(at, at.of, at.argument()))));
    requireUnique("assumption", StarlParser.AssumePartContext.class, at -> at.name);
    requireUnique("action", StarlParser.ActionPartContext.class, at -> at.name);
    if (start.isEmpty() && problems.isEmpty()) {
      problems.add(
          unit,
          "automaton '"
              + scope.automaton
              + "' has no start; expected 'start' and a condition on its first states");
    }
    if (actions.isEmpty() && problems.isEmpty()) {
      problems.add(
          unit, "automaton '" + scope.automaton + "' has no action; expected at least one");
    }
    return new Automaton(
        scope.automaton,
        List.copyOf(typeParameters),
        List.copyOf(values),
        List.copyOf(assumptions),
        List.copyOf(scope.ranges),
        List.copyOf(declared),
        List.copyOf(state),
        java.util.Collections.unmodifiableMap(scope.uses),
        functions,
        List.copyOf(start),
        List.copyOf(actions),
        invariants,
        constraints,
        List.copyOf(progress.ends),
        List.copyOf(progress.all),
        List.copyOf(refinements),
        javaClass,
        java.util.Collections.unmodifiableMap(javaTypes),
        source.before(unit),
        pos(unit));
  }

  private void component(StarlParser.ComponentContext at) {
    orTold(() -> {
      String name = newName(at.name);
      Type type = scope.declaring(name, () -> types.type(at.type()));
      scope.state.put(name, type);
      return state.add(new Component(name, type, source.before(at), source.after(at.getStop())));
    });
  }

  /** Adds an assumption of the component {@code used}, once; another of its name keeps its own. */
  private void assume(String used, Invariant each) {
    boolean isTaken = assumptions.stream().anyMatch(own -> own.name().equals(each.name()));
    if (!assumptions.contains(each)) {
      String name = isTaken ? used + "_" + each.name() : each.name();
      assumptions.add(new Invariant(name, each.condition(), each.comment(), each.pos()));
    }
  }

  private void use(StarlParser.UsesPartContext at) {
    String name = newName(at.name);
    Automaton instance = scope.declaring(name, () -> instance(at, at.of, at.argument()));
    scope.uses.put(name, instance);
    scope.state.put(name, new Type.StateOf(instance));
    state.add(
        new Component(
            name, new Type.StateOf(instance), source.before(at), source.after(at.getStop())));
    instance.assumptions().forEach(each -> assume(name, each));
    instance.ranges().stream()
        .filter(each -> !scope.ranges.contains(each))
        .forEach(scope.ranges::add);
    scope.knowTypes(instance);
  }

  /** Another automaton, with this one's types for its parameters; these must have the same names. */
  private Automaton instance(
      ParserRuleContext at, StarlParser.IdContext of, List<StarlParser.ArgumentContext> arguments) {
    Automaton used =
        others
            .apply(of.getText())
            .orElseThrow(() ->
                expressions.wrong(
                    of,
                    of.getText().equals(scope.automaton) || isOpen.test(of.getText())
                        ? "'" + of.getText() + "' is or needs this automaton; expected no circle"
                        : "automaton '"
                            + of.getText()
                            + "' is not known; expected it before this one, or in "
                            + of.getText()
                            + ".starl beside this file"));
    List<String> given = arguments.stream().map(ParserRuleContext::getText).toList();
    List<String> wanted = new ArrayList<>(used.typeParameters());
    used.valueParameters().forEach(value -> wanted.add(value.name()));
    if (!given.equals(wanted)) {
      throw expressions.wrong(
          at,
          "'" + of.getText() + given + "' renames parameters; expected " + of.getText() + wanted);
    }
    for (String each : used.typeParameters()) {
      if (!new Type.Opaque(each).equals(scope.types.get(each))) {
        throw noParameter(at, each, of, "an opaque type");
      }
    }
    for (Field each : used.valueParameters()) {
      Type type = scope.values.get(each.name());
      if (type == null || !type.base().equals(each.type().base())) {
        throw noParameter(at, each.name(), of, each.name() + ": " + each.type());
      }
    }
    return used;
  }

  private Wrong noParameter(
      ParserRuleContext at, String parameter, StarlParser.IdContext of, String expected) {
    return expressions.wrong(
        at,
        "'%s' of %s is no parameter of %s; expected %s in [ ] after its name"
            .formatted(parameter, of.getText(), scope.automaton, expected));
  }

  private Action action(StarlParser.ActionPartContext at) {
    List<Field> parameters = fields(at.binders(), false);
    scope.push(parameters);
    try {
      List<Conjunct> pre = new ArrayList<>();
      if (at.pre() != null) {
        at.pre()
            .expression()
            .forEach(each ->
                orTold(() -> pre.add(new Conjunct(expressions.bool(each), SourceText.of(each)))));
      }
      List<Effect> eff = new ArrayList<>();
      if (at.eff() != null) {
        at.eff().effect().forEach(each -> orTold(() -> eff.add(effect(each))));
        requireApart(at, eff);
      }
      ParserRuleContext head = at.binders() == null ? at.name : at.binders();
      return new Action(
          at.name.getText(),
          parameters,
          List.copyOf(pre),
          List.copyOf(eff),
          Optional.ofNullable(at.fairness()).map(each -> fairness(each, at.name, parameters)),
          source.before(at),
          source.after(head.getStop()),
          pos(at));
    } finally {
      scope.pop(parameters);
    }
  }

  /** Effects happen at once: no two may change the same place. */
  private void requireApart(StarlParser.ActionPartContext at, List<Effect> eff) {
    Set<String> places = new TreeSet<>();
    for (int i = 0; i < eff.size(); i++) {
      if (eff.get(i) instanceof Effect.Assign
          && at.eff().effect(i) instanceof StarlParser.AssignmentContext assignment) {
        String place = SourceText.of(assignment.place());
        if (places.stream().anyMatch(each -> isWithin(place, each) || isWithin(each, place))) {
          problems.add(
              assignment, "'" + place + "' is changed twice; expected one effect on each place");
        }
        places.add(place);
      }
    }
  }

  /** Whether a place is the other one, or a part of it: {@code x(i).a} of {@code x(i)}. */
  private static boolean isWithin(String place, String whole) {
    return place.equals(whole) || place.startsWith(whole + "(") || place.startsWith(whole + ".");
  }

  private Effect effect(StarlParser.EffectContext at) {
    if (at instanceof StarlParser.UsedActionContext step) {
      String used = step.used.getText();
      Automaton automaton = scope.uses.get(used);
      if (scope.wrong.contains(used)) {
        throw new Wrong();
      }
      if (automaton == null) {
        throw expressions.wrong(
            step,
            "'"
                + used
                + "' is no used automaton; expected 'place := value', or one of "
                + scope.uses.keySet());
      }
      Action action = action(step.action, automaton);
      return new Effect.Step(
          Optional.ofNullable(step.condition).map(expressions::bool),
          used,
          automaton,
          action,
          expressions.arguments(
              action.name(),
              action.parameters(),
              step.arguments() == null ? List.of() : step.arguments().expression(),
              step),
          pos(step));
    }
    StarlParser.AssignmentContext assignment = (StarlParser.AssignmentContext) at;
    StarlParser.PlaceContext place = assignment.place();
    String component = place.name.getText();
    Type type = scope.state.get(component);
    if (type != null) {
      problems.refer(place.name, component + ": " + type, scope.place(component, place.name));
    }
    if (scope.wrong.contains(component)) {
      throw new Wrong();
    }
    if (type == null) {
      throw expressions.wrong(
          place,
          "'"
              + component
              + "' is no component of the state; expected one of "
              + scope.state.keySet());
    }
    List<Selector> selectors = new ArrayList<>();
    for (StarlParser.SelectorContext each : place.selector()) {
      if (each instanceof StarlParser.AtContext arguments) {
        if (!(type.base() instanceof Type.MapOf map)) {
          throw expressions.wrong(
              place,
              "'%s': this is of type %s; expected a map before '('%s"
                  .formatted(
                      SourceText.of(place),
                      type,
                      type.base() instanceof Type.ListOf ? ", or a whole list as the value" : ""));
        }
        List<Field> parameters =
            map.arguments().stream().map(argument -> new Field("", argument)).toList();
        selectors.add(
            new Selector.At(
                expressions.arguments(component, parameters, arguments.expression(), each)));
        type = map.result();
      } else if (each instanceof StarlParser.FieldContext field) {
        String name = field.name.getText();
        if (!(type.base() instanceof Type.Rec rec) || rec.field(name).isEmpty()) {
          throw expressions.wrong(
              each, "'" + name + "' is no field of " + type + "; expected a field of a record");
        }
        type = rec.field(name).get().type();
        selectors.add(new Selector.Of(name));
      }
    }
    return new Effect.Assign(
        component,
        List.copyOf(selectors),
        expressions.read(assignment.expression(), type),
        pos(assignment));
  }
}
