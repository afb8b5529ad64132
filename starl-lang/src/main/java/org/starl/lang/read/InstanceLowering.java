package org.starl.lang.read;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Action.Conjunct;
import org.starl.lang.tree.Action.Effect;
import org.starl.lang.tree.Action.Fairness;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.Invariant;
import org.starl.lang.tree.Automaton.Progress;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Lifting;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Primitive;
import org.starl.lang.tree.Program.Instance;
import org.starl.lang.tree.Type.Field;

/** What an instance of a primitive brings into the automaton of a program. */
final class InstanceLowering {

  private final Instance instance;
  private final Automaton automaton;
  private final Pos pos;
  private final UnaryOperator<String> unique;

  /**
   * @param unique makes a name that nothing else has
   */
  InstanceLowering(Instance instance, UnaryOperator<String> unique) {
    this.instance = instance;
    this.unique = unique;
    automaton = instance.primitive().automaton();
    pos = instance.pos();
  }

  private String named(String name) {
    return instance.name() + "_" + name;
  }

  /** The invariants of its automaton, and of those that it uses, hold here, too. */
  List<Invariant> invariants() {
    List<Invariant> all = new ArrayList<>();
    addInvariants(all, automaton, new Lifting(instance.name(), automaton, pos));
    return all;
  }

  private void addInvariants(List<Invariant> all, Automaton of, Lifting lifting) {
    for (Invariant each : of.invariants()) {
      Expr condition = lifting.lift(each.condition());
      all.add(new Invariant(unique.apply(named(each.name())), condition, each.comment(), pos));
    }
    of.uses().forEach((name, used) -> addInvariants(all, used, lifting.inside(name)));
  }

  /**
   * The steps that it takes by itself.
   *
   * @param renamed gives a parameter a name that the program has not
   */
  List<Action> steps(UnaryOperator<Field> renamed, boolean areFair) {
    List<Action> all = new ArrayList<>();
    for (Primitive.Step each : instance.primitive().steps()) {
      Action step = each.action();
      List<Field> parameters = step.parameters().stream().map(renamed).toList();
      List<Expr> arguments = new ArrayList<>();
      parameters.forEach(p -> arguments.add(new Expr.Variable(p.name(), p.type(), pos)));
      List<String> shown = parameters.stream().map(Field::name).toList();
      String text = instance.name() + "." + step.name() + "(" + String.join(", ", shown) + ")";
      Expr can = new Expr.Enabled(instance.name(), automaton, step, arguments, pos);
      Effect taken =
          new Effect.Step(Optional.empty(), instance.name(), automaton, step, arguments, pos);
      Optional<Fairness> fairness =
          each.fairness()
              .filter(fair -> areFair)
              .map(fair -> new Fairness(fair.isStrong(), named(fair.group()), fair.each()));
      all.add(
          new Action(
              unique.apply(named(step.name())),
              parameters,
              List.of(new Conjunct(can, text)),
              List.of(taken),
              fairness,
              List.of(),
              "",
              pos));
    }
    return all;
  }

  /** What is assumed to happen. */
  List<Progress> assumed() {
    List<Progress> all = new ArrayList<>();
    for (Progress each : instance.primitive().assumed()) {
      String name = unique.apply(named(each.name()));
      all.add(
          new Progress(
              name, true, each.isOfStart(), side(name, each.from()), side(name, each.to())));
    }
    return all;
  }

  private Action side(String name, Action side) {
    List<Conjunct> pre =
        side.pre().stream()
            .map(each -> new Conjunct(Lowering.lift(instance, each.condition(), pos), each.text()))
            .toList();
    return new Action(name, side.parameters(), pre, List.of(), pos);
  }
}
