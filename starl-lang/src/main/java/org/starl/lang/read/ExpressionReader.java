// Longer than 500 lines because each kind of expression has one method here, and these call each
// other.
package org.starl.lang.read;

import static org.starl.lang.read.Problems.pos;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.antlr.v4.runtime.ParserRuleContext;
import org.jspecify.annotations.Nullable;
import org.starl.input.NearMatches;
import org.starl.lang.grammar.StarlParser;
import org.starl.lang.grammar.StarlParser.ExpressionContext;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Bound;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Expr.BuiltIn;
import org.starl.lang.tree.Expr.Operator;
import org.starl.lang.tree.Exprs;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Signature;
import org.starl.lang.tree.Substitution;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Constructor;
import org.starl.lang.tree.Type.Field;
import org.starl.lang.tree.Type.Num;

/**
 * Reads expressions: resolves their names, and checks their types. An error is told, and then thrown.
 */
final class ExpressionReader {

  /** What functions of other languages are called here. */
  private static final Map<String, String> OF_OTHERS =
      Map.of(
          "size", "card",
          "count", "card",
          "len", "length",
          "keys", "{k: K | k in m} for the keys of m",
          "dom", "{k: K | k in m} for the keys of m");

  private final Scope scope;
  private final Problems problems;
  private final TypeReader types;

  ExpressionReader(Scope scope, Problems problems) {
    this.scope = scope;
    this.problems = problems;
    types = new TypeReader(scope, problems);
  }

  /** An expression of type {@code wanted}. */
  Expr read(ExpressionContext at, Type wanted) {
    return required(any(at, wanted), at, wanted);
  }

  private Expr required(Expr expr, ExpressionContext at, Type wanted) {
    if (wanted.base() instanceof Type.Range range && Type.isNumber(expr.type(), Num::isWhole)) {
      return within(expr, at, range, wanted);
    }
    if (!expr.type().isA(wanted)) {
      String found = named(expr.type(), wanted);
      String expected = named(wanted, expr.type());
      throw wrong(
          at,
          "'%s' is of type %s; expected %s%s"
              .formatted(text(at), found, expected, cure(expr.type(), at, wanted)));
    }
    return expr;
  }

  /** How a value becomes one of the type that is expected; empty if it does not. */
  private static String cure(Type type, ExpressionContext at, Type wanted) {
    if (wanted == Num.REAL && at instanceof StarlParser.ComparisonContext) {
      return "; two comparisons are joined by 'and'";
    }
    if (wanted.base() instanceof Type.OptionOf option && type.isA(option.element())) {
      return ": some(" + text(at) + ")";
    }
    return type.base() instanceof Type.OptionOf option
            && Type.plain(option.element()).isA(Type.plain(wanted))
        ? ": the(" + text(at) + ")"
        : wanted == Num.REAL && type.base() instanceof Type.SetOf
            ? "; sets have union, minus and intersect"
            : "";
  }

  /** A number where one of a range is expected: asked for when it is evaluated, if it is no constant. */
  private Expr within(Expr expr, ExpressionContext at, Type.Range range, Type wanted) {
    Expr number = expr instanceof Expr.Negative minus ? minus.of() : expr;
    boolean isKnown = range.low().isNumber() && range.high().isNumber();
    if (isKnown && number instanceof Expr.Numeral numeral) {
      BigDecimal value = number == expr ? numeral.value() : numeral.value().negate();
      if (value.compareTo(BigDecimal.valueOf(range.low().plus())) < 0
          || value.compareTo(BigDecimal.valueOf(range.high().plus())) > 0) {
        throw wrong(
            at, "'" + text(at) + "' is not in " + range + "; expected one of these numbers");
      }
      return expr;
    }
    return expr.type().isA(range) ? expr : new BuiltIn(BuiltIn.Name.WITHIN, expr, wanted, pos(at));
  }

  /** A type; with its automaton, if the other one has the same name. */
  private static String named(Type type, Type other) {
    String owner = type.toString().equals(other.toString()) ? owner(type.base()) : "";
    return owner.isEmpty() ? type.toString() : type + " of " + owner;
  }

  private static String owner(Type type) {
    return switch (type) {
      case Type.Rec rec -> rec.owner();
      case Type.Sum sum -> sum.owner();
      case Type.SetOf set -> owner(set.element());
      case Type.ListOf list -> owner(list.element());
      case Type.OptionOf option -> owner(option.element());
      case Type.MapOf map -> owner(map.result());
      default -> "";
    };
  }

  Expr bool(ExpressionContext at) {
    return read(at, Type.Bool.BOOL);
  }

