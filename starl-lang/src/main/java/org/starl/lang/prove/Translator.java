// Longer than 500 lines because each kind of expression has one method here, and these call each
// other.
package org.starl.lang.prove;

import static org.starl.lang.prove.Val.smt;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.lang.prove.Smt.Binding;
import org.starl.lang.prove.Val.Fn;
import org.starl.lang.prove.Val.Term;
import org.starl.lang.tree.Action.Conjunct;
import org.starl.lang.tree.Bound;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Expr.Binary;
import org.starl.lang.tree.Expr.Operator;
import org.starl.lang.tree.Function;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Signature;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Constructor;
import org.starl.lang.tree.Type.Field;
import org.starl.lang.tree.Type.Num;

/**
 * Expressions as SMT-LIB. Sets and maps are worked out as far as their values at arguments go, so that the solver
 * sees elements alone; they become arrays only inside other values. Functions are written out, recursive ones defined.
 *
 * <p>More than 500 lines: one short case for each kind of expression, which all share the symbols.
 */
final class Translator {

  /**
   * A call of a recursive function.
   *
   * @param path the conditions under which it is reached
   * @param binders the variables that are bound around it
   */
  record RecursiveCall(
      String name, List<Val> arguments, List<String> path, List<Binding> binders) {}

  private final Sorts sorts;
  private final Script script;
  private final Map<String, String> names = new LinkedHashMap<>();
  private final Map<String, String> texts = new LinkedHashMap<>();
  private final List<Unfolded> unfolded = new ArrayList<>();
  private final List<RecursiveCall> calls = new ArrayList<>();
  private @Nullable List<Obligation> obligations;
  private List<String> path = new ArrayList<>();
  private List<Binding> binders = new ArrayList<>();
  private int bound;
  private int definitions; // of recursive functions, which no assertion before them may name
  private boolean isApproximate;

  Translator(Sorts sorts, Script script) {
    this.sorts = sorts;
    this.script = script;
  }

  Sorts sorts() {
    return sorts;
  }

  // --- symbols -----------------------------------------------------------------------------------

  /** The sorts of all arguments of a map whose values may be maps. */
  List<String> argumentSorts(Type type) {
    List<String> all = new ArrayList<>();
    Type at = type;
    while (Sorts.isMap(at)) {
      Sorts.map(at).arguments().forEach(argument -> all.add(sorts.sort(argument)));
      at = Sorts.map(at).result();
    }
    return all;
  }

  /** The sort of its values that are no maps. */
  String resultSort(Type type) {
    return Sorts.isMap(type) ? resultSort(Sorts.map(type).result()) : sorts.sort(type);
  }

  /** A new symbol, any value of its type. */
  Val declare(String name, Type type) {
    script.declare(name, argumentSorts(type), resultSort(type));
    Val value = symbol(name, List.of(), type);
    script.require(inside(type, value));
    if (type.base() == Num.NAT && sorts.hasFewNumbers()) {
      script.require(Smt.call("<=", smt(value), String.valueOf(Sorts.MOST_NUMBER)));
    }
    return value;
  }

  /** A symbol that stands for {@code value}. */
  Val define(String name, Type type, Val value) {
    List<Binding> parameters = new ArrayList<>();
    for (String sort : argumentSorts(type)) {
      parameters.add(new Binding("x" + parameters.size(), sort));
    }
    binders.addAll(parameters);
    String text = applied(value, type, Binding.names(parameters));
    binders.subList(binders.size() - parameters.size(), binders.size()).clear();
    script.line(
        "(define-fun %s %s %s %s)"
            .formatted(name, Binding.text(parameters), resultSort(type), text));
    return symbol(name, List.of(), type);
  }

  /** The value at all arguments. */
  private static String applied(Val value, Type type, List<String> names) {
    if (!Sorts.isMap(type)) {
      return smt(value);
    }
    Type.MapOf map = Sorts.map(type);
    int here = map.arguments().size();
    return applied(
        ((Fn) value).at().apply(names.subList(0, here)),
        map.result(),
        names.subList(here, names.size()));
  }

  private static Val symbol(String name, List<String> arguments, Type type) {
    if (!Sorts.isMap(type)) {
      return new Term(Smt.call(name, arguments));
    }
    Type.MapOf map = Sorts.map(type);
    return new Fn(
        map,
        more -> {
          List<String> all = new ArrayList<>(arguments);
          all.addAll(more);
          return symbol(name, all, map.result());
        },
        null);
  }

  /** What a term means: an array is a map. */
  Val of(String term, Type type) {
    if (!Sorts.isMap(type)) {
      return new Term(term);
    }
    Type.MapOf map = Sorts.map(type);
    return new Fn(
        map,
        arguments -> {
          List<String> all = new ArrayList<>(List.of(term));
          all.addAll(arguments);
          return of(Smt.call("select", all), map.result());
        },
        term);
  }

