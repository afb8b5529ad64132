// Longer than 500 lines because it has a case for each kind of expression.
package org.starl.lang.eval;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BinaryOperator;
import java.util.function.ToIntFunction;
import org.jspecify.annotations.Nullable;
import org.starl.lang.eval.Code.Frame;
import org.starl.lang.tree.Action.Conjunct;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Function;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Constructor;
import org.starl.lang.tree.Type.Field;

/** Makes code of the expressions of one automaton. */
final class Compiler {

  /** The variables in scope, each with its place among the locals. */
  static final class Scope {

    final List<String> names = new ArrayList<>();

    /** The largest number of locals at a time. */
    int most;

    /** The places of the variables that were read. */
    final BitSet read = new BitSet();

    void push(List<Field> fields) {
      fields.forEach(field -> names.add(field.name()));
      most = Math.max(most, names.size());
    }

    void pop(List<Field> fields) {
      names.subList(names.size() - fields.size(), names.size()).clear();
    }
  }

  /** A function; its code is set after those that it calls are made. */
  private static final class Body {

    @Nullable Code code;
    int locals;
    boolean partial = true; // while a function is being made, its recursive calls count as partial

    Object run(Frame frame) {
      return Objects.requireNonNull(code).of(frame);
    }
  }

  private final Automaton automaton;
  private final Domains domains;
  private final List<Field> parameters;
  private final boolean inHoles;
  private final Map<String, Body> bodies = new LinkedHashMap<>();
  private final Map<String, Compiler> used = new LinkedHashMap<>();

  /** Whether an operation that may have no value was met. */
  private boolean partial;

  /**
   * @param parameters of the run
   * @param inHoles whether states have {@link Hole}s
   */
  Compiler(Automaton automaton, Domains domains, List<Field> parameters, boolean inHoles) {
    this.automaton = automaton;
    this.domains = domains;
    this.parameters = parameters;
    this.inHoles = inHoles;
    automaton
        .uses()
        .forEach((name, of) -> used.put(name, new Compiler(of, domains, parameters, inHoles)));
  }

  Compiler used(String component) {
    return get(used, component);
  }

  Automaton automaton() {
    return automaton;
  }

  Domains domains() {
    return domains;
  }

  EvalError error(Pos pos, String message) {
    return new EvalError(automaton.name(), pos, message);
  }

  int component(String name) {
    return component(name, automaton);
  }

  static int component(String name, Automaton automaton) {
    for (int i = 0; i < automaton.state().size(); i++) {
      if (automaton.state().get(i).name().equals(name)) {
        return i;
      }
    }
    throw new IllegalStateException(name);
  }

  private static <T> T get(Map<String, T> map, String name) {
    T value = map.get(name);
    if (value == null) {
      throw new IllegalStateException(name);
    }
    return value;
  }

