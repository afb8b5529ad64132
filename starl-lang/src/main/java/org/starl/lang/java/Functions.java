package org.starl.lang.java;

import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Exprs;
import org.starl.lang.tree.Function;

/** Which functions an expression calls, and what they read. */
final class Functions {

  private Functions() {}

  /** Whether a function reads a value parameter, or asks a used automaton, itself or through others. */
  static boolean needsParameters(Automaton automaton, String function) {
    Set<String> called = new TreeSet<>(Set.of(function));
    automaton.function(function).ifPresent(f -> collect(automaton, f.body(), called));
    return called.stream()
        .flatMap(name -> automaton.function(name).stream())
        .anyMatch(f -> readsParameter(automaton, f.body()));
  }

  /** Whether the Java of {@code automaton} has a method of this function. */
  static boolean isWritten(Automaton automaton, String function) {
    return Stream.of(true, false)
        .flatMap(each -> written(automaton, each).stream())
        .anyMatch(f -> f.signature().name().equals(function));
  }

  /**
   * The functions to write: those that actions need, and others that can be evaluated.
   *
   * @param withParameters those that read value parameters, or the others
   */
  static List<Function> written(Automaton automaton, boolean withParameters) {
    Set<String> needed = new TreeSet<>();
    for (Action action : automaton.actions()) {
      action.pre().forEach(each -> collect(automaton, each.condition(), needed));
      action.eff().stream()
          .flatMap(effect -> effect.parts().stream())
          .forEach(each -> collect(automaton, each, needed));
    }
    return automaton.functions().stream()
        .filter(f -> needsParameters(automaton, f.signature().name()) == withParameters)
        .filter(f -> needed.contains(f.signature().name()) || canBeWritten(automaton, f))
        .toList();
  }

  private static boolean canBeWritten(Automaton automaton, Function f) {
    ExpressionWriter trial =
        new ExpressionWriter(
            automaton, new JavaTypes(automaton, Names.of(automaton), false), "s", "");
    f.signature().parameters().forEach(p -> trial.bind(p.name(), Code.name(p.name())));
    try {
      trial.of(f.body());
      return true;
    } catch (NotExecutable e) {
      return false;
    }
  }

  /** Adds the functions that {@code at} calls, also through others. */
  static void collect(Automaton automaton, Expr at, Set<String> called) {
    if (at instanceof Expr.Call call
        && call.used().isEmpty()
        && called.add(call.function().name())) {
      automaton
          .function(call.function().name())
          .ifPresent(f -> collect(automaton, f.body(), called));
    }
    Exprs.parts(at).forEach(part -> collect(automaton, part, called));
  }

  /** Whether {@code at}, or a function that it calls, has no value for some arguments. */
  static boolean isPartial(Automaton automaton, Expr at) {
    Set<String> called = new TreeSet<>();
    collect(automaton, at, called);
    return Stream.concat(
            Stream.of(at),
            called.stream().flatMap(name -> automaton.function(name).stream()).map(Function::body))
        .anyMatch(each -> Exprs.isPartial(each) || isPartialInUsed(automaton, each));
  }

  private static boolean isPartialInUsed(Automaton automaton, Expr at) {
    boolean isPartial =
        switch (at) {
          case Expr.Enabled step -> {
            Automaton used = used(automaton, step.used());
            yield step.action().pre().stream().anyMatch(c -> isPartial(used, c.condition()));
          }
          case Expr.Call call when !call.used().isEmpty() -> {
            Automaton used = used(automaton, call.used());
            yield used.function(call.function().name())
                .filter(f -> isPartial(used, f.body()))
                .isPresent();
          }
          default -> false;
        };
    return isPartial || Exprs.parts(at).stream().anyMatch(each -> isPartialInUsed(automaton, each));
  }

  static Automaton used(Automaton automaton, String component) {
    return Objects.requireNonNull(automaton.uses().get(component), component);
  }

  private static boolean readsParameter(Automaton automaton, Expr at) {
    return at instanceof Expr.Parameter
        || at instanceof Expr.Enabled
        || (at instanceof Expr.Call call
            && !call.used().isEmpty()
            && needsParameters(used(automaton, call.used()), call.function().name()))
        || !at.type().parameters().isEmpty()
        || (at instanceof Expr.Quantified of
            && of.variables().stream().anyMatch(v -> !v.type().parameters().isEmpty()))
        || Exprs.parts(at).stream().anyMatch(each -> readsParameter(automaton, each));
  }
}
