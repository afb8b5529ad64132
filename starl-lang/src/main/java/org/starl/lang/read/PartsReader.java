package org.starl.lang.read;

import static org.starl.lang.read.Problems.pos;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.tree.ParseTree;
import org.jspecify.annotations.Nullable;
import org.starl.lang.grammar.StarlParser;
import org.starl.lang.grammar.StarlParser.PartContext;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Action.Fairness;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.Declared;
import org.starl.lang.tree.Automaton.Invariant;
import org.starl.lang.tree.Automaton.JavaType;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Function;
import org.starl.lang.tree.Signature;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/** Reads the parts that units of several kinds have. */
class PartsReader {

  final ParserRuleContext whole;
  final SourceText source;
  final Problems problems;
  final Scope scope;
  final TypeReader types;
  final ExpressionReader expressions;

  final List<Declared> declared = new ArrayList<>();
  final Map<Type, JavaType> javaTypes = new LinkedHashMap<>();
  String javaClass = "";

  private final List<PartContext> parts;

  /**
   * @param name of the unit
   */
  PartsReader(
      ParserRuleContext unit,
      String name,
      List<PartContext> parts,
      SourceText source,
      Problems problems) {
    whole = unit;
    this.parts = parts;
    this.source = source;
    this.problems = problems;
    scope = new Scope(name);
    types = new TypeReader(scope, problems);
    expressions = new ExpressionReader(scope, problems);
  }

  final void readTypes() {
    each(StarlParser.TypePartContext.class, at -> scope.later.add(at.name.getText()));
    each(
        StarlParser.TypePartContext.class,
        at -> {
          try {
            declared.add(new Declared(types.declare(at), source.before(at)));
          } catch (Wrong told) {
            scope.wrongTypes.add(at.name.getText());
            if (at.typeBody() instanceof StarlParser.SumBodyContext sum) {
              sum.constructor().forEach(form -> scope.wrong.add(form.name.getText()));
            }
            throw told;
          }
        });
  }

  final void readJava() {
    each(
        StarlParser.JavaClassPartContext.class,
        at -> {
          if (!javaClass.isEmpty()) {
            problems.add(at, "a Java class is named twice; expected one line: java \"...\"");
          }
          javaClass = unquoted(at.STRING().getSymbol());
        });
    each(
        StarlParser.JavaTypePartContext.class,
        at -> {
          Type type = types.type(at.type());
          String first = at.first == null ? "" : unquoted(at.first);
          if (javaTypes.put(type, new JavaType(unquoted(at.of), first)) != null) {
            problems.add(at, "the Java type of " + type + " is here twice; expected one line");
          }
        });
  }

  final List<Function> functions() {
    List<Function> functions = new ArrayList<>();
    List<StarlParser.FunPartContext> parts = signatures();
    each(parts, StarlParser.FunPartContext.class, at -> functions.add(function(at)));
    requireNoCircles(parts);
    Expansion.tooLarge(functions)
        .ifPresent(each ->
            problems.add(
                each.pos(), "'" + each.signature().name() + "' stands " + Expansion.TOO_LARGE));
    return List.copyOf(functions);
  }

  final List<Invariant> invariants() {
    List<Invariant> invariants = new ArrayList<>();
    each(
        StarlParser.InvariantPartContext.class,
        at -> invariants.add(condition(at, at.name, at.expression())));
    requireUnique("invariant", StarlParser.InvariantPartContext.class, at -> at.name);
    return List.copyOf(invariants);
  }

  final List<Invariant> constraints() {
    List<Invariant> constraints = new ArrayList<>();
    each(
        StarlParser.ConstraintPartContext.class,
        at -> constraints.add(condition(at, at.name, at.expression())));
    requireUnique("constraint", StarlParser.ConstraintPartContext.class, at -> at.name);
    return List.copyOf(constraints);
  }

  final Invariant condition(
      PartContext at, StarlParser.IdContext name, StarlParser.ExpressionContext condition) {
    return new Invariant(newName(name), expressions.bool(condition), source.before(at), pos(at));
  }

  final List<Field> fields(StarlParser.@Nullable BindersContext at, boolean mayShadow) {
    return at == null ? List.of() : types.fields(at.binderGroup(), mayShadow);
  }

  final Action action(StarlParser.IdContext at, Automaton automaton) {
    return automaton
        .action(at.getText())
        .orElseThrow(() ->
            expressions.wrong(
                at,
                "'%s' is no action of %s; expected one of %s"
                    .formatted(
                        at.getText(),
                        automaton.name(),
                        automaton.actions().stream().map(Action::name).toList())));
  }

  final Fairness fairness(
      StarlParser.FairnessContext at, StarlParser.IdContext action, List<Field> parameters) {
    List<String> names = parameters.stream().map(Field::name).toList();
    List<Integer> each = new ArrayList<>();
    for (StarlParser.IdContext id : at.each) {
      int number = names.indexOf(id.getText());
      if (number >= 0) {
        each.add(number);
      } else if (!id.getText().equals("any") || at.each.size() > 1) {
        throw expressions.wrong(
            id,
            "'%s' is no parameter of '%s'; expected some of %s, or 'any'"
                .formatted(id.getText(), action.getText(), names));
      }
    }
    return new Fairness(
        at.STRONGLY() != null,
        (at.group == null ? action : at.group).getText(),
        at.each.isEmpty() ? IntStream.range(0, names.size()).boxed().toList() : List.copyOf(each));
  }

  final <P extends PartContext> void each(Class<P> kind, Consumer<P> read) {
    each(parts, kind, read);
  }