  /** The code of an expression. */
  Code code(Expr expr, Scope scope) {
    return switch (expr) {
      case Expr.Bool bool -> frame -> bool.value();
      case Expr.Numeral numeral -> constant(numeral);
      case Expr.Variable variable -> {
        int place = scope.names.lastIndexOf(variable.name());
        scope.read.set(place);
        yield frame -> frame.locals[place];
      }
      case Expr.Parameter parameter -> filled(place(parameter, scope));
      case Expr.Component component -> filled(place(component, scope));
      case Expr.At at -> filled(place(at, scope));
      case Expr.Get get -> filled(place(get, scope));
      case Expr.Call call -> call(call, scope);
      case Expr.Enabled enabled -> enabled(enabled, scope);
      case Expr.Started started -> {
        Compiler of = used(started.used());
        Scope own = new Scope();
        Code[] starts = of.codes(of.automaton.start(), own);
        int component = component(started.used());
        partial = true;
        yield frame -> all(starts, inside(frame, component, new Object[own.most]));
      }
      case Expr.Make make -> {
        int constructor = number((Type.Sum) make.type().base(), make.constructor());
        Code[] fields = codes(make.arguments(), scope);
        yield frame -> new Form(constructor, row(fields, frame));
      }
      case Expr.MakeRecord make -> {
        Code[] fields = codes(make.values(), scope);
        yield frame -> row(fields, frame);
      }
      case Expr.Is is -> {
        Code of = code(is.of(), scope);
        int constructor = number((Type.Sum) is.of().type().base(), is.constructor());
        yield frame -> ((Form) of.of(frame)).constructor() == constructor;
      }
      case Expr.Match match -> match(match, scope);
      case Expr.Not not -> {
        Code of = code(not.of(), scope);
        yield frame -> !of.test(frame);
      }
      case Expr.Negative negative -> {
        Code of = code(negative.of(), scope);
        yield frame -> ((Num) of.of(frame)).negative();
      }
      case Expr.Binary binary -> binary(binary, scope);
      case Expr.Quantified quantified -> quantified(quantified, scope);
      case Expr.If choice -> {
        Code condition = code(choice.condition(), scope);
        Code then = code(choice.then(), scope);
        Code otherwise = code(choice.otherwise(), scope);
        yield frame -> condition.test(frame) ? then.of(frame) : otherwise.of(frame);
      }
      case Expr.SuchThat set -> suchThat(set, scope);
      case Expr.SetOf set -> {
        Domain element = ((Domain.Sets) domains.of(set.type())).element;
        Code[] elements = codes(set.elements(), scope);
        yield frame -> {
          BigInteger bits = BigInteger.ZERO;
          for (Code each : elements) {
            bits = bits.setBit(element.number(each.of(frame)));
          }
          return bits;
        };
      }
      case Expr.MapOf map -> mapOf(map, scope);
      case Expr.ListOf list -> {
        Code[] elements = codes(list.elements(), scope);
        yield frame -> row(elements, frame);
      }
      case Expr.None none -> frame -> Optional.empty();
      case Expr.Some some -> {
        Code of = code(some.of(), scope);
        yield frame -> Optional.of(of.of(frame));
      }
      case Expr.BuiltIn builtIn -> builtIn(builtIn, scope);
    };
  }

  private Code constant(Expr.Numeral numeral) {
    Num value = Num.of(numeral.value());
    return frame -> value;
  }

  Code[] codes(List<Expr> all, Scope scope) {
    return all.stream().map(each -> code(each, scope)).toArray(Code[]::new);
  }

  static Row row(Code[] codes, Frame frame) {
    return new Row(values(codes, frame, codes.length));
  }

  private static Object[] values(Code[] codes, Frame frame, int length) {
    Object[] values = new Object[length];
    for (int i = 0; i < codes.length; i++) {
      values[i] = codes[i].of(frame);
    }
    return values;
  }

  private static boolean all(Code[] conditions, Frame frame) {
    return Arrays.stream(conditions).allMatch(condition -> condition.test(frame));
  }

  private static int number(Type.Sum sum, Constructor constructor) {
    return sum.constructors().indexOf(constructor);
  }

  /** A part of the state as it stands there, with its holes. */
  Code place(Expr expr, Scope scope) {
    return switch (expr) {
      case Expr.Parameter parameter -> {
        int number = parameters.stream().map(Field::name).toList().indexOf(parameter.name());
        yield frame -> frame.root[number];
      }
      case Expr.Component component -> {
        int number = component(component.name());
        yield frame -> frame.state[frame.offset + number];
      }
      case Expr.At at -> {
        Code map = place(at.map(), scope);
        Code.Index number = index((Domain.Maps) domains.of(at.map().type()), at.arguments(), scope);
        yield frame -> ((Row) open(map.of(frame))).get(number.of(frame));
      }
      case Expr.Get get -> field(get, place(get.of(), scope));
      default -> code(expr, scope);
    };
  }

  /** The place of a map's value at these arguments. */
  Code.Index index(Domain.Maps map, List<Expr> arguments, Scope scope) {
    Code[] codes = codes(arguments, scope);
    Domain.Product domain = map.arguments;
    if (codes.length == 1) {
      Code only = codes[0];
      Domain of = domain.parts.getFirst();
      return frame -> number(of::number, only.of(frame));
    }
    return frame -> number(domain::number, row(codes, frame));
  }

  private static <T> int number(ToIntFunction<T> domain, T argument) {
    try {
      return domain.applyAsInt(argument);
    } catch (Beyond e) {
      throw Beyond.argument();
    }
  }

