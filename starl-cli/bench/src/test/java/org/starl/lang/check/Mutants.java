package org.starl.lang.check;

import java.util.ArrayList;
import java.util.List;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Action.Conjunct;
import org.starl.lang.tree.Action.Effect;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;

/** Automata with one thing made wrong: a condition dropped or denied, or an effect dropped. */
public final class Mutants {

  /** One of them; {@code action} is its changed action. */
  public record Mutant(Action action, String change, Automaton automaton) {

    @Override
    public String toString() {
      return action.name() + " " + change;
    }
  }

  private Mutants() {}

  /** One for each condition that is dropped, each that is denied, and each effect that is dropped. */
  public static List<Mutant> of(Automaton automaton) {
    List<Mutant> all = new ArrayList<>();
    for (Action action : automaton.actions()) {
      for (int i = 0; i < action.pre().size(); i++) {
        Conjunct conjunct = action.pre().get(i);
        List<Conjunct> less = without(action.pre(), i);
        all.add(mutant(automaton, action, less, action.eff(), "without " + conjunct.text()));
        List<Conjunct> denied = new ArrayList<>(action.pre());
        denied.set(
            i, new Conjunct(new Expr.Not(conjunct.condition(), action.pos()), conjunct.text()));
        all.add(mutant(automaton, action, denied, action.eff(), "with not " + conjunct.text()));
      }
      for (int i = 0; i < action.eff().size(); i++) {
        List<Effect> less = without(action.eff(), i);
        all.add(mutant(automaton, action, action.pre(), less, "without effect " + (i + 1)));
      }
    }
    return all;
  }

  private static Mutant mutant(
      Automaton of, Action action, List<Conjunct> pre, List<Effect> eff, String change) {
    Action changed =
        new Action(
            action.name(),
            action.parameters(),
            pre,
            eff,
            action.fairness(),
            action.comment(),
            action.note(),
            action.pos());
    List<Action> actions = new ArrayList<>(of.actions());
    actions.set(actions.indexOf(action), changed);
    return new Mutant(changed, change, with(of, actions));
  }

  /** The automaton with other actions. */
  public static Automaton with(Automaton of, List<Action> actions) {
    return new Automaton(
        of.name(),
        of.typeParameters(),
        of.valueParameters(),
        of.assumptions(),
        of.ranges(),
        of.types(),
        of.state(),
        of.uses(),
        of.functions(),
        of.start(),
        actions,
        of.invariants(),
        of.constraints(),
        of.ends(),
        of.progress(),
        of.refinements(),
        of.javaClass(),
        of.javaTypes(),
        of.comment(),
        of.pos());
  }

  private static <T> List<T> without(List<T> list, int index) {
    List<T> less = new ArrayList<>(list);
    less.remove(index);
    return less;
  }
}