  /** Reads the parts of one kind, and goes on after an error in one. */
  final <P extends ParserRuleContext> void each(
      List<? extends ParserRuleContext> parts, Class<P> kind, Consumer<P> read) {
    for (ParserRuleContext part : parts) {
      if (kind.isInstance(part)) {
        try {
          orTold(() -> {
            read.accept(kind.cast(part));
            return true;
          });
        } catch (StackOverflowError e) {
          problems.add(part, SourceReader.TOO_DEEP);
        }
      }
    }
  }

  /** Reads a part, and goes on after an error in it. */
  @SuppressWarnings("CheckReturnValue") // what is read is kept by the reading
  final void orTold(BooleanSupplier read) {
    try {
      read.getAsBoolean();
    } catch (Wrong told) {
      if (problems.isEmpty()) {
        throw new IllegalStateException("an error that was not told", told);
      }
    }
  }

  final String newName(StarlParser.IdContext at) {
    String name = at.getText();
    scope.places.put(name, pos(at));
    scope
        .taken(name)
        .ifPresent(what ->
            problems.add(at, "'" + name + "' is " + what + " already; expected a new name"));
    return name;
  }

  /** Tells the names that are there twice. */
  final <P extends PartContext> void requireUnique(
      String what, Class<P> kind, java.util.function.Function<P, StarlParser.IdContext> of) {
    Set<String> seen = new TreeSet<>();
    each(
        kind,
        at -> {
          String name = of.apply(at).getText();
          if (!seen.add(name)) {
            problems.add(
                of.apply(at), what + " '" + name + "' is here twice; expected different names");
          }
        });
  }

  static String unquoted(Token string) {
    return string.getText().substring(1, string.getText().length() - 1);
  }

  /** Makes the functions known, so that they may call each other. */
  private List<StarlParser.FunPartContext> signatures() {
    List<StarlParser.FunPartContext> parts = new ArrayList<>();
    Set<String> reading = new TreeSet<>(scope.state.keySet());
    each(
        StarlParser.FunPartContext.class,
        at -> {
          String name = at.name.getText();
          if (scope.declaring(name, () -> mentions(at.expression(), reading))) {
            reading.add(name);
          }
          parts.add(at);
        });
    boolean grows = true;
    while (grows) {
      grows = false;
      for (StarlParser.FunPartContext at : parts) {
        if (!reading.contains(at.name.getText()) && mentions(at.expression(), reading)) {
          grows = reading.add(at.name.getText());
        }
      }
    }
    List<StarlParser.FunPartContext> good = new ArrayList<>();
    for (StarlParser.FunPartContext at : parts) {
      orTold(() -> {
        String name = newName(at.name);
        List<Field> parameters = scope.declaring(name, () -> fields(at.binders(), false));
        Type result = scope.declaring(name, () -> types.type(at.type()));
        scope.functions.put(
            name, new Signature(scope.automaton, name, parameters, result, reading.contains(name)));
        return good.add(at);
      });
    }
    return good;
  }

  /** PVS and Z3 take functions that call themselves, but not each other. */
  private void requireNoCircles(List<StarlParser.FunPartContext> parts) {
    Map<String, Set<String>> calls = new TreeMap<>();
    for (StarlParser.FunPartContext at : parts) {
      Set<String> others = calls.computeIfAbsent(at.name.getText(), any -> new TreeSet<>());
      for (StarlParser.FunPartContext other : parts) {
        if (other != at && mentions(at.expression(), Set.of(other.name.getText()))) {
          others.add(other.name.getText());
        }
      }
    }
    Set<String> told = new TreeSet<>();
    for (StarlParser.FunPartContext at : parts) {
      String name = at.name.getText();
      for (String other : calls.getOrDefault(name, Set.of())) {
        Set<String> reached = reached(other, calls, new TreeSet<>());
        if (reached.contains(name) && told.add(name)) {
          told.addAll(reached);
          problems.add(
              at,
              "'%s' calls itself through '%s'; expected a function that calls itself directly"
                  .formatted(name, other));
        }
      }
    }
  }

  private static Set<String> reached(String from, Map<String, Set<String>> calls, Set<String> all) {
    if (all.add(from)) {
      calls.getOrDefault(from, Set.of()).forEach(each -> reached(each, calls, all));
    }
    return all;
  }

  private static boolean mentions(ParseTree tree, Set<String> names) {
    if (tree instanceof StarlParser.NameContext name) {
      return names.contains(name.getText());
    }
    for (int i = 0; i < tree.getChildCount(); i++) {
      if (mentions(tree.getChild(i), names)) {
        return true;
      }
    }
    return false;
  }

  private Function function(StarlParser.FunPartContext at) {
    Signature signature = Objects.requireNonNull(scope.functions.get(at.name.getText()));
    if (at.binders() != null) {
      types.placed(at.binders().binderGroup());
    }
    scope.push(signature.parameters());
    try {
      Optional<Expr> measure =
          at.measure() == null
              ? Optional.empty()
              : Optional.of(expressions.read(at.measure().expression(), Type.Num.NAT));
      Expr body = expressions.read(at.expression(), signature.result());
      if (measure.isEmpty() && mentions(at.expression(), Set.of(signature.name()))) {
        problems.add(
            at,
            "'"
                + signature.name()
                + "' calls itself; expected 'measure' and a natural number that becomes smaller with each call");
      }
      return new Function(signature, body, measure, source.before(at), pos(at));
    } finally {
      scope.pop(signature.parameters());
    }
  }
}