  /** An expression of any type; {@code hint} is the type of what has none of itself: {@code {}}. */
  private Expr any(ExpressionContext at, @Nullable Type hint) {
    Pos pos = pos(at);
    return switch (at) {
      case StarlParser.ParenthesesContext inner -> any(inner.expression(), hint);
      case StarlParser.LiteralContext literal -> literal(literal, pos);
      case StarlParser.NameContext name -> name(name, hint, pos);
      case StarlParser.FieldOfContext field -> field(field, pos);
      case StarlParser.ApplyContext apply -> apply(apply, hint, pos);
      case StarlParser.RecordOfContext made -> record(made, hint, pos);
      case StarlParser.NotContext not -> new Expr.Not(bool(not.expression()), pos);
      case StarlParser.NegativeContext minus ->
          new Expr.Negative(read(minus.expression(), whole(hint)), pos);
      case StarlParser.AndContext and -> logic(Operator.AND, and.expression(), pos);
      case StarlParser.OrContext or -> logic(Operator.OR, or.expression(), pos);
      case StarlParser.ImpliesContext implies -> logic(Operator.IMPLIES, implies.expression(), pos);
      case StarlParser.IffContext iff -> logic(Operator.IFF, iff.expression(), pos);
      case StarlParser.ComparisonContext compared ->
          comparison(operator(compared.op.getText()), compared.expression(), pos);
      case StarlParser.SumContext sum ->
          arithmetic(operator(sum.op.getText()), sum.expression(), hint, pos);
      case StarlParser.MultiplicationContext product ->
          arithmetic(operator(product.op.getText()), product.expression(), hint, pos);
      case StarlParser.RangeContext range -> range(range, hint, pos);
      case StarlParser.IsOfContext is -> is(is, pos);
      case StarlParser.QuantifiedContext quantified -> quantified(quantified, pos);
      case StarlParser.LetContext let -> let(let, hint);
      case StarlParser.ConditionalContext conditional -> conditional(conditional, hint, pos);
      case StarlParser.MatchContext match -> match(match, hint, pos);
      case StarlParser.ComprehensionContext set ->
          suchThat(set.name, set.type(), set.expression(), pos);
      case StarlParser.ChooseContext of -> {
        Expr.SuchThat set = suchThat(of.name, of.type(), of.expression(), pos);
        yield new BuiltIn(BuiltIn.Name.CHOOSE, set, set.variable().type(), pos);
      }
      case StarlParser.MapOfContext map -> map(map, hint, pos);
      case StarlParser.SetOfContext set
          when set.expression().isEmpty() && hint != null && isPartialMap(hint) ->
          emptyMap(hint, pos);
      case StarlParser.SetOfContext set -> {
        Type element = hint != null && hint.base() instanceof Type.SetOf of ? of.element() : null;
        List<Expr> elements = elements(set.expression(), element, at);
        yield new Expr.SetOf(elements, whole(hint, new Type.SetOf(of(elements, element))), pos);
      }
      case StarlParser.ListOfContext list -> {
        Type element = hint != null && hint.base() instanceof Type.ListOf of ? of.element() : null;
        List<Expr> elements = elements(list.expression(), element, at);
        yield new Expr.ListOf(elements, whole(hint, new Type.ListOf(of(elements, element))), pos);
      }
      case StarlParser.NoneContext none -> {
        if (hint == null || !(hint.base() instanceof Type.OptionOf)) {
          throw wrong(
              at,
              "nothing here says what 'none' is an option of; expected " + or(hint, "an option"));
        }
        yield new Expr.None(hint, pos);
      }
      default -> throw new IllegalStateException("expression " + at.getText());
    };
  }

  private static String or(@Nullable Type hint, String otherwise) {
    return hint == null ? otherwise : hint.toString();
  }

  private static Type whole(@Nullable Type hint, Type made) {
    return hint != null && hint.base().equals(made.base()) ? hint : made;
  }

  private static Type of(List<Expr> elements, @Nullable Type element) {
    Type first = element != null ? element : elements.getFirst().type();
    return element == null && elements.size() > 1 ? Type.plain(first) : first;
  }

  private List<Expr> elements(
      List<ExpressionContext> all, @Nullable Type element, ParserRuleContext at) {
    if (all.isEmpty() && element == null) {
      throw wrong(
          at,
          "nothing here says of what type the elements of '"
              + text(at)
              + "' are; expected a set or list of a known type beside it");
    }
    List<Expr> elements = new ArrayList<>();
    Type type = element;
    for (ExpressionContext each : all) {
      Expr read = type == null ? any(each, null) : read(each, type);
      type = type != null || all.size() == 1 ? type : Type.plain(read.type());
      elements.add(read);
    }
    return List.copyOf(elements);
  }

  private Expr literal(StarlParser.LiteralContext at, Pos pos) {
    String text = at.getText();
    return switch (text) {
      case "true" -> new Expr.Bool(true, pos);
      case "false" -> new Expr.Bool(false, pos);
      default -> {
        BigDecimal value = new BigDecimal(text);
        if (Math.max(value.precision(), value.scale()) > 18) { // those of a long
          throw wrong(at, text + " is too long; expected at most 18 digits");
        }
        yield new Expr.Numeral(value, text.contains(".") ? Num.TIME : Num.NAT, pos);
      }
    };
  }