  /** The text of a value; a map becomes an array. */
  String term(Val value, Type type) {
    if (!(value instanceof Fn map)) {
      return smt(value);
    }
    if (map.array() != null) {
      return map.array();
    }
    Type.MapOf of = Sorts.map(type);
    List<String> all =
        of.arguments().size() == 1 ? sorts.elements(of.arguments().getFirst()) : List.of();
    if (!all.isEmpty()) {
      // A value for the elements beyond all: one that is not a term, since Z3 has an error there.
      List<String> results = sorts.elements(of.result());
      boolean hasValue = !results.isEmpty();
      String rest =
          hasValue
              ? results.getFirst()
              : term(map.at().apply(List.of(all.getFirst())), of.result());
      String array = "((as const " + sorts.sort(of) + ") " + rest + ")";
      for (String element : all.subList(hasValue ? 0 : 1, all.size())) {
        array =
            Smt.call("store", array, element, term(map.at().apply(List.of(element)), of.result()));
      }
      return array;
    }
    List<Binding> bindings = new ArrayList<>();
    for (Type argument : of.arguments()) {
      bindings.add(new Binding("x$" + bound++, sorts.sort(argument)));
    }
    binders.addAll(bindings);
    String body = term(map.at().apply(Binding.names(bindings)), of.result());
    binders.subList(binders.size() - bindings.size(), binders.size()).clear();
    return Smt.call("lambda", Binding.text(bindings), body);
  }

  /** That a value is one of its type: what the sorts do not say. */
  String inside(Type type, Val value) {
    return switch (type.base()) {
      case Num number ->
          number.hasNegative()
              ? Smt.TRUE
              : Smt.call(">=", smt(value), number == Num.NAT ? "0" : "0.0");
      case Type.Range range -> {
        String low = bound(range.low());
        String high = bound(range.high());
        yield Smt.and(List.of(Smt.call("<=", low, smt(value)), Smt.call("<=", smt(value), high)));
      }
      case Type.SetOf set -> Smt.TRUE;
      case Type.MapOf map ->
          each(
              map.arguments(),
              arguments -> inside(map.result(), ((Fn) value).at().apply(arguments)));
      case Type.Rec rec ->
          Smt.and(
              rec.fields().stream()
                  .map(f ->
                      inside(f.type(), of(Smt.call(sorts.field(rec, f), smt(value)), f.type())))
                  .toList());
      case Type.Sum sum -> {
        List<String> all = new ArrayList<>();
        for (Constructor form : sum.constructors()) {
          for (Field f : form.fields()) {
            String field = Smt.call(sorts.field(sum, form, f), smt(value));
            all.add(Smt.implies(is(sum, form, smt(value)), inside(f.type(), of(field, f.type()))));
          }
        }
        yield Smt.and(all);
      }
      case Type.OptionOf option ->
          Smt.implies(
              sorts.someTest(option, smt(value)),
              inside(option.element(), of(Smt.call("the", smt(value)), option.element())));
      case Type.ListOf list -> {
        String n = "n$" + bound++;
        String element = Smt.call("seq.nth", smt(value), n);
        String inside = inside(list.element(), of(element, list.element()));
        if (inside.equals(Smt.TRUE)) {
          yield Smt.TRUE;
        }
        if (!sorts.hasSequences()) {
          throw new Unprovable(
              "the type " + list + ": lists of numbers are not translated without '++' or length");
        }
        String within = "(and (<= 0 " + n + ") (< " + n + " " + length(smt(value)) + "))";
        yield Smt.quantified(true, List.of(new Binding(n, "Int")), Smt.implies(within, inside));
      }
      default -> Smt.TRUE;
    };
  }

  private static String bound(Bound of) {
    List<String> sum = new ArrayList<>();
    of.times()
        .forEach(
            (name, n) -> sum.add(n == 1 ? "p." + name : Smt.call("*", number(n), "p." + name)));
    if (of.plus() != 0 || sum.isEmpty()) {
      sum.add(number(of.plus()));
    }
    return sum.size() == 1 ? sum.getFirst() : Smt.call("+", sum);
  }

  private static String number(long of) {
    return Smt.number(BigDecimal.valueOf(of), false);
  }

  private String is(Type.Sum sum, Constructor form, String value) {
    return "((_ is " + sorts.form(sum, form) + ") " + value + ")";
  }

  // --- quantifiers -------------------------------------------------------------------------------

  /** That {@code body} holds at all arguments of these types. */
  private String each(List<Type> types, java.util.function.Function<List<String>, String> body) {
    List<Field> variables = new ArrayList<>();
    for (int i = 0; i < types.size(); i++) {
      variables.add(new Field(String.valueOf(i), types.get(i)));
    }
    return quantified(
        true,
        variables,
        values -> {
          List<String> terms = new ArrayList<>();
          for (int i = 0; i < types.size(); i++) {
            terms.add(term(values.get(i), types.get(i)));
          }
          return body.apply(terms);
        });
  }

  /** Few values are written out, others are left to the solver. */
  String quantified(
      boolean forAll, List<Field> variables, java.util.function.Function<List<Val>, String> body) {
    return quantified(forAll, variables, new ArrayList<>(), new ArrayList<>(), body);
  }

  private String quantified(
      boolean forAll,
      List<Field> variables,
      List<Val> before,
      List<Binding> open,
      java.util.function.Function<List<Val>, String> body) {
    if (before.size() == variables.size()) {
      return closed(forAll, variables, before, open, body);
    }
    Field variable = variables.get(before.size());
    List<String> all = sorts.elements(variable.type());
    List<String> parts = new ArrayList<>();
    List<Binding> stillOpen = new ArrayList<>(open);
    if (all.isEmpty()) {
      all = List.of((variable.name().matches("[0-9]+") ? "x" : variable.name()) + "$" + bound++);
      stillOpen.add(new Binding(all.getFirst(), sorts.sort(variable.type())));
    }
    for (String element : all) {
      List<Val> values = new ArrayList<>(before);
      values.add(of(element, variable.type()));
      parts.add(quantified(forAll, variables, values, stillOpen, body));
    }
    return forAll ? Smt.and(parts) : Smt.or(parts);
  }

