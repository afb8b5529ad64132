package org.starl.lang.pvs;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.Invariant;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Refinement;
import org.starl.lang.tree.Type.Field;

/**
 * The variables that a theory declares: those of its functions, quantifiers, sets and maps. A name that
 * has two types in the automaton is not declared; each place gives its type.
 */
final class PvsNames {

  private final Map<String, String> declared = new LinkedHashMap<>();
  private final TreeSet<String> ambiguous = new TreeSet<>();

  /** The names that each theory declares. */
  private static final Set<String> OWN =
      Set.of("s", "a", "states", "actions", "enabled", "trans", "start");

  /**
   * What theories have from PVS and from the library: a function of such a name would be taken for it.
   */
  private static final Set<String> LIBRARY =
      Set.of(
          """
          I add append bottom car card cdr difference down emptyset intersection length lift list
          list2set nonneg_real nth null reachable remove set singleton subrange union up
          """
              .split("\\s+"));

  /** Words of PVS, of any case. */
  private static final Set<String> RESERVED =
      Set.of(
          """
          all and andthen array as assuming assumption auto_rewrite axiom begin but by cases
          challenge claim closure codatatype coinductive cond conjecture containing
          conversion corecursive corollary datatype else elsif end endassuming endcases endcond
          endif endtable exists exporting fact false forall formula from function ghost
          has_type if iff implies importing in inductive judgement lambda law lemma let
          library macro measure nonempty_type not obligation of or orelse postulate
          proposition recursive sublemma subtype_of subtypes table then theorem theory
          true type var when where with xor
          """
              .split("\\s+"));

  private boolean usesDistinct;

  /** Of assumptions, which stand before the declarations. */
  static PvsNames none(List<Invariant> assumptions) {
    PvsNames names = new PvsNames();
    assumptions.forEach(each -> names.collect(each.condition()));
    names.declared.clear();
    return names;
  }

  private final List<Automaton> all = new ArrayList<>();
  private final Map<String, Automaton> uses = new LinkedHashMap<>();

  private PvsNames() {}

  PvsNames(Automaton automaton) {
    all.add(automaton);
    uses.putAll(automaton.uses());
    all.addAll(uses.values());
    automaton.refinements().forEach(each -> all.add(each.of()));
    declared.put("s", "states");
    declared.put("a", "actions");
    automaton
        .functions()
        .forEach(function -> {
          function.signature().parameters().forEach(this::add);
          collect(function.body());
        });
    automaton.start().forEach(this::collect);
    for (Action action : automaton.actions()) {
      action.pre().forEach(conjunct -> collect(conjunct.condition()));
      action.eff().forEach(effect -> effect.parts().forEach(this::collect));
    }
    automaton.invariants().forEach(invariant -> collect(invariant.condition()));
    for (Refinement each : automaton.refinements()) {
      automaton.actions().forEach(action -> action.parameters().forEach(this::add));
      each.values().values().forEach(this::collect);
      each.steps().values().stream()
          .flatMap(List::stream)
          .forEach(step -> step.parts().forEach(this::collect));
    }
    ambiguous.forEach(declared::remove);
  }

  /** The function that is called, with its theory if another one has a function of that name. */
  String function(Expr.Call call) {
    String name = call.function().name();
    boolean isOne =
        all.stream().filter(each -> each.function(name).isPresent()).distinct().count() < 2;
    return call.used().isEmpty() || isOne
        ? id(name)
        : id(Objects.requireNonNull(uses.get(call.used())).name()) + "." + id(name);
  }

  /** Whether the library's {@code distinct?} is needed. */
  boolean usesDistinct() {
    return usesDistinct;
  }

  /** A line of each type: {@code i, j: VAR PIDS}. */
  List<String> lines() {
    Map<String, List<String>> byType = new LinkedHashMap<>();
    declared.forEach(
        (name, type) -> byType.computeIfAbsent(type, any -> new ArrayList<>()).add(name));
    List<String> lines = new ArrayList<>();
    byType.forEach((type, names) -> lines.add(String.join(", ", names) + ": VAR " + type));
    return lines;
  }

  /**
   * The name that stands in a theory for one of a source: another one if PVS, or each theory, has a
   * meaning for it. Different names stay different.
   */
  static String id(String name) {
    return isOperator(name) ? name + "_" : variable(name);
  }

