package org.starl.lang.java;

import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Function;
import org.starl.lang.tree.Substitution;

/** Puts arguments in the place of the parameters of an automaton's functions. */
final class Inlining {

  private final Automaton automaton;
  private final Substitution substitution = new Substitution();

  Inlining(Automaton automaton) {
    this.automaton = automaton;
  }

  /** The body of the called function, of its arguments. */
  Expr body(Expr.Call call) {
    Function function =
        automaton
            .function(call.function().name())
            .filter(known -> call.used().isEmpty())
            .orElseThrow(() ->
                new NotExecutable(
                    call.pos(),
                    "'"
                        + call.function().name()
                        + "' of "
                        + call.used()
                        + " has no Java form yet"));
    if (function.measure().isPresent()) {
      throw new NotExecutable(
          call.pos(),
          "'"
              + call.function().name()
              + "' calls itself, and cannot be evaluated for all values of a variable; expected a"
              + " condition on finitely many values, such as 'i in S =>'");
    }
    return substitution.of(function, call.arguments());
  }
}