  private Code field(Expr.Get get, Code of) {
    Type type = get.of().type().base();
    if (!(type instanceof Type.Sum sum)) {
      int number = ((Domain.Records) domains.of(type)).names.indexOf(get.field());
      return frame -> ((Row) open(of.of(frame))).get(number);
    }
    partial |= sum.constructors().size() > 1;
    int[] places =
        sum.constructors().stream()
            .mapToInt(c -> c.fields().stream().map(Field::name).toList().indexOf(get.field()))
            .toArray();
    return frame -> {
      Form form = (Form) open(of.of(frame));
      if (places[form.constructor()] < 0) {
        throw error(
            get.pos(),
            "'%s' of %s, which has no such field"
                .formatted(get.field(), sum.constructors().get(form.constructor()).name()));
      }
      return form.fields().get(places[form.constructor()]);
    };
  }

  private static Object open(Object value) {
    if (value instanceof Hole hole) {
      if (hole.value == null) {
        throw new Hole.Needed(hole);
      }
      return hole.value;
    }
    return value;
  }

  private Code filled(Code place) {
    return inHoles ? frame -> filled(place.of(frame)) : place;
  }

  /** The value without holes. */
  static Object filled(Object value) {
    Object open = open(value);
    if (open instanceof Row row && Arrays.stream(row.items()).anyMatch(Compiler::hasHoles)) {
      return new Row(Arrays.stream(row.items()).map(Compiler::filled).toArray());
    }
    return open;
  }

  private static boolean hasHoles(Object value) {
    return value instanceof Hole
        || (value instanceof Row row && Arrays.stream(row.items()).anyMatch(Compiler::hasHoles));
  }

  /** In the state of the used automaton that is this component. */
  static Frame inside(Frame frame, int component, Object[] locals) {
    Row state = (Row) open(frame.state[frame.offset + component]);
    return new Frame(frame.root, state.items(), 0, locals, frame.depth + 1);
  }

  private Code call(Expr.Call call, Scope scope) {
    Code[] arguments = codes(call.arguments(), scope);
    String name = call.function().name();
    if (!call.used().isEmpty()) {
      Body body = used(call.used()).body(name);
      int component = component(call.used());
      partial |= body.partial;
      return frame -> body.run(inside(frame, component, values(arguments, frame, body.locals)));
    }
    Body body = body(name);
    partial |= body.partial;
    return frame -> {
      if (frame.depth > Frame.DEEPEST) {
        throw error(
            call.pos(),
            "calls of '%s' nest deeper than %,d; expected a measure that becomes smaller"
                .formatted(name, Frame.DEEPEST));
      }
      return body.run(
          new Frame(
              frame.root,
              frame.state,
              frame.offset,
              values(arguments, frame, body.locals),
              frame.depth + 1));
    };
  }

  private Code enabled(Expr.Enabled enabled, Scope scope) {
    Code[] arguments = codes(enabled.arguments(), scope);
    Scope own = new Scope();
    own.push(enabled.action().parameters());
    Code[] pre =
        used(enabled.used())
            .codes(enabled.action().pre().stream().map(Conjunct::condition).toList(), own);
    int component = component(enabled.used());
    partial = true;
    return frame -> all(pre, inside(frame, component, values(arguments, frame, own.most)));
  }

  private Code match(Expr.Match match, Scope scope) {
    Code of = code(match.of(), scope);
    Type.Sum sum = (Type.Sum) match.of().type().base();
    Code[] cases = new Code[sum.constructors().size()];
    for (Expr.Case each : match.cases()) {
      int first = scope.names.size();
      scope.push(each.variables());
      Code value = code(each.value(), scope);
      scope.pop(each.variables());
      int count = each.variables().size();
      cases[number(sum, each.constructor())] =
          frame -> {
            Form form = (Form) of.of(frame);
            System.arraycopy(form.fields().items(), 0, frame.locals, first, count);
            return value.of(frame);
          };
    }
    return frame -> cases[((Form) of.of(frame)).constructor()].of(frame);
  }

  /** Goes through the values of bound variables. */
  private interface Each {

    /** Whether to go on. */
    boolean visit(Frame frame);
  }

  private static boolean visit(
      List<List<Object>> variables, int variable, int first, Frame frame, Each each) {
    if (variable == variables.size()) {
      return each.visit(frame);
    }
    for (Object value : variables.get(variable)) {
      frame.locals[first + variable] = value;
      if (!visit(variables, variable + 1, first, frame, each)) {
        return false;
      }
    }
    return true;
  }

  List<Domain> bind(List<Field> variables, Scope scope, Pos pos) {
    List<Domain> all = domains.of(variables);
    try {
      for (int i = 0; i < all.size(); i++) {
        domains.requireFew(all.get(i), variables.get(i).name());
      }
    } catch (TooLarge e) {
      throw error(pos, String.valueOf(e.getMessage()));
    }
    scope.push(variables);
    return all;
  }