  private Expr name(StarlParser.NameContext at, @Nullable Type hint, Pos pos) {
    String name = at.name.getText();
    Optional<Field> bound = scope.bound(name);
    refer(at.name);
    if (bound.isPresent()) {
      return new Expr.Variable(name, bound.get().type(), pos);
    }
    Type type = scope.values.get(name);
    if (type != null) {
      return new Expr.Parameter(name, type, pos);
    }
    type = scope.state.get(name);
    if (type != null) {
      return new Expr.Component(name, type, pos);
    }
    Signature function = scope.functions.get(name);
    if (function != null) {
      return new Expr.Call(
          "", function, arguments(name, function.parameters(), List.of(), at), pos);
    }
    Scope.Known known = form(name, hint);
    if (known != null) {
      return new Expr.Make(
          known.constructor(),
          arguments(name, known.constructor().fields(), List.of(), at),
          known.sum(),
          pos);
    }
    throw unknown(at, name, scope.names());
  }

  /** A form of the type that is expected, which may be another automaton's, or else of this one's. */
  private Scope.@Nullable Known form(String name, @Nullable Type hint) {
    return hint != null && hint.base() instanceof Type.Sum sum && sum.constructor(name).isPresent()
        ? new Scope.Known(sum, sum.constructor(name).get())
        : scope.constructors.get(name);
  }

  /** Keeps the meaning of a name that is known here. */
  private void refer(StarlParser.IdContext at) {
    String name = at.getText();
    Signature function = scope.functions.get(name);
    Scope.Known known = scope.constructors.get(name);
    String meaning = null;
    if (scope.bound(name).isPresent()) {
      meaning = name + ": " + scope.bound(name).get().type();
    } else if (scope.values.containsKey(name)) {
      meaning = name + ": " + scope.values.get(name);
    } else if (scope.state.containsKey(name)) {
      meaning = name + ": " + scope.state.get(name);
    } else if (function != null) {
      meaning =
          "fun " + name + "(" + TypeReader.list(function.parameters()) + "): " + function.result();
    } else if (known != null) {
      meaning = name + ": " + known.sum();
    }
    if (meaning != null) {
      problems.refer(at, meaning, scope.place(name, at));
    }
  }

  private Expr field(StarlParser.FieldOfContext at, Pos pos) {
    String name = at.name.getText();
    if (isUsed(at.expression())) {
      String used = at.expression().getText();
      Automaton automaton = scope.used(used);
      if (name.equals("start?")) {
        return new Expr.Started(used, automaton, pos);
      }
      Optional<Signature> constant = automaton.function(name).map(f -> f.signature());
      if (constant.isPresent()) {
        return new Expr.Call(
            used, constant.get(), arguments(name, constant.get().parameters(), List.of(), at), pos);
      }
    }
    Expr of = any(at.expression(), null);
    return switch (of.type().base()) {
      case Type.Rec rec -> get(of, name, rec.fields(), at, pos);
      case Type.Sum sum -> {
        List<Field> all = sum.constructors().stream().flatMap(c -> c.fields().stream()).toList();
        yield get(of, name, all, at, pos);
      }
      case Type.StateOf state ->
          get(
              of,
              name,
              state.automaton().state().stream().map(c -> new Field(c.name(), c.type())).toList(),
              at,
              pos);
      default ->
          throw wrong(
              at,
              "'%s' is of type %s and has no field '%s'; expected a record"
                  .formatted(text(at.expression()), of.type(), name));
    };
  }

  private Expr get(
      Expr of, String name, List<Field> fields, StarlParser.FieldOfContext at, Pos pos) {
    return fields.stream()
        .filter(field -> field.name().equals(name))
        .findFirst()
        .map(field -> {
          Pos declared =
              of instanceof Expr.Component known ? scope.place(known.name(), at) : pos(at.name);
          problems.refer(at.name, name + ": " + field.type(), declared);
          return new Expr.Get(of, name, field.type(), pos);
        })
        .orElseThrow(() -> unknown(at.name, name, fields.stream().map(Field::name).toList()));
  }

  private boolean isUsed(ExpressionContext at) {
    return at instanceof StarlParser.NameContext name
        && scope.uses.containsKey(name.getText())
        && scope.bound(name.getText()).isEmpty();
  }

