package org.starl.lang.eval;

import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.starl.lang.tree.Action.Conjunct;
import org.starl.lang.tree.Action.Effect;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Exprs;
import org.starl.lang.tree.Type.Field;

/** The parts of a state that expressions read: of a used automaton, all its state and all parameters. */
final class Reads {

  private final Automaton automaton;
  private final List<String> parameters;
  private final Set<String> functions = new HashSet<>();
  private final BitSet parts = new BitSet();

  Reads(Automaton automaton, List<Field> parameters) {
    this.automaton = automaton;
    this.parameters = parameters.stream().map(Field::name).toList();
  }

  /** The numbers of the parts, in order. */
  int[] parts() {
    return parts.stream().toArray();
  }

  Reads addAll(List<Conjunct> conjuncts) {
    conjuncts.forEach(each -> add(each.condition()));
    return this;
  }

  Reads add(Expr at) {
    switch (at) {
      case Expr.Parameter parameter -> parts.set(parameters.indexOf(parameter.name()));
      case Expr.Component component -> part(component.name());
      case Expr.Enabled enabled -> addUsed(enabled.used());
      case Expr.Started started -> addUsed(started.used());
      case Expr.Call call when !call.used().isEmpty() -> addUsed(call.used());
      case Expr.Call call when functions.add(call.function().name()) ->
          automaton.function(call.function().name()).ifPresent(each -> add(each.body()));
      default -> {}
    }
    Exprs.parts(at).forEach(this::add);
    return this;
  }

  /** Returns the number of the part that the effect changes. */
  int add(Effect effect) {
    effect.parts().forEach(this::add);
    return switch (effect) {
      case Effect.Assign assign -> part(assign.component());
      case Effect.Step step -> addUsed(step.used());
    };
  }

  private int addUsed(String component) {
    parts.set(0, parameters.size());
    return part(component);
  }

  private int part(String component) {
    int part = parameters.size() + Compiler.component(component, automaton);
    parts.set(part);
    return part;
  }
}