  private String closed(
      boolean forAll,
      List<Field> variables,
      List<Val> values,
      List<Binding> open,
      java.util.function.Function<List<Val>, String> body) {
    String guard = inside(variables, values);
    binders.addAll(open);
    String inner = under(guard, () -> body.apply(values));
    binders.subList(binders.size() - open.size(), binders.size()).clear();
    if (!forAll) {
      return Smt.quantified(false, open, Smt.and(List.of(guard, inner)));
    }
    return Smt.quantified(true, open, Smt.implies(guard, inner));
  }

  /** That each value is one of its type. */
  String inside(List<Field> variables, List<Val> values) {
    List<String> all = new ArrayList<>();
    for (int i = 0; i < variables.size(); i++) {
      all.add(inside(variables.get(i).type(), values.get(i)));
    }
    return Smt.and(all);
  }

  // --- obligations -------------------------------------------------------------------------------

  /** What must hold so that what {@code work} translates has values. */
  List<Obligation> obligations(Runnable work) {
    List<Obligation> all = new ArrayList<>();
    obligations = all;
    work.run();
    obligations = null;
    return all;
  }

  /** Where this is reached, {@code condition} must hold. */
  void oblige(String condition, String otherwise, Pos pos) {
    if (obligations != null && !condition.equals(Smt.TRUE)) {
      String reached = Smt.implies(Smt.and(path), condition);
      obligations.add(
          new Obligation(
              Smt.quantified(true, binders, reached), new Obligation.Place(otherwise, pos)));
    }
  }

  /** Work whose obligations are known, or are those of another place. */
  private <T> T withoutObligations(Supplier<T> work) {
    List<Obligation> before = obligations;
    obligations = null;
    T result = work.get();
    obligations = before;
    return result;
  }

  /** All conditions, each where those before it hold. */
  String all(List<Expr> conditions, Scope scope) {
    List<String> texts = new ArrayList<>();
    for (Expr each : conditions) {
      texts.add(bool(each, scope));
      path.add(texts.getLast());
    }
    path.subList(path.size() - texts.size(), path.size()).clear();
    return Smt.and(texts);
  }

  /** What is worked out where {@code condition} holds. */
  <T> T under(String condition, Supplier<T> work) {
    path.add(condition);
    T result = work.get();
    path.removeLast();
    return result;
  }

  private static Scope bind(Scope scope, List<Field> variables, List<Val> values) {
    Scope inner = scope;
    for (int i = 0; i < variables.size(); i++) {
      inner = inner.with(variables.get(i).name(), values.get(i));
    }
    return inner;
  }

  // --- expressions -------------------------------------------------------------------------------

  /** The text of an expression of type {@code bool}. */
  String bool(Expr expr, Scope scope) {
    return smt(value(expr, scope));
  }

  /** The value of an expression as one of {@code wanted}: a natural number may be wanted as a real one. */
  Val as(Type wanted, Expr expr, Scope scope) {
    Val value = value(expr, scope);
    boolean widens =
        Type.isNumber(wanted, number -> !number.isWhole())
            && Type.isNumber(expr.type(), Num::isWhole);
    return widens ? new Term(Smt.call("to_real", smt(value))) : value;
  }

  private String termAs(Type wanted, Expr expr, Scope scope) {
    return term(as(wanted, expr, scope), wanted);
  }