  private Expr apply(StarlParser.ApplyContext at, @Nullable Type hint, Pos pos) {
    ExpressionContext called = at.expression(0);
    List<ExpressionContext> given = at.expression().subList(1, at.expression().size());
    if (called instanceof StarlParser.NameContext named && scope.bound(named.getText()).isEmpty()) {
      String name = named.getText();
      Signature function = scope.functions.get(name);
      if (function != null) {
        refer(named.name);
        return new Expr.Call("", function, arguments(name, function.parameters(), given, at), pos);
      }
      Scope.Known known = form(name, hint);
      if (known != null) {
        refer(named.name);
        return new Expr.Make(
            known.constructor(),
            arguments(name, known.constructor().fields(), given, at),
            known.sum(),
            pos);
      }
      if (Language.WORDS.contains(name)) {
        return builtIn(name, given, hint, at, pos);
      }
    }
    if (called instanceof StarlParser.FieldOfContext field && isUsed(field.expression())) {
      String used = field.expression().getText();
      String name = field.name.getText();
      Automaton automaton = scope.used(used);
      Optional<Action> action = automaton.action(name);
      if (action.isPresent()) {
        return new Expr.Enabled(
            used,
            automaton,
            action.get(),
            arguments(name, action.get().parameters(), given, at),
            pos);
      }
      Optional<Signature> function = automaton.function(name).map(f -> f.signature());
      if (function.isPresent()) {
        return new Expr.Call(
            used, function.get(), arguments(name, function.get().parameters(), given, at), pos);
      }
    }
    Expr map = any(called, null);
    if (map.type().base() instanceof Type.ListOf list) {
      List<Field> place = List.of(new Field("", Num.INT));
      Expr n = arguments(text(called), place, given, at).getFirst();
      return new Expr.Binary(Operator.NTH, map, n, list.element(), pos);
    }
    if (!(map.type().base() instanceof Type.MapOf type)) {
      throw wrong(
          at,
          "'"
              + text(called)
              + "' is of type "
              + map.type()
              + " and takes no arguments; expected a function, a map or a list");
    }
    List<Field> parameters = new ArrayList<>();
    type.arguments().forEach(argument -> parameters.add(new Field("", argument)));
    return new Expr.At(map, arguments(text(called), parameters, given, at), type.result(), pos);
  }

  /** Arguments of the function, constructor or action {@code name}. */
  List<Expr> arguments(
      String name, List<Field> parameters, List<ExpressionContext> given, ParserRuleContext at) {
    if (given.size() != parameters.size()) {
      throw wrong(
          at,
          "'"
              + name
              + "' has "
              + given.size()
              + " arguments here; expected "
              + parameters.size()
              + (parameters.isEmpty()
                  ? ""
                  : ": "
                      + parameters.stream()
                          .map(p ->
                              p.name().isEmpty() ? p.type().toString() : p.name() + ": " + p.type())
                          .reduce((a, b) -> a + ", " + b)
                          .orElse("")));
    }
    List<Expr> arguments = new ArrayList<>();
    for (int i = 0; i < given.size(); i++) {
      arguments.add(read(given.get(i), parameters.get(i).type()));
    }
    return List.copyOf(arguments);
  }

  private Expr builtIn(
      String name,
      List<ExpressionContext> given,
      @Nullable Type hint,
      ParserRuleContext at,
      Pos pos) {
    if (given.size() != 1) {
      throw wrong(at, "'" + name + "' has " + given.size() + " arguments here; expected 1");
    }
    ExpressionContext argument = given.getFirst();
    if (name.equals("some")) {
      Type element =
          hint != null && hint.base() instanceof Type.OptionOf option ? option.element() : null;
      Expr of = element == null ? any(argument, null) : read(argument, element);
      return new Expr.Some(of, whole(hint, new Type.OptionOf(of.type())), pos);
    }
    if (name.equals("card") && inside(argument) instanceof StarlParser.RangeContext range) {
      return size(range, pos);
    }
    Expr of = any(argument, null);
    if (name.equals("the")) {
      if (!(of.type().base() instanceof Type.OptionOf option)) {
        throw wrong(
            argument, "'" + text(argument) + "' is of type " + of.type() + "; expected an option");
      }
      return new BuiltIn(BuiltIn.Name.THE, of, option.element(), pos);
    }
    if (name.equals("card") && isPartialMap(of.type())) {
      Field key = new Field(unused("k", of), keys(of.type()));
      Expr keyTest = keyTest(new Expr.Variable(key.name(), key.type(), pos), of, pos);
      Expr keys = new Expr.SuchThat(key, keyTest, new Type.SetOf(key.type()), pos);
      return new BuiltIn(BuiltIn.Name.CARD, keys, Num.NAT, pos);
    }
    if (name.equals("card")) {
      return new BuiltIn(BuiltIn.Name.CARD, set(of, argument), Num.NAT, pos);
    }
    if (!(of.type().base() instanceof Type.ListOf list)) {
      throw wrong(
          argument, "'" + text(argument) + "' is of type " + of.type() + "; expected a list");
    }
    return switch (name) {
      case "head" -> new BuiltIn(BuiltIn.Name.HEAD, of, list.element(), pos);
      case "tail" -> new BuiltIn(BuiltIn.Name.TAIL, of, of.type(), pos);
      case "length" -> new BuiltIn(BuiltIn.Name.LENGTH, of, Num.NAT, pos);
      case "distinct" -> new BuiltIn(BuiltIn.Name.DISTINCT, of, Type.Bool.BOOL, pos);
      default -> new BuiltIn(BuiltIn.Name.ELEMENTS, of, new Type.SetOf(list.element()), pos);
    };
  }

