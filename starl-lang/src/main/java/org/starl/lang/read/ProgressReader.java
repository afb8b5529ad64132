package org.starl.lang.read;

import static org.starl.lang.read.Problems.pos;

import java.util.ArrayList;
import java.util.List;
import org.antlr.v4.runtime.ParserRuleContext;
import org.starl.lang.grammar.StarlParser;
import org.starl.lang.grammar.StarlParser.ProgressPartContext;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Action.Conjunct;
import org.starl.lang.tree.Automaton.Invariant;
import org.starl.lang.tree.Automaton.Progress;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Type.Field;

/** Reads what is to happen, in the names of a unit that are known. */
final class ProgressReader {

  private final PartsReader unit;
  final List<Invariant> ends = new ArrayList<>();
  final List<Progress> all = new ArrayList<>();

  ProgressReader(PartsReader unit) {
    this.unit = unit;
  }

  /**
   * Reads the parts of the unit.
   *
   * @param invariants have other names
   */
  void read(List<Invariant> invariants) {
    unit.each(
        ProgressPartContext.class, at -> read(at, at.name, at.ASSUME() != null, at.formula()));
    unit.requireUnique("progress", ProgressPartContext.class, at -> at.name);
    List<String> asked = invariants.stream().map(Invariant::name).toList();
    unit.each(
        ProgressPartContext.class,
        at -> {
          if (asked.contains(at.name.getText())) {
            unit.problems.add(
                at.name,
                "'" + at.name.getText() + "' is an invariant already; expected a new name");
          }
        });
  }

  void read(
      ParserRuleContext at,
      StarlParser.IdContext named,
      boolean isAssumed,
      StarlParser.FormulaContext whole) {
    String name = unit.newName(named);
    List<Field> variables = new ArrayList<>();
    try {
      StarlParser.FormulaContext formula = whole;
      while (formula instanceof StarlParser.AllOfContext each) {
        List<Field> more = unit.types.fields(each.binderGroup(), false);
        unit.scope.push(more);
        variables.addAll(more);
        formula = each.formula();
      }
      if (formula instanceof StarlParser.LeadsToContext it) {
        if (it.from instanceof StarlParser.QuantifiedContext quantified) {
          String word = quantified.quantifier.getText();
          throw unit.expressions.wrong(
              it.from, "'" + word + "' reaches to 'leads to' here; expected parentheses around it");
        }
        Action from = side(at, name, variables, List.of(it.from));
        Action to = side(at, name, variables, List.of(it.to));
        all.add(new Progress(name, isAssumed, false, from, to));
      } else if (isAssumed) {
        throw unit.expressions.wrong(formula, "this cannot be assumed; expected 'P leads to Q'");
      } else if (formula instanceof StarlParser.EventuallyContext it) {
        Action to = side(at, name, variables, List.of(it.to));
        all.add(new Progress(name, false, true, side(at, name, variables, List.of()), to));
      } else if (formula instanceof StarlParser.NoDeadlockContext it && variables.isEmpty()) {
        Expr end = it.to == null ? new Expr.Bool(false, pos(it)) : unit.expressions.bool(it.to);
        ends.add(new Invariant(name, end, List.of(), pos(at)));
      } else {
        throw unit.expressions.wrong(
            formula, "a deadlock is of the whole state; expected no 'forall'");
      }
    } finally {
      unit.scope.pop(variables);
    }
  }

  private Action side(
      ParserRuleContext at,
      String name,
      List<Field> variables,
      List<StarlParser.ExpressionContext> conditions) {
    return new Action(
        name,
        List.copyOf(variables),
        conditions.stream()
            .map(each -> new Conjunct(unit.expressions.bool(each), SourceText.of(each)))
            .toList(),
        List.of(),
        pos(at));
  }
}