  Val value(Expr expr, Scope scope) {
    return switch (expr) {
      case Expr.Bool bool -> new Term(String.valueOf(bool.value()));
      case Expr.Numeral number ->
          new Term(Smt.number(number.value(), number.type().base() != Num.NAT));
      case Expr.Variable variable -> scope.variable(variable.name());
      case Expr.Parameter parameter -> symbol("p." + parameter.name(), List.of(), parameter.type());
      case Expr.Component component -> scope.cell(component.name());
      case Expr.At at -> {
        List<Type> types = Sorts.map(at.map().type()).arguments();
        List<String> arguments = new ArrayList<>();
        for (int i = 0; i < types.size(); i++) {
          arguments.add(termAs(types.get(i), at.arguments().get(i), scope));
        }
        yield ((Fn) value(at.map(), scope)).at().apply(arguments);
      }
      case Expr.Call call -> call(call, scope);
      case Expr.Enabled enabled -> {
        Scope used =
            scope
                .used(enabled.used())
                .only(
                    enabled.action().parameters(),
                    arguments(enabled.action().parameters(), enabled.arguments(), scope));
        yield new Term(
            all(enabled.action().pre().stream().map(Conjunct::condition).toList(), used));
      }
      case Expr.Started started -> {
        Scope used = scope.used(started.used());
        yield new Term(all(started.automaton().start(), used));
      }
      case Expr.Get get -> get(get, scope);
      case Expr.Make make -> {
        Type.Sum sum = (Type.Sum) make.type().base();
        yield new Term(
            Smt.call(
                sorts.form(sum, make.constructor()),
                terms(make.constructor().fields(), make.arguments(), scope)));
      }
      case Expr.MakeRecord made -> {
        Type.Rec rec = (Type.Rec) made.type().base();
        yield new Term(
            Smt.call("mk." + sorts.sort(rec), terms(rec.fields(), made.values(), scope)));
      }
      case Expr.Is is ->
          new Term(
              is((Type.Sum) is.of().type().base(), is.constructor(), smt(value(is.of(), scope))));
      case Expr.Match match -> match(match, scope);
      case Expr.Not not -> new Term(Smt.not(bool(not.of(), scope)));
      case Expr.Negative negative ->
          new Term(Smt.call("-", smt(as(negative.type(), negative.of(), scope))));
      case Binary binary -> binary(binary, scope);
      case Expr.Quantified quantified ->
          new Term(
              quantified(
                  quantified.forAll(),
                  quantified.variables(),
                  values -> bool(quantified.body(), bind(scope, quantified.variables(), values))));
      case Expr.If choice -> {
        String condition = bool(choice.condition(), scope);
        yield ite(
            condition,
            under(condition, () -> as(choice.type(), choice.then(), scope)),
            under(Smt.not(condition), () -> as(choice.type(), choice.otherwise(), scope)));
      }
      case Expr.SuchThat set -> {
        List<Field> variables = List.of(set.variable());
        yield fn(
            Sorts.map(set.type()),
            values -> new Term(bool(set.body(), bind(scope, variables, values))));
      }
      case Expr.MapOf map -> {
        Type.MapOf type = Sorts.map(map.type());
        yield fn(
            type, values -> as(type.result(), map.body(), bind(scope, map.variables(), values)));
      }
      case Expr.SetOf set -> {
        Type element = Sorts.map(set.type()).arguments().getFirst();
        List<String> all =
            set.elements().stream().map(each -> termAs(element, each, scope)).toList();
        yield new Fn(
            Sorts.map(set.type()),
            x -> new Term(Smt.or(all.stream().map(e -> Smt.equal(x.getFirst(), e)).toList())),
            null);
      }
      case Expr.ListOf list -> {
        Type element = ((Type.ListOf) list.type().base()).element();
        String all = sorts.emptyList(list.type());
        for (Expr each : list.elements().reversed()) {
          all = sorts.cons(termAs(element, each, scope), all);
        }
        yield new Term(all);
      }
      case Expr.None none -> new Term("(as none " + sorts.sort(none.type()) + ")");
      case Expr.Some some -> {
        Type element = ((Type.OptionOf) some.type().base()).element();
        yield new Term(sorts.some(some.type(), termAs(element, some.of(), scope)));
      }
      case Expr.BuiltIn builtIn when builtIn.name() == Expr.BuiltIn.Name.CARD ->
          card(builtIn, (Fn) value(builtIn.of(), scope));
      case Expr.BuiltIn builtIn when builtIn.name() == Expr.BuiltIn.Name.CHOOSE ->
          choose(builtIn, (Fn) value(builtIn.of(), scope));
      case Expr.BuiltIn builtIn -> {
        String of = smt(value(builtIn.of(), scope));
        switch (builtIn.name()) {
          case THE ->
              oblige(
                  sorts.someTest((Type.OptionOf) builtIn.of().type().base(), of),
                  "has no value: the(none)",
                  builtIn.pos());
          case HEAD, TAIL ->
              oblige(
                  sorts.notEmpty((Type.ListOf) builtIn.of().type().base(), of),
                  "has no value: %s([])"
                      .formatted(builtIn.name() == Expr.BuiltIn.Name.HEAD ? "head" : "tail"),
                  builtIn.pos());
          case WITHIN ->
              oblige(inside(builtIn.type(), new Term(of)), outside(builtIn), builtIn.pos());
          case LENGTH, CARD, ELEMENTS, DISTINCT, CHOOSE -> {
            // These have values for all lists, or are translated above.
          }
        }
        yield builtIn(builtIn, of);
      }
    };
  }

  /** A range is empty if its first number is not in it. */
  private static String outside(Expr.BuiltIn within) {
    Type.Range range = (Type.Range) within.type().base();
    return within.of().equals(range.low().expr(within.pos()))
        ? "has an empty range, " + range
        : "makes a number that is not in " + range;
  }

  private String texts(
      List<String> terms, Type.MapOf type, java.util.function.Function<List<Val>, Val> body) {
    List<Val> values = new ArrayList<>();
    for (int i = 0; i < terms.size(); i++) {
      values.add(of(terms.get(i), type.arguments().get(i)));
    }
    Objects.requireNonNull(body.apply(values));
    return Smt.TRUE;
  }

  /** A map whose values are worked out later, where its text stands now. */
  private Fn fn(Type.MapOf type, java.util.function.Function<List<Val>, Val> body) {
    if (obligations != null) { // of all arguments
      each(type.arguments(), terms -> texts(terms, type, body));
    }
    List<String> pathHere = List.copyOf(path);
    List<Binding> bindersHere = List.copyOf(binders);
    return new Fn(
        type,
        arguments -> {
          List<Val> values = new ArrayList<>();
          for (int i = 0; i < arguments.size(); i++) {
            values.add(of(arguments.get(i), type.arguments().get(i)));
          }
          List<String> pathThere = path;
          List<Binding> bindersThere = binders;
          path = new ArrayList<>(pathHere);
          binders = new ArrayList<>(bindersThere);
          binders.addAll(bindersHere);
          Val result = withoutObligations(() -> body.apply(values));
          path = pathThere;
          binders = bindersThere;
          return result;
        },
        null);
  }