  // --- map[K, V] is [K -> option[V]]: a key is in it if it has a value there

  private static boolean isPartialMap(Type type) {
    return type.base() instanceof Type.MapOf map
        && map.arguments().size() == 1
        && map.result() instanceof Type.OptionOf;
  }

  private static Type keys(Type map) {
    return ((Type.MapOf) map.base()).arguments().getFirst();
  }

  private static Expr keyTest(Expr key, Expr map, Pos pos) {
    Type result = ((Type.MapOf) map.type().base()).result();
    Expr value = new Expr.At(map, List.of(key), result, pos);
    Expr none = new Expr.None(result, pos);
    return new Expr.Binary(Operator.UNEQUAL, value, none, Type.Bool.BOOL, pos);
  }

  private Expr emptyMap(Type type, Pos pos) {
    Expr none = new Expr.None(((Type.MapOf) type.base()).result(), pos);
    return new Expr.MapOf(List.of(new Field(unused("k"), keys(type))), none, type, pos);
  }

  private Expr record(StarlParser.RecordOfContext at, @Nullable Type hint, Pos pos) {
    String name = at.name.getText();
    boolean isWanted =
        hint != null && hint.base() instanceof Type.Rec wanted && wanted.name().equals(name);
    Type type = isWanted ? hint : scope.types.get(name);
    if (type == null || !(type.base() instanceof Type.Rec rec)) {
      throw wrong(
          at.name,
          "'"
              + name
              + "' is no record; expected the name of a type that is declared with 'record'");
    }
    List<Expr> values = new ArrayList<>();
    Set<String> given = new TreeSet<>();
    at.namedArgument().forEach(argument -> given.add(argument.name.getText()));
    for (Field field : rec.fields()) {
      Optional<StarlParser.NamedArgumentContext> argument =
          at.namedArgument().stream()
              .filter(a -> a.name.getText().equals(field.name()))
              .findFirst();
      if (argument.isEmpty()) {
        throw wrong(
            at,
            "'%s' has no value for %s here; expected %s := a value of %s"
                .formatted(name, field.name(), field.name(), field.type()));
      }
      given.remove(field.name());
      values.add(read(argument.get().expression(), field.type()));
    }
    if (!given.isEmpty() || at.namedArgument().size() != rec.fields().size()) {
      throw wrong(
          at,
          "'"
              + name
              + "' has other fields; expected each once: "
              + rec.fields().stream().map(Field::name).toList());
    }
    return new Expr.MakeRecord(List.copyOf(values), type, pos);
  }

  private Expr logic(Operator operator, List<ExpressionContext> sides, Pos pos) {
    return new Expr.Binary(operator, bool(sides.get(0)), bool(sides.get(1)), Type.Bool.BOOL, pos);
  }

  private static Operator operator(String text) {
    for (Operator operator : Operator.values()) {
      if (operator.text().equals(text)) {
        return operator;
      }
    }
    throw new IllegalStateException(text);
  }

  private Expr comparison(Operator operator, List<ExpressionContext> sides, Pos pos) {
    ExpressionContext left = sides.get(0);
    ExpressionContext right = sides.get(1);
    return switch (operator) {
      case IN -> {
        if (inside(right) instanceof StarlParser.RangeContext range) {
          yield within(range, read(left, Num.INT), pos);
        }
        Expr of = any(right, null);
        if (isPartialMap(of.type())) {
          yield keyTest(read(left, keys(of.type())), of, pos);
        }
        Expr set = set(of, right);
        Type element = ((Type.SetOf) set.type().base()).element();
        yield new Expr.Binary(operator, read(left, element), set, Type.Bool.BOOL, pos);
      }
      case SUBSET, DISJOINT -> {
        List<Expr> both = alike(left, right, null);
        Expr first = set(both.get(0), left);
        yield new Expr.Binary(operator, first, both.get(1), Type.Bool.BOOL, pos);
      }
      case EQUAL, UNEQUAL -> {
        List<Expr> both = alike(left, right, null);
        yield new Expr.Binary(operator, both.get(0), both.get(1), Type.Bool.BOOL, pos);
      }
      default -> {
        Expr a = required(any(left, Num.REAL), left, Num.REAL);
        Expr b = required(any(right, whole(a.type())), right, Num.REAL);
        yield new Expr.Binary(operator, again(a, left, b), b, Type.Bool.BOOL, pos);
      }
    };
  }