  /**
   * An instance that decides counts more than one beyond the bounds; numbers above the bound are
   * instances, too. All instances are looked at if
   * one may be an error: what is found does not depend on the order of ids.
   */
  private Code quantified(Expr.Quantified quantified, Scope scope) {
    int first = scope.names.size();
    List<Domain> variables = bind(quantified.variables(), scope, quantified.pos());
    boolean before = partial;
    partial = false;
    Code body = code(quantified.body(), scope);
    boolean isPartial = partial;
    partial |= before;
    scope.pop(quantified.variables());
    boolean forAll = quantified.forAll();
    boolean hasMore = variables.stream().anyMatch(Domain::hasMore);
    List<List<Object>> instances = variables.stream().map(Domain::instances).toList();
    return frame -> {
      boolean[] found = {false, hasMore, false}; // decided, beyond, an argument beyond
      visit(
          instances,
          0,
          first,
          frame,
          in -> {
            try {
              found[0] |= body.test(in) != forAll;
            } catch (Beyond e) {
              found[e.isArgument() ? 2 : 1] = true;
            }
            return isPartial || !found[0];
          });
      if ((found[1] || found[2]) && !found[0]) {
        throw found[1] ? new Beyond() : Beyond.argument();
      }
      return found[0] != forAll;
    };
  }

  private Code suchThat(Expr.SuchThat set, Scope scope) {
    int place = scope.names.size();
    List<Field> variables = List.of(set.variable());
    Domain domain = bind(variables, scope, set.pos()).getFirst();
    Code body = code(set.body(), scope);
    scope.pop(variables);
    List<Object> others = domain.others();
    boolean hasMore = domain.hasMore();
    return frame -> {
      BigInteger bits = BigInteger.ZERO;
      for (int i = 0; i < domain.values().size(); i++) {
        frame.locals[place] = domain.values().get(i);
        if (body.test(frame)) {
          bits = bits.setBit(i);
        }
      }
      for (Object other : others) {
        frame.locals[place] = other;
        if (isBeyond(body, frame)) {
          throw new Beyond(); // a set has no elements beyond the bounds
        }
      }
      if (hasMore) {
        throw new Beyond();
      }
      return bits;
    };
  }

  /** Maps of a start state have no values beyond the bounds that an element could depend on. */
  private boolean isBeyond(Code body, Frame frame) {
    try {
      return body.test(frame);
    } catch (Beyond e) {
      if (inHoles && e.isArgument()) {
        return false;
      }
      throw e;
    }
  }

  private Code mapOf(Expr.MapOf map, Scope scope) {
    int first = scope.names.size();
    List<Domain> variables = bind(map.variables(), scope, map.pos());
    int size = (int) ((Domain.Maps) domains.of(map.type())).arguments.size;
    List<List<Object>> values = variables.stream().map(Domain::values).toList();
    Code body = code(map.body(), scope);
    scope.pop(map.variables());
    return frame -> {
      List<Object> results = new ArrayList<>(size);
      visit(values, 0, first, frame, in -> results.add(body.of(in)));
      return Row.of(results);
    };
  }

  /** The first value within the bounds, in the order of their numbers. */
  private Code choose(Expr.SuchThat set, Scope scope, Pos pos) {
    int place = scope.names.size();
    List<Field> variables = List.of(set.variable());
    Domain domain = bind(variables, scope, pos).getFirst();
    domains.choose(domain);
    Code body = code(set.body(), scope);
    scope.pop(variables);
    partial = true;
    boolean hasMore = inHoles ? domain.isOpen() : domain.hasMore();
    return frame -> {
      for (Object value : inHoles ? domain.values() : domain.instances()) {
        frame.locals[place] = value;
        if (body.test(frame)) {
          if (!domain.contains(value)) {
            throw new Beyond(); // it stands for more than one number
          }
          return value;
        }
      }
      if (hasMore) {
        throw new Beyond();
      }
      throw error(pos, "nothing satisfies the condition of 'choose'");
    };
  }