  List<Val> arguments(List<Field> parameters, List<Expr> given, Scope scope) {
    List<Val> all = new ArrayList<>();
    for (int i = 0; i < given.size(); i++) {
      all.add(as(parameters.get(i).type(), given.get(i), scope));
    }
    return all;
  }

  private List<String> terms(List<Field> fields, List<Expr> given, Scope scope) {
    return terms(fields, arguments(fields, given, scope));
  }

  List<String> terms(List<Field> fields, List<Val> values) {
    List<String> all = new ArrayList<>();
    for (int i = 0; i < values.size(); i++) {
      all.add(term(values.get(i), fields.get(i).type()));
    }
    return all;
  }

  private Val builtIn(Expr.BuiltIn builtIn, String of) {
    return switch (builtIn.name()) {
      case THE -> of(Smt.call("the", of), builtIn.type());
      case HEAD -> of(sorts.head(of), builtIn.type());
      case WITHIN -> new Term(of);
      case TAIL -> new Term(sorts.tail(of));
      case LENGTH -> new Term(length(of));
      case CARD, CHOOSE -> throw new IllegalStateException(of);
      case ELEMENTS ->
          new Fn(
              Sorts.map(builtIn.type()),
              x ->
                  new Term(
                      sorts.hasSequences()
                          ? Smt.call("seq.contains", of, Smt.call("seq.unit", x.getFirst()))
                          : Smt.call(elements(builtIn.of()), of, x.getFirst())),
              null);
      case DISTINCT ->
          new Term(sorts.hasSequences() ? distinctNth(of) : Smt.call(distinct(builtIn.of()), of));
    };
  }

  /** The function whether a list has an element. Z3 unfolds calls below {@code ite} as needed, others always. */
  private String elements(Expr list) {
    Type.ListOf type = (Type.ListOf) list.type().base();
    String sort = sorts.sort(type.element());
    String name = named("has.", sort);
    if (names.putIfAbsent(name, name) == null) {
      script.line(
          "(define-fun-rec %s ((l (list %s)) (x %s)) Bool".formatted(name, sort, sort)
              + " (ite %s (ite (= x (head l)) true (%s (tail l) x)) false))"
                  .formatted(sorts.consTest(type, "l"), name));
    }
    return name;
  }

  /** The function whether no element of a list is in it twice. */
  private String distinct(Expr list) {
    String has = elements(list);
    String name = "distinct" + has.substring("has".length());
    if (names.putIfAbsent(name, name) == null) {
      script.line(
          "(define-fun-rec %s ((l %s)) Bool".formatted(name, sorts.sort(list.type()))
              + " (ite %s (ite (%s (tail l) (head l)) false (%s (tail l))) true))"
                  .formatted(sorts.consTest((Type.ListOf) list.type().base(), "l"), has, name));
    }
    return name;
  }

  /** Whether a symbol stands for what is known in part alone: then Z3's examples are none. */
  boolean isApproximate() {
    return isApproximate;
  }

  /** Of few elements, a sum; else a number that is 0 for the empty set alone, and the same for equal sets. */
  private Term card(Expr.BuiltIn at, Fn set) {
    Type.MapOf map = set.type();
    Type element = map.arguments().getFirst();
    List<String> all = sorts.elements(element);
    if (!all.isEmpty()) {
      Fn proper = proper(set);
      List<String> ones = new ArrayList<>(List.of("0"));
      all.forEach(each -> ones.add(Smt.ite(smt(proper.at().apply(List.of(each))), "1", "0")));
      return new Term(Smt.call("+", ones));
    }
    isApproximate = true;
    if (!element.isFinite()) {
      oblige(Smt.FALSE, "has no value: card of an infinite set", at.pos());
    }
    String sort = sorts.sort(map);
    String name = named("card.", sort);
    if (names.putIfAbsent(name, name) == null) {
      script.declare(name, List.of(sort), "Int");
    }
    String number = Smt.call(name, term(set, map));
    String isEmpty = each(map.arguments(), x -> Smt.not(smt(set.at().apply(x))));
    return new Term(Smt.ite(isEmpty, "0", Smt.ite("(>= " + number + " 1)", number, "1")));
  }

  /** Any element of the set, but the same of equal ones. */
  private Val choose(Expr.BuiltIn at, Fn of) {
    Fn set = proper(of);
    Type element = at.type();
    oblige(some(set), "has no value: nothing satisfies the condition of 'choose'", at.pos());
    String sort = sorts.sort(set.type());
    String name = named("choose.", sort);
    if (names.putIfAbsent(name, name) == null) {
      script.declare(name, List.of(sort), sorts.sort(element));
    }
    if (definitions > 0) {
      requireChoice(name, sort, set.type());
      return of(Smt.call(name, term(set, set.type())), element);
    }
    List<Binding> around = binders.stream().distinct().toList();
    String array = array(set, sort, around);
    Val chosen = of(Smt.call(name, array), element);
    script.require(Smt.quantified(true, around, membership(chosen, set)));
    return chosen;
  }

  /** That an element of each set is chosen: where a set cannot be named. Z3 decides little with it. */
  private void requireChoice(String name, String sort, Type.MapOf type) {
    if (names.putIfAbsent(name + ".any", name) == null) {
      Fn any = proper((Fn) of("S", type));
      String chosen = Smt.call(name, "S");
      String isIn = membership(of(chosen, type.arguments().getFirst()), any);
      script.require("(forall ((S %s)) (! %s :pattern (%s)))".formatted(sort, isIn, chosen));
    }
  }