  /** The same of a variable, or of an argument of a form or action. */
  static String variable(String name) {
    return LIBRARY.contains(word(name)) ? name + "_" : unreserved(name);
  }

  /** The same of a component of the state or of a record: it stands for nothing else. */
  static String field(String name) {
    return isOperator(name) ? name + "_" : unreserved(name);
  }

  private static String unreserved(String name) {
    String word = word(name);
    boolean isReserved = OWN.contains(word) || RESERVED.contains(word.toLowerCase(Locale.ROOT));
    return isReserved ? name + "_" : name;
  }

  private static String word(String name) {
    return name.replaceFirst("_+$", "");
  }

  private static boolean isOperator(String name) {
    return name.matches("[oO]_*"); // in places
  }

  /** A variable where it is bound: {@code i}, or {@code i: PIDS} if the name alone says not enough. */
  String bound(Field variable) {
    String name = variable(variable.name());
    return declared.containsKey(name) ? name : name + ": " + PvsExpr.type(variable.type());
  }

  /** The variables of a quantifier or function: {@code i, j}, or {@code (i: PIDS), j}. */
  String binders(List<Field> variables) {
    List<String> all = new ArrayList<>();
    for (Field variable : variables) {
      String bound = bound(variable);
      all.add(bound.contains(":") ? "(" + bound + ")" : bound);
    }
    return String.join(", ", all);
  }

  private void add(Field variable) {
    String type = PvsExpr.type(variable.type());
    String name = variable(variable.name());
    if (!declared.computeIfAbsent(name, any -> type).equals(type)) {
      ambiguous.add(name);
    }
  }

  private void collect(Expr expr) {
    switch (expr) {
      case Expr.BuiltIn of -> usesDistinct |= of.name() == Expr.BuiltIn.Name.DISTINCT;
      case Expr.Quantified of -> of.variables().forEach(this::add);
      case Expr.MapOf of -> of.variables().forEach(this::add);
      case Expr.SuchThat of -> add(of.variable());
      default -> {
        // Binds nothing that a theory declares.
      }
    }
    parts(expr).forEach(this::collect);
  }

  /** The expressions that {@code expr} is made of. */
  private static List<Expr> parts(Expr expr) {
    return switch (expr) {
      case Expr.Bool of -> List.of();
      case Expr.Numeral of -> List.of();
      case Expr.Variable of -> List.of();
      case Expr.Parameter of -> List.of();
      case Expr.Component of -> List.of();
      case Expr.Started of -> List.of();
      case Expr.None of -> List.of();
      case Expr.At of -> and(of.arguments(), of.map());
      case Expr.Call of -> of.arguments();
      case Expr.Enabled of -> of.arguments();
      case Expr.Get of -> List.of(of.of());
      case Expr.Make of -> of.arguments();
      case Expr.MakeRecord of -> of.values();
      case Expr.Is of -> List.of(of.of());
      case Expr.Match of -> and(of.cases().stream().map(Expr.Case::value).toList(), of.of());
      case Expr.Not of -> List.of(of.of());
      case Expr.Negative of -> List.of(of.of());
      case Expr.Binary of -> List.of(of.left(), of.right());
      case Expr.Quantified of -> List.of(of.body());
      case Expr.If of -> List.of(of.condition(), of.then(), of.otherwise());
      case Expr.SuchThat of -> List.of(of.body());
      case Expr.SetOf of -> of.elements();
      case Expr.MapOf of -> List.of(of.body());
      case Expr.ListOf of -> of.elements();
      case Expr.Some of -> List.of(of.of());
      case Expr.BuiltIn of -> List.of(of.of());
    };
  }

  private static List<Expr> and(List<Expr> some, Expr one) {
    List<Expr> all = new ArrayList<>(some);
    all.add(one);
    return all;
  }

  /** The functions that {@code expr} calls. */
  static List<Expr.Call> calls(Expr expr) {
    List<Expr.Call> calls = new ArrayList<>();
    if (expr instanceof Expr.Call call) {
      calls.add(call);
    }
    parts(expr).forEach(part -> calls.addAll(calls(part)));
    return calls;
  }
}
