package org.starl.lang.eval;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.starl.lang.tree.Action.Conjunct;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Type.Field;

/**
 * The part of a false condition that is false.
 *
 * @param variables the values for which it is, as {@code i = bot0}; empty if it has no variables
 * @param why the false condition of a used automaton's action, if that is not enabled; else empty
 */
public record Witness(Pos pos, String variables, String why) {

  /** Looks for the part. */
  static final class Finder {

    private final Compiler compiler;
    private final Row state;
    private final int parameters;
    private final Compiler.Scope scope = new Compiler.Scope();
    private final List<Object> values = new ArrayList<>();
    private final List<String> texts = new ArrayList<>();
    private String why = "";

    Finder(Compiler compiler, Row state, int parameters) {
      this.compiler = compiler;
      this.state = state;
      this.parameters = parameters;
    }

    Witness find(Expr isFalse) {
      Pos pos =
          switch (isFalse) {
            case Expr.Binary and when and.operator() == Expr.Operator.AND ->
                find(isTrue(and.left()) ? and.right() : and.left()).pos();
            case Expr.Binary implies when implies.operator() == Expr.Operator.IMPLIES ->
                find(implies.right()).pos();
            case Expr.Quantified all when all.forAll() && choose(all, 0) -> find(all.body()).pos();
            default -> leaf(isFalse);
          };
      return new Witness(pos, String.join(", ", texts), why);
    }

    private Pos leaf(Expr isFalse) {
      if (isFalse instanceof Expr.Enabled step) {
        Code[] arguments = compiler.codes(step.arguments(), scope);
        why = why(compiler, step, arguments, frame());
      } else if (isFalse instanceof Expr.Started started) {
        why = started.used() + " is no start state of " + started.automaton().name();
      }
      return isFalse.pos();
    }

    /** The condition of a used automaton's action that is false, or of one that this one uses. */
    private static String why(
        Compiler compiler, Expr.Enabled step, Code[] arguments, Code.Frame frame) {
      Compiler used = compiler.used(step.used());
      Act act = new Act(step.action(), used);
      Row given = Compiler.row(arguments, frame);
      List<Object> values = List.of(given.items());
      int component = compiler.component(step.used());
      int number = act.firstFalse(Compiler.inside(frame, component, act.locals(values)));
      if (number < 0) {
        return "";
      }
      Conjunct isFalse = step.action().pre().get(number);
      if (isFalse.condition() instanceof Expr.Enabled inner) {
        Compiler.Scope scope = new Compiler.Scope();
        scope.push(step.action().parameters());
        Code[] codes = used.codes(inner.arguments(), scope);
        Object[] locals = Arrays.copyOf(values.toArray(), scope.most);
        return why(used, inner, codes, Compiler.inside(frame, component, locals));
      }
      return "%s.%s is not enabled: '%s' is false"
          .formatted(step.used(), act.text(given.items()), isFalse.text());
    }

    private Code.Frame frame() {
      Object[] locals = Arrays.copyOf(values.toArray(), scope.most);
      return new Code.Frame(state.items(), state.items(), parameters, locals, 0);
    }

    /** Chooses values of the variables for which the body is false. */
    private boolean choose(Expr.Quantified all, int variable) {
      if (variable == all.variables().size()) {
        return !isTrue(all.body());
      }
      Field field = all.variables().get(variable);
      Domain domain = compiler.domains().of(field.type());
      scope.push(List.of(field));
      for (Object value : domain.instances()) {
        values.add(value);
        texts.add(field.name() + " = " + domain.text(value));
        if (choose(all, variable + 1)) {
          return true;
        }
        values.removeLast();
        texts.removeLast();
      }
      scope.pop(List.of(field));
      return false;
    }

    private boolean isTrue(Expr condition) {
      Code code = compiler.code(condition, scope);
      try {
        return code.test(frame());
      } catch (Beyond e) {
        return true; // undecided: what is false is elsewhere
      }
    }
  }
}