  /** An array that is the set: a new symbol, as Z3 decides little with those that it has no name for. */
  private String array(Fn set, String sort, List<Binding> around) {
    Type element = set.type().arguments().getFirst();
    if (!sorts.elements(element).isEmpty()) {
      return term(set, set.type());
    }
    String name = "set$" + bound++;
    script.declare(name, around.stream().map(Binding::sort).toList(), sort);
    String array = Smt.call(name, Binding.names(around));
    String x = "x$" + bound++;
    List<Binding> all = with(around, new Binding(x, sorts.sort(element)));
    String isIn = smt(set.at().apply(List.of(x)));
    script.require(Smt.quantified(true, all, Smt.equal(Smt.call("select", array, x), isIn)));
    return array;
  }

  /** The set as an array that equal sets have, too: without what is no value of the type. */
  private Fn proper(Fn set) {
    Type element = set.type().arguments().getFirst();
    return new Fn(
        set.type(),
        x -> {
          String isInside = inside(element, of(x.getFirst(), element));
          return new Term(Smt.and(List.of(isInside, smt(set.at().apply(x)))));
        },
        null);
  }

  private String some(Fn set) {
    Type element = set.type().arguments().getFirst();
    return quantified(
        false,
        List.of(new Field("x", element)),
        x -> smt(set.at().apply(List.of(term(x.getFirst(), element)))));
  }

  /** That the element is in the set, if any is. */
  private String membership(Val element, Fn set) {
    Type type = set.type().arguments().getFirst();
    return Smt.implies(some(set), smt(set.at().apply(List.of(term(element, type)))));
  }

  /** A function's name for arguments of a sort. */
  private static String named(String function, String sort) {
    return function + sort.replaceAll("[^A-Za-z0-9._]+", ".");
  }

  private static String length(String list) {
    return Smt.call("seq.len", list);
  }

  /** That no element of a sequence is in it twice. */
  private String distinctNth(String list) {
    String i = "n$" + bound++;
    String j = "n$" + bound++;
    String within = "(and (<= 0 %1$s) (< %1$s %2$s) (< %2$s %3$s))".formatted(i, j, length(list));
    String equal = Smt.equal(Smt.call("seq.nth", list, i), Smt.call("seq.nth", list, j));
    List<Binding> both = List.of(new Binding(i, "Int"), new Binding(j, "Int"));
    return Smt.quantified(true, both, Smt.implies(within, Smt.not(equal)));
  }

  private Val get(Expr.Get get, Scope scope) {
    return switch (get.of().type().base()) {
      case Type.StateOf state ->
          Objects.requireNonNull(((Val.Cells) value(get.of(), scope)).cells().get(get.field()));
      case Type.Rec rec ->
          field(rec, rec.field(get.field()).orElseThrow(), smt(value(get.of(), scope)));
      case Type.Sum sum -> {
        String of = smt(value(get.of(), scope));
        Val value = null;
        List<String> forms = new ArrayList<>();
        for (Constructor form : sum.constructors()) {
          for (Field f : form.fields()) {
            if (f.name().equals(get.field())) {
              forms.add(is(sum, form, of));
              Val one = of(Smt.call(sorts.field(sum, form, f), of), f.type());
              value = value == null ? one : ite(is(sum, form, of), one, value);
            }
          }
        }
        if (forms.size() < sum.constructors().size()) {
          String otherwise = "has no value: '" + get.field() + "' of a form without such a field";
          oblige(Smt.or(forms), otherwise, get.pos());
        }
        yield Objects.requireNonNull(value);
      }
      default -> throw new IllegalStateException(get.toString());
    };
  }

  Val field(Type.Rec rec, Field field, String of) {
    return of(Smt.call(sorts.field(rec, field), of), field.type());
  }

  private Val match(Expr.Match match, Scope scope) {
    Type.Sum sum = (Type.Sum) match.of().type().base();
    String of = smt(value(match.of(), scope));
    Val value = null;
    for (Expr.Case each : match.cases().reversed()) {
      Scope inner = scope;
      for (int i = 0; i < each.variables().size(); i++) {
        Field field = each.constructor().fields().get(i);
        inner =
            inner.with(
                each.variables().get(i).name(),
                of(Smt.call(sorts.field(sum, each.constructor(), field), of), field.type()));
      }
      Scope within = inner;
      String is = is(sum, each.constructor(), of);
      Val one = under(is, () -> as(match.type(), each.value(), within));
      value = value == null ? one : ite(is, one, value);
    }
    return Objects.requireNonNull(value);
  }

  Val ite(String condition, Val then, Val otherwise) {
    if (then instanceof Fn a && otherwise instanceof Fn b) {
      return new Fn(a.type(), x -> ite(condition, a.at().apply(x), b.at().apply(x)), null);
    }
    return new Term(Smt.ite(condition, smt(then), smt(otherwise)));
  }