  // --- ranges are sets of whole numbers, {n: nat | a <= n and n <= b}

  private Expr range(StarlParser.RangeContext at, @Nullable Type hint, Pos pos) {
    Expr from = bound(at, 0);
    Expr to = bound(at, 1);
    Type wanted = hint != null && hint.base() instanceof Type.SetOf of ? of.element() : Num.NAT;
    Type element =
        isPart(from, to, wanted)
            ? wanted
            : wanted == Num.INT || !isNatural(from) ? Num.INT : Num.NAT;
    String name = unused("n", from, to);
    Expr body = within(at, new Expr.Variable(name, element, pos), pos);
    return new Expr.SuchThat(
        new Field(name, element), body, whole(hint, new Type.SetOf(element)), pos);
  }

  /** A name for a variable that means nothing else. */
  private String unused(String wanted, Expr... beside) {
    String name = wanted;
    while (true) {
      String now = name;
      if (scope.taken(now).isEmpty()
          && Arrays.stream(beside).noneMatch(each -> Exprs.mentions(each, now))) {
        return name;
      }
      name += "_";
    }
  }

  /** Whether the numbers are some of a type that is a range: all of these are known to be. */
  private static boolean isPart(Expr from, Expr to, Type wanted) {
    return Bound.of(from)
        .flatMap(low -> Bound.of(to).map(high -> new Type.Range(low, high)))
        .filter(range -> wanted.base() instanceof Type.Range && range.isA(wanted))
        .isPresent();
  }

  private Expr bound(StarlParser.RangeContext at, int number) {
    return read(at.expression(number), Num.INT);
  }

  /** {@code a <= value and value <= b}. */
  private Expr within(StarlParser.RangeContext at, Expr value, Pos pos) {
    Type bool = Type.Bool.BOOL;
    Expr low = new Expr.Binary(Operator.AT_MOST, bound(at, 0), value, bool, pos);
    Expr high = new Expr.Binary(Operator.AT_MOST, value, bound(at, 1), bool, pos);
    return new Expr.Binary(Operator.AND, low, high, bool, pos);
  }

  private Expr size(StarlParser.RangeContext at, Pos pos) {
    Expr from = bound(at, 0);
    Expr to = bound(at, 1);
    Expr one = new Expr.Numeral(BigDecimal.ONE, Num.NAT, pos);
    Expr zero = new Expr.Numeral(BigDecimal.ZERO, Num.NAT, pos);
    Expr less = new Expr.Binary(Operator.LESS_BY, to, from, Num.INT, pos);
    Expr size = new Expr.Binary(Operator.PLUS, less, one, Num.INT, pos);
    Expr isFull = new Expr.Binary(Operator.AT_MOST, from, to, Type.Bool.BOOL, pos);
    return new Expr.If(isFull, size, zero, Num.NAT, pos);
  }

  private static ExpressionContext inside(ExpressionContext at) {
    return at instanceof StarlParser.ParenthesesContext parentheses
        ? inside(parentheses.expression())
        : at;
  }

  private Expr set(Expr expr, ExpressionContext at) {
    if (!(expr.type().base() instanceof Type.SetOf)) {
      throw wrong(at, "'" + text(at) + "' is of type " + expr.type() + "; expected a set");
    }
    return expr;
  }

  /** Two expressions, one of whose types is that of both. */
  private List<Expr> alike(ExpressionContext left, ExpressionContext right, @Nullable Type hint) {
    Expr a;
    Expr b;
    if (hint == null && isBare(left)) {
      b = any(right, null);
      a = any(left, b.type());
    } else {
      a = any(left, hint);
      b = any(right, a.type());
    }
    Type first = Type.plain(a.type());
    Type second = Type.plain(b.type());
    if (!first.isA(second) && !second.isA(first)) {
      throw wrong(
          right,
          "'%s' is of type %s, and '%s' of type %s; expected two of one type%s"
              .formatted(text(right), b.type(), text(left), a.type(), alikeBy(a, b, text(right))));
    }
    return List.of(again(a, left, b), b);
  }

  /** How the right one of two becomes like the left one; empty if it does not. */
  private static String alikeBy(Expr left, Expr right, String text) {
    if (left.type().base() instanceof Type.SetOf set && right.type().isA(set.element())) {
      return ": {" + text + "}";
    }
    return isPartialMap(left.type()) && right.type().base() instanceof Type.SetOf
        ? "; the keys of a map m change by m(k) := some(v) and m(k) := none"
        : "";
  }

  /** What is read for the numbers of a type: a difference of naturals may be an {@code int}. */
  private static Type whole(@Nullable Type hint) {
    return hint != null && Type.plain(hint).base() == Num.INT ? Num.INT : Num.REAL;
  }