  private Code builtIn(Expr.BuiltIn builtIn, Scope scope) {
    if (builtIn.name() == Expr.BuiltIn.Name.CHOOSE) {
      return choose((Expr.SuchThat) builtIn.of(), scope, builtIn.pos());
    }
    Code of = code(builtIn.of(), scope);
    Pos pos = builtIn.pos();
    return switch (builtIn.name()) {
      case THE -> {
        partial = true;
        yield frame ->
            ((Optional<?>) of.of(frame)).orElseThrow(() -> error(pos, "the(none) has no value"));
      }
      case HEAD -> {
        partial = true;
        yield frame -> nonEmpty((Row) of.of(frame), pos, "head").get(0);
      }
      case TAIL -> {
        partial = true;
        yield frame -> {
          Row list = nonEmpty((Row) of.of(frame), pos, "tail");
          return new Row(Arrays.copyOfRange(list.items(), 1, list.size()));
        };
      }
      case CARD -> frame -> Num.of(set(of, frame).bitCount());
      case LENGTH -> frame -> Num.of(((Row) of.of(frame)).size());
      case ELEMENTS -> {
        Domain element = ((Domain.Sets) domains.of(builtIn.type())).element;
        yield frame -> {
          BigInteger bits = BigInteger.ZERO;
          for (Object each : ((Row) of.of(frame)).items()) {
            bits = bits.setBit(element.number(each));
          }
          return bits;
        };
      }
      case DISTINCT ->
          frame -> {
            List<Object> all = List.of(((Row) of.of(frame)).items());
            return all.stream().distinct().count() == all.size();
          };
      case WITHIN -> {
        partial = true;
        Domain.Numbers range = (Domain.Numbers) domains.of(builtIn.type());
        yield frame -> {
          Object value = of.of(frame);
          if (!range.contains(value)) {
            throw error(pos, range.outside(value));
          }
          return value;
        };
      }
      case CHOOSE -> throw new IllegalStateException(builtIn.toString());
    };
  }

  private Row nonEmpty(Row list, Pos pos, String function) {
    if (list.size() == 0) {
      throw error(pos, function + "([]) has no value");
    }
    return list;
  }

  private Code binary(Expr.Binary binary, Scope scope) {
    Code left = code(binary.left(), scope);
    Code right = code(binary.right(), scope);
    Code not = frame -> !left.test(frame);
    return switch (binary.operator()) {
      case AND -> frame -> first(left, right, false, frame) && right.test(frame);
      case OR -> frame -> first(left, right, true, frame) || right.test(frame);
      case IMPLIES -> frame -> first(not, right, true, frame) || right.test(frame);
      case IFF -> frame -> left.test(frame) == right.test(frame);
      case EQUAL -> equal(binary, left, right);
      case UNEQUAL -> {
        Code equal = equal(binary, left, right);
        yield frame -> !equal.test(frame);
      }
      case LESS -> frame -> compared(left, right, frame) < 0;
      case AT_MOST -> frame -> compared(left, right, frame) <= 0;
      case GREATER -> frame -> compared(left, right, frame) > 0;
      case AT_LEAST -> frame -> compared(left, right, frame) >= 0;
      case IN -> {
        Domain element = ((Domain.Sets) domains.of(binary.right().type())).element;
        Code in = binary.right() instanceof Expr.SuchThat set ? satisfies(left, set, scope) : null;
        yield frame -> {
          Object value = left.of(frame);
          try {
            BigInteger bits = set(right, frame);
            return element.contains(value) && bits.testBit(element.number(value));
          } catch (Beyond e) { // the set has elements beyond the bounds
            if (in == null) {
              throw e;
            }
            return in.test(frame);
          }
        };
      }
      case SUBSET -> frame -> set(left, frame).andNot(set(right, frame)).signum() == 0;
      case DISJOINT -> frame -> set(left, frame).and(set(right, frame)).signum() == 0;
      case UNION -> frame -> set(left, frame).or(set(right, frame));
      case MINUS -> frame -> set(left, frame).andNot(set(right, frame));
      case INTERSECT -> frame -> set(left, frame).and(set(right, frame));
      case JOIN ->
          frame -> {
            List<Object> both = new ArrayList<>(List.of(((Row) left.of(frame)).items()));
            both.addAll(List.of(((Row) right.of(frame)).items()));
            return Row.of(both);
          };
      case NTH -> nth(binary.pos(), left, right);
      case PLUS -> arithmetic(left, right, Num::plus);
      case TIMES -> arithmetic(left, right, Num::times);
      case LESS_BY -> lessBy(binary, left, right);
      case DIVIDED_BY -> dividedBy(binary, left, right);
      case MOD -> {
        partial = true;
        yield frame -> ((Num) left.of(frame)).mod(positive(binary, (Num) right.of(frame)));
      }
    };
  }