  private Val binary(Binary binary, Scope scope) {
    Expr left = binary.left();
    Expr right = binary.right();
    Operator operator = binary.operator();
    return switch (operator) {
      case AND, OR, IMPLIES -> {
        String first = bool(left, scope);
        String reached = operator == Operator.OR ? Smt.not(first) : first;
        String second = under(reached, () -> bool(right, scope));
        yield new Term(
            operator == Operator.AND
                ? Smt.and(List.of(first, second))
                : operator == Operator.OR
                    ? Smt.or(List.of(first, second))
                    : Smt.implies(first, second));
      }
      case IFF -> new Term(Smt.equal(bool(left, scope), bool(right, scope)));
      case EQUAL, UNEQUAL -> {
        Type wider = Type.wider(left.type(), right.type());
        String equal = equal(wider, as(wider, left, scope), as(wider, right, scope));
        yield new Term(operator == Operator.EQUAL ? equal : Smt.not(equal));
      }
      case LESS, AT_MOST, GREATER, AT_LEAST, PLUS, LESS_BY, TIMES -> {
        Type wider = Type.wider(left.type(), right.type());
        String a = termAs(wider, left, scope);
        String b = termAs(wider, right, scope);
        if (operator == Operator.LESS_BY && !Type.isNumber(binary.type(), Num::hasNegative)) {
          oblige(Smt.call(">=", a, b), "makes a number negative", binary.pos());
        }
        yield new Term(Smt.call(operator.text(), a, b));
      }
      case DIVIDED_BY -> {
        String by = smt(as(Num.REAL, right, scope));
        oblige(Smt.not(Smt.equal(by, "0.0")), "has no value: a division by 0", binary.pos());
        yield new Term(Smt.call("/", smt(as(Num.REAL, left, scope)), by));
      }
      case MOD -> {
        String by = smt(value(right, scope));
        oblige(Smt.call(">", by, "0"), "has no value: a remainder by 0 or less", binary.pos());
        yield new Term(Smt.call("mod", smt(value(left, scope)), by));
      }
      case IN -> {
        Type element = Sorts.map(right.type()).arguments().getFirst();
        yield ((Fn) value(right, scope)).at().apply(List.of(termAs(element, left, scope)));
      }
      case SUBSET -> new Term(pointwise(binary, scope, Smt::implies));
      case DISJOINT ->
          new Term(pointwise(binary, scope, (a, b) -> Smt.not(Smt.and(List.of(a, b)))));
      case UNION -> combined(binary, scope, (a, b) -> Smt.or(List.of(a, b)));
      case MINUS -> combined(binary, scope, (a, b) -> Smt.and(List.of(a, Smt.not(b))));
      case INTERSECT -> combined(binary, scope, (a, b) -> Smt.and(List.of(a, b)));
      case JOIN -> new Term(Smt.call("seq.++", smt(value(left, scope)), smt(value(right, scope))));
      case NTH -> {
        String list = smt(value(left, scope));
        String n = smt(value(right, scope));
        String within = Smt.and(List.of("(<= 0 " + n + ")", Smt.call("<", n, length(list))));
        oblige(within, "has no value: no such element", binary.pos());
        yield of(Smt.call("seq.nth", list, n), binary.type());
      }
    };
  }

  private String pointwise(Binary binary, Scope scope, BiFunction<String, String, String> of) {
    Fn both = combined(binary, scope, of);
    return each(both.type().arguments(), x -> smt(both.at().apply(x)));
  }

  private Fn combined(Binary binary, Scope scope, BiFunction<String, String, String> of) {
    Fn left = (Fn) value(binary.left(), scope);
    Fn right = (Fn) value(binary.right(), scope);
    return new Fn(
        left.type(),
        x -> new Term(of.apply(smt(left.at().apply(x)), smt(right.at().apply(x)))),
        null);
  }

  /** That two values of a type are equal. */
  String equal(Type type, Val a, Val b) {
    if (!(a instanceof Fn left) || !(b instanceof Fn right)) {
      return Smt.equal(smt(a), smt(b));
    }
    if (left.array() != null && right.array() != null && !sorts.hasNumericDomain(type)) {
      return Smt.equal(left.array(), right.array());
    }
    Type.MapOf map = Sorts.map(type);
    return each(map.arguments(), x -> equal(map.result(), left.at().apply(x), right.at().apply(x)));
  }

  // --- functions ---------------------------------------------------------------------------------

  private Val call(Expr.Call call, Scope scope) {
    Signature signature = call.function();
    Scope owner = call.used().isEmpty() ? scope : scope.used(call.used());
    var function = owner.automaton().function(signature.name()).orElseThrow();
    List<Val> arguments = arguments(signature.parameters(), call.arguments(), scope);
    if (function.measure().isEmpty()) {
      Scope inner = owner.only(signature.parameters(), arguments);
      return as(signature.result(), function.body(), inner);
    }
    String name = define(function, owner);
    calls.add(new RecursiveCall(name, arguments, List.copyOf(path), List.copyOf(binders)));
    return symbol(name, terms(signature.parameters(), arguments), signature.result());
  }