  /** The left side, where the right one is an {@code int}. */
  private Expr again(Expr a, ExpressionContext left, Expr b) {
    boolean isInt = Type.plain(b.type()).base() == Num.INT && isNatural(a);
    return isInt ? any(left, Num.INT) : a;
  }

  private static boolean isNatural(Expr of) {
    return Type.plain(of.type()).base() == Num.NAT;
  }

  /** Whether {@code at} has no type of itself. */
  private static boolean isBare(ExpressionContext at) {
    return at instanceof StarlParser.NoneContext
        || (at instanceof StarlParser.SetOfContext set && set.expression().isEmpty())
        || (at instanceof StarlParser.ListOfContext list && list.expression().isEmpty());
  }

  private Expr arithmetic(
      Operator operator, List<ExpressionContext> sides, @Nullable Type hint, Pos pos) {
    if (operator == Operator.UNION
        || operator == Operator.MINUS
        || operator == Operator.INTERSECT) {
      List<Expr> both = alike(sides.get(0), sides.get(1), hint);
      Expr first = set(both.get(0), sides.get(0));
      return new Expr.Binary(operator, first, both.get(1), first.type(), pos);
    }
    if (operator == Operator.JOIN) {
      return joined(sides.get(0), sides.get(1), hint, pos);
    }
    if (operator == Operator.MOD) {
      Expr left = read(sides.get(0), Num.INT);
      return new Expr.Binary(operator, left, read(sides.get(1), Num.INT), Num.NAT, pos);
    }
    Type of = operator == Operator.DIVIDED_BY ? Num.REAL : whole(hint);
    Expr first = number(sides.get(0), operator, of);
    Expr right = number(sides.get(1), operator, of == Num.INT ? of : whole(first.type()));
    Expr left = again(first, sides.get(0), right);
    Type wider = Type.plain(Type.wider(left.type(), right.type())).base();
    Type type =
        switch (operator) {
          case DIVIDED_BY -> wider == Num.NAT ? Num.TIME : wider == Num.INT ? Num.REAL : wider;
          case LESS_BY -> wider == Num.NAT && of == Num.INT ? Num.INT : wider;
          default -> wider;
        };
    return new Expr.Binary(operator, left, right, type, pos);
  }

  private Expr joined(
      ExpressionContext left, ExpressionContext right, @Nullable Type hint, Pos pos) {
    Type known = hint == null && isBare(left) ? any(right, null).type() : hint;
    Expr list = any(left, known);
    if (!(list.type().base() instanceof Type.ListOf of)) {
      throw wrong(left, "'" + text(left) + "' is of type " + list.type() + "; expected a list");
    }
    Expr more = any(right, list.type());
    if (!more.type().isA(list.type())) {
      boolean isElement = more.type().isA(of.element());
      throw wrong(
          right,
          "'%s' is of type %s; expected %s"
              .formatted(
                  text(right),
                  more.type(),
                  isElement ? "a list of it, [" + text(right) + "]" : list.type().toString()));
    }
    return new Expr.Binary(Operator.JOIN, list, more, list.type(), pos);
  }

  private Expr number(ExpressionContext at, Operator operator, Type hint) {
    Expr expr = any(at, hint);
    if (operator == Operator.PLUS && expr.type().base() instanceof Type.ListOf) {
      throw wrong(at, "'" + text(at) + "' is a list; expected '++' between two lists");
    }
    return required(expr, at, Num.REAL);
  }

  private Expr is(StarlParser.IsOfContext at, Pos pos) {
    Expr of = any(at.expression(), null);
    if (!(of.type().base() instanceof Type.Sum sum)) {
      throw wrong(
          at,
          "'%s' is of type %s; expected a type of several forms"
              .formatted(text(at.expression()), of.type()));
    }
    return new Expr.Is(of, constructor(sum, at.name), pos);
  }

  private Constructor constructor(Type.Sum sum, StarlParser.IdContext at) {
    return sum.constructor(at.getText())
        .orElseThrow(() ->
            unknown(at, at.getText(), sum.constructors().stream().map(Constructor::name).toList()));
  }

  private Expr quantified(StarlParser.QuantifiedContext at, Pos pos) {
    List<Field> variables = types.fields(at.binderGroup(), false);
    Expr body = under(variables, () -> bool(at.expression()));
    return new Expr.Quantified(at.quantifier.getType() == StarlParser.FORALL, variables, body, pos);
  }

  /** The variable stands for the value: the tools see that in its place. */
  private Expr let(StarlParser.LetContext at, @Nullable Type hint) {
    requireNew(at.name);
    String name = at.name.getText();
    Expr value = any(at.expression(0), null);
    scope.places.put(name, pos(at.name));
    Expr body = under(List.of(new Field(name, value.type())), () -> any(at.expression(1), hint));
    if (!Expansion.isSmall(body, name, value)) {
      throw wrong(at, "'" + name + "' stands " + Expansion.TOO_LARGE);
    }
    return new Substitution().replace(body, Map.of(name, value));
  }