  /** Whether a value satisfies the condition of a set. */
  private Code satisfies(Code value, Expr.SuchThat set, Scope scope) {
    int place = scope.names.size();
    List<Field> variables = List.of(set.variable());
    scope.push(variables);
    Code body = code(set.body(), scope);
    scope.pop(variables);
    return frame -> {
      frame.locals[place] = value.of(frame);
      return body.test(frame);
    };
  }

  /**
   * The value of the first of two conditions. If it is beyond the bounds, it does not matter where the
   * second one decides: where that is {@code decides}.
   */
  private static boolean first(Code left, Code right, boolean decides, Frame frame) {
    try {
      return left.test(frame);
    } catch (Beyond e) {
      if (isDecided(right, decides, frame)) {
        return decides;
      }
      throw e;
    }
  }

  private static boolean isDecided(Code right, boolean decides, Frame frame) {
    try {
      return right.test(frame) == decides;
    } catch (EvalError e) {
      return false; // it may have a value only where the first condition holds
    }
  }

  /** Maps that are equal within the bounds may differ beyond them. */
  private Code equal(Expr.Binary at, Code left, Code right) {
    boolean isTruncated = !inHoles && domains.of(at.left().type()).isTruncated();
    return frame -> {
      boolean isEqual = left.of(frame).equals(right.of(frame));
      if (isEqual && isTruncated) {
        throw new Beyond();
      }
      return isEqual;
    };
  }

  private static BigInteger set(Code code, Frame frame) {
    return (BigInteger) code.of(frame);
  }

  private static int compared(Code left, Code right, Frame frame) {
    try {
      return ((Num) left.of(frame)).compareTo((Num) right.of(frame));
    } catch (ArithmeticException e) {
      throw new Beyond(); // more than 18 digits
    }
  }

  private static Code arithmetic(Code left, Code right, BinaryOperator<Num> operator) {
    return frame -> {
      try {
        return operator.apply((Num) left.of(frame), (Num) right.of(frame));
      } catch (ArithmeticException e) {
        throw new Beyond(); // more than 18 digits
      }
    };
  }

  private Code nth(Pos pos, Code of, Code number) {
    partial = true;
    return frame -> {
      Row list = (Row) of.of(frame);
      Num n = (Num) number.of(frame);
      if (n.compareTo(Num.of(list.size())) >= 0 || n.compareTo(Num.of(0)) < 0) {
        throw error(pos, "the list has %d elements, and none at %s".formatted(list.size(), n));
      }
      return list.get((int) n.over());
    };
  }

  private Code lessBy(Expr.Binary at, Code left, Code right) {
    Code real = arithmetic(left, right, (a, b) -> a.plus(b.negative()));
    if (Type.isNumber(at.type(), Type.Num::hasNegative)) {
      return real;
    }
    partial = true;
    return frame -> {
      Num value = (Num) real.of(frame);
      if (value.compareTo(Num.of(0)) < 0) {
        throw error(
            at.pos(),
            "%s - %s is below 0; expected a value of %s"
                .formatted(left.of(frame), right.of(frame), at.type()));
      }
      return value;
    };
  }

  private Code dividedBy(Expr.Binary at, Code left, Code right) {
    Code quotient = arithmetic(left, right, Num::dividedBy);
    partial = true;
    return frame -> {
      if (right.of(frame).equals(Num.of(0))) {
        throw error(at.pos(), "a division by 0");
      }
      return quotient.of(frame);
    };
  }

  private Num positive(Expr.Binary at, Num by) {
    if (by.compareTo(Num.of(0)) <= 0) {
      throw error(at.pos(), "a remainder by " + by + "; expected a number above 0");
    }
    return by;
  }

  private Body body(String name) {
    Body known = bodies.get(name);
    if (known != null) {
      return known;
    }
    Function function = automaton.function(name).orElseThrow(() -> new IllegalStateException(name));
    Body body = new Body();
    bodies.put(name, body);
    Scope scope = new Scope();
    scope.push(function.signature().parameters());
    boolean before = partial;
    partial = false;
    body.code = code(function.body(), scope);
    body.locals = scope.most;
    body.partial = partial;
    partial = before;
    return body;
  }
}