  /** Defines a recursive function over the state of {@code scope}, if it is not yet; returns its name. */
  String define(Function function, Scope scope) {
    String name = recursiveName(function, scope);
    String known = names.get(name);
    if (known != null) {
      return known;
    }
    names.put(name, name);
    List<Field> parameters = function.signature().parameters();
    List<Val> values = new ArrayList<>();
    List<Binding> bindings = new ArrayList<>();
    for (Field parameter : parameters) {
      bindings.add(new Binding(parameter.name() + "$", sorts.sort(parameter.type())));
      values.add(of(parameter.name() + "$", parameter.type()));
    }
    Type result = function.signature().result();
    List<String> more = new ArrayList<>();
    for (String sort : argumentSorts(result)) {
      more.add("x" + more.size());
      bindings.add(new Binding(more.getLast(), sort));
    }
    definitions++;
    String body = withoutObligations(() -> body(function, scope, values, more));
    definitions--;
    String text = Binding.text(bindings) + " " + resultSort(result) + " " + body;
    // Over two states that are equal in all that it reads, it is one function.
    String same = texts.putIfAbsent(text.replace("(" + name + " ", "(self "), name);
    if (same != null) {
      names.put(name, same);
      return same;
    }
    if (sorts.isFinite()) {
      script.line("(define-fun-rec " + name + " " + text + ")");
    } else {
      script.declare(name, sortsOf(function), resultSort(result));
      unfolded.add(new Unfolded(name, function, scope));
    }
    return name;
  }

  /** The value at all arguments; any value where a parameter is none of its type. */
  private String body(Function function, Scope scope, List<Val> arguments, List<String> more) {
    List<Field> parameters = function.signature().parameters();
    Type result = function.signature().result();
    Val value = as(result, function.body(), scope.only(parameters, arguments));
    String guard = inside(parameters, arguments);
    if (guard.equals(Smt.TRUE)) {
      return applied(value, result, more);
    }
    String otherwise = "f." + function.signature().name() + ".else";
    if (names.putIfAbsent(otherwise, otherwise) == null) {
      script.declare(otherwise, sortsOf(function), resultSort(result));
    }
    List<String> all = new ArrayList<>(terms(parameters, arguments));
    all.addAll(more);
    return Smt.ite(guard, applied(value, result, more), Smt.call(otherwise, all));
  }

  /** A function that the solver knows by its values at some points: all of them would keep it busy. */
  private record Unfolded(String name, Function function, Scope scope) {}

  /** Says what the values of recursive functions are where a number or list is one of {@code points}. */
  void unfold(List<Field> fields, List<Val> points) {
    for (Unfolded each : List.copyOf(unfolded)) {
      script.comment("some values of " + each.name());
      unfold(each, fields, points, new ArrayList<>(), new ArrayList<>());
    }
  }

  private void unfold(
      Unfolded of, List<Field> fields, List<Val> points, List<Val> arguments, List<Binding> open) {
    List<Field> parameters = of.function().signature().parameters();
    if (arguments.size() == parameters.size()) {
      Type result = of.function().signature().result();
      List<String> more = new ArrayList<>();
      List<Binding> bindings = new ArrayList<>(open);
      for (String sort : argumentSorts(result)) {
        more.add("x" + more.size());
        bindings.add(new Binding(more.getLast(), sort));
      }
      List<String> all = new ArrayList<>(terms(parameters, arguments));
      all.addAll(more);
      String value = Smt.call(of.name(), all);
      definitions++;
      String equal = Smt.equal(value, body(of.function(), of.scope(), arguments, more));
      definitions--;
      script.require(
          bindings.isEmpty()
              ? equal
              : Smt.quantified(true, bindings, "(! " + equal + " :pattern (" + value + "))"));
      return;
    }
    Type type = parameters.get(arguments.size()).type();
    if (type.base() instanceof Num || type.base() instanceof Type.ListOf) {
      for (int i = 0; i < points.size(); i++) {
        if (fields.get(i).type().base().equals(type.base())) {
          unfold(of, fields, points, with(arguments, points.get(i)), open);
        }
      }
    } else {
      String name = "y" + arguments.size();
      Binding binding = new Binding(name, sorts.sort(type));
      unfold(of, fields, points, with(arguments, of(name, type)), with(open, binding));
    }
  }

  private static <T> List<T> with(List<T> list, T last) {
    List<T> longer = new ArrayList<>(list);
    longer.add(last);
    return longer;
  }

  /** The value of a recursive function. */
  Val applied(Function function, Scope scope, List<Val> arguments) {
    List<String> terms = terms(function.signature().parameters(), arguments);
    return symbol(define(function, scope), terms, function.signature().result());
  }

  /** The sorts of a function's parameters, and of its result's arguments. */
  List<String> sortsOf(Function function) {
    List<String> all = new ArrayList<>();
    function.signature().parameters().forEach(p -> all.add(sorts.sort(p.type())));
    all.addAll(argumentSorts(function.signature().result()));
    return all;
  }

  /** The same function over another state has another name. */
  static String recursiveName(Function function, Scope scope) {
    return (function.signature().readsState() ? scope.state() : "f.") + function.signature().name();
  }

  /** Goes through a function's body: its calls of itself, with the conditions around them. */
  List<RecursiveCall> callsOfItself(Function function, Scope scope, List<Val> parameters) {
    String name = recursiveName(function, scope);
    Type result = function.signature().result();
    names.put(name, name);
    script.declare(name, sortsOf(function), resultSort(result));
    Scope inner = scope.only(function.signature().parameters(), parameters);
    Val body = as(result, function.body(), inner);
    List<String> more = new ArrayList<>();
    for (String sort : argumentSorts(result)) {
      more.add("w.x" + more.size());
      script.declare(more.getLast(), List.of(), sort);
    }
    String whole = applied(body, result, more); // works out what maps hold
    return whole.isEmpty() ? List.of() : calls.stream().filter(c -> c.name().equals(name)).toList();
  }
}