  private void requireNew(StarlParser.IdContext at) {
    Optional<String> taken = scope.taken(at.getText());
    if (taken.isPresent()) {
      throw wrong(at, "'" + at.getText() + "' is " + taken.get() + " already; expected a new name");
    }
  }

  private Expr conditional(StarlParser.ConditionalContext at, @Nullable Type hint, Pos pos) {
    Expr condition = bool(at.expression(0));
    List<Expr> both = alike(at.expression(1), at.expression(2), hint);
    Type type = Type.wider(both.get(0).type(), both.get(1).type());
    return new Expr.If(condition, both.get(0), both.get(1), type, pos);
  }

  private Expr match(StarlParser.MatchContext at, @Nullable Type hint, Pos pos) {
    Expr of = any(at.expression(), null);
    if (!(of.type().base() instanceof Type.Sum sum)) {
      throw wrong(
          at.expression(),
          "'%s' is of type %s; expected a type of several forms"
              .formatted(text(at.expression()), of.type()));
    }
    List<Expr.Case> cases = new ArrayList<>();
    Type type = null; // the widest of the cases' types
    for (StarlParser.MatchCaseContext each : at.matchCase()) {
      Constructor constructor = constructor(sum, each.name);
      if (cases.stream().anyMatch(before -> before.constructor().equals(constructor))) {
        throw wrong(each, "'%s' is here twice; expected it once".formatted(constructor.name()));
      }
      List<StarlParser.IdContext> names = each.id().subList(1, each.id().size());
      if (names.size() != constructor.fields().size()) {
        throw wrong(
            each,
            "'%s' has %s names here; expected %s"
                .formatted(constructor.name(), names.size(), constructor.fields().size()));
      }
      List<Field> variables = new ArrayList<>();
      for (int i = 0; i < names.size(); i++) {
        variables.add(new Field(names.get(i).getText(), constructor.fields().get(i).type()));
      }
      Type known = hint != null ? hint : type;
      Expr value =
          under(
              variables,
              () -> known == null ? any(each.expression(), null) : read(each.expression(), known));
      Type its = hint != null ? value.type() : Type.plain(value.type());
      type = type == null || type.isA(its) ? its : type;
      cases.add(new Expr.Case(constructor, List.copyOf(variables), value));
    }
    List<String> missing =
        sum.constructors().stream()
            .map(Constructor::name)
            .filter(name -> cases.stream().noneMatch(c -> c.constructor().name().equals(name)))
            .toList();
    if (!missing.isEmpty()) {
      throw wrong(at, "this match has not each form of " + sum + " once; missing: " + missing);
    }
    return new Expr.Match(of, List.copyOf(cases), type == null ? sum : type, pos);
  }

  private Expr.SuchThat suchThat(
      StarlParser.IdContext name,
      StarlParser.TypeContext type,
      ExpressionContext condition,
      Pos pos) {
    requireNew(name);
    scope.places.put(name.getText(), pos(name));
    Field variable = new Field(name.getText(), types.type(type));
    Expr body = under(List.of(variable), () -> bool(condition));
    return new Expr.SuchThat(variable, body, new Type.SetOf(variable.type()), pos);
  }

  private Expr map(StarlParser.MapOfContext at, @Nullable Type hint, Pos pos) {
    List<Field> variables = types.fields(at.binderGroup(), false);
    Type result = hint != null && hint.base() instanceof Type.MapOf map ? map.result() : null;
    Expr body =
        under(
            variables,
            () -> result == null ? any(at.expression(), null) : read(at.expression(), result));
    Type type =
        new Type.MapOf(
            variables.stream().map(Field::type).toList(), result == null ? body.type() : result);
    return new Expr.MapOf(variables, body, whole(hint, type), pos);
  }

  private Expr under(List<Field> variables, java.util.function.Supplier<Expr> body) {
    scope.push(variables);
    try {
      return body.get();
    } finally {
      scope.pop(variables);
    }
  }

  private Wrong unknown(ParserRuleContext at, String name, List<String> known) {
    if (scope.wrong.contains(name)) {
      return new Wrong();
    }
    String other = OF_OTHERS.getOrDefault(name, "");
    List<String> near = other.isEmpty() ? NearMatches.of(name, known) : List.of(other);
    return wrong(
        at,
        "'"
            + name
            + "' is not known here; expected "
            + (near.isEmpty()
                ? "one of " + String.join(", ", known)
                : near.getFirst() + ", or another of " + known.size() + " names"));
  }

  Wrong wrong(ParserRuleContext at, String message) {
    problems.add(at, message);
    return new Wrong();
  }

  static String text(ParserRuleContext at) {
    return SourceText.of(at);
  }
}
