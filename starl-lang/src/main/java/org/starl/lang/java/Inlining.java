package org.starl.lang.java;

import java.util.List;
import java.util.Objects;
import org.starl.lang.tree.Action.Conjunct;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Exprs;
import org.starl.lang.tree.Function;
import org.starl.lang.tree.Lifting;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Substitution;
import org.starl.lang.tree.Type.Field;

/** Puts arguments in the place of the parameters of an automaton's functions. */
final class Inlining {

  private final Automaton automaton;
  private final Substitution substitution = new Substitution();

  Inlining(Automaton automaton) {
    this.automaton = automaton;
  }

  /** The body of the called function, of its arguments. */
  Expr body(Expr.Call call) {
    Automaton owner = owner(call.used());
    Function function = owner.function(call.function().name()).orElseThrow();
    if (function.measure().isPresent()) {
      throw new NotExecutable(
          call.pos(),
          "'"
              + call.function().name()
              + "' calls itself, and cannot be evaluated for all values of a variable; expected a"
              + " condition on finitely many values, such as 'i in S =>'");
    }
    return call.used().isEmpty()
        ? substitution.of(function, call.arguments())
        : lifted(
            call.used(),
            function.signature().parameters(),
            call.arguments(),
            function.body(),
            call.pos());
  }

  /** The condition of a used automaton's action, of its arguments. */
  Expr condition(Expr.Enabled at) {
    Expr all = Exprs.all(at.action().pre().stream().map(Conjunct::condition).toList(), at.pos());
    return lifted(at.used(), at.action().parameters(), at.arguments(), all, at.pos());
  }

  private Automaton owner(String used) {
    return used.isEmpty() ? automaton : Objects.requireNonNull(automaton.uses().get(used), used);
  }

  private Expr lifted(String used, List<Field> parameters, List<Expr> arguments, Expr of, Pos pos) {
    try {
      return new Lifting(used, owner(used), pos).with(parameters, arguments).lift(of);
    } catch (IllegalArgumentException e) {
      throw new NotExecutable(pos, String.valueOf(e.getMessage()));
    }
  }
}
