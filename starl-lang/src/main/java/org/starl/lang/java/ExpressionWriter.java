// Longer than 500 lines because each kind of expression has one method here, and all share what is
// bound.
package org.starl.lang.java;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Expr.Operator;
import org.starl.lang.tree.Exprs;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/** Makes Java of expressions. */
final class ExpressionWriter {

  private static final BigDecimal MOST_INT = BigDecimal.valueOf(Integer.MAX_VALUE);

  private final Automaton automaton;
  private final JavaTypes types;
  private final Inlining inlining;
  // "s", or empty in a method of the state itself
  private final String state;
  // of the source, for places in messages
  private final String file;
  private final Function<Expr, @Nullable Code> own;
  private final Map<String, Code> variables = new LinkedHashMap<>();
  // Those of lambdas, whose numbers are objects; those of parameters are not.
  private final Set<String> boxed = new TreeSet<>();
  // Variables that have none of the values that the condition distinguishes.
  private final Set<String> elsewhere = new TreeSet<>();
  private final Finite finite;
  // Whether an operation without a value is told with its place.
  private boolean tells = true;

  /**
   * @param state the variable that has the state; empty in a method of the state
   * @param file the name of the source
   */
  ExpressionWriter(Automaton automaton, JavaTypes types, String state, String file) {
    this(automaton, types, state, file, at -> null);
  }

  /**
   * Of a program.
   *
   * @param file the name of the source
   * @param own the Java of what only programs have; null for all else
   */
  ExpressionWriter(
      Automaton around, JavaTypes types, String file, Function<Expr, @Nullable Code> own) {
    this(around, types, "", file, own);
  }

  private ExpressionWriter(
      Automaton automaton,
      JavaTypes types,
      String state,
      String file,
      Function<Expr, @Nullable Code> own) {
    this.automaton = automaton;
    this.types = types;
    this.state = state;
    this.file = file;
    this.own = own;
    inlining = new Inlining(automaton);
    finite = new Finite(this);
  }

  Inlining inlining() {
    return inlining;
  }

  Finite finite() {
    return finite;
  }

  /** Whether a called function can be read as its body. */
  boolean canInline(Expr.Call at) {
    Automaton owner = at.used().isEmpty() ? automaton : Functions.used(automaton, at.used());
    return owner.function(at.function().name()).stream().noneMatch(f -> f.measure().isPresent());
  }

  JavaTypes types() {
    return types;
  }

  /** Makes a variable known. */
  void bind(String variable, Code value) {
    variables.put(variable, value);
  }

  /** Evaluates {@code code} with {@code variable} bound to a variable of Java of its name. */
  <T> T under(Field variable, Supplier<T> code) {
    Code before = variables.put(variable.name(), Code.name(JavaTypes.variable(variable.name())));
    boolean isNew = boxed.add(variable.name());
    try {
      return code.get();
    } finally {
      if (isNew) {
        boxed.remove(variable.name());
      }
      if (before == null) {
        variables.remove(variable.name());
      } else {
        variables.put(variable.name(), before);
      }
    }
  }

  /** Evaluates {@code code} for a value of {@code variable} unlike all that occur. */
  <T> T elsewhere(Field variable, Supplier<T> code) {
    elsewhere.add(variable.name());
    try {
      return code.get();
    } finally {
      elsewhere.remove(variable.name());
    }
  }

  /**
   * What {@code code} writes evaluates as far as Java does, without asking whether there is a value: it
   * is looked at where the source may not evaluate it, for a message.
   */
  <T> T untold(Supplier<T> code) {
    boolean before = tells;
    tells = false;
    try {
      return code.get();
    } finally {
      tells = before;
    }
  }

  /** Whether {@code at}, or a function that it calls, has no value for some arguments. */
  boolean isPartial(Expr at) {
    return Functions.isPartial(automaton, at);
  }

  /** A call of a method of {@code Undefined}. */
  Code told(String method, Pos pos, Code... arguments) {
    List<Code> all = new ArrayList<>(List.of(Code.string(file + ":" + pos)));
    all.addAll(List.of(arguments));
    String undefined = types.use("org.starl.spec.automaton.Undefined");
    return Code.call(undefined + "." + method, all.toArray(Code[]::new));
  }

  private boolean isElsewhere(Expr at) {
    return at instanceof Expr.Variable v && elsewhere.contains(v.name());
  }

  private boolean mentionsElsewhere(Expr at) {
    return elsewhere.stream().anyMatch(variable -> Exprs.mentions(at, variable));
  }

  Code of(Expr at) {
    Code known = own.apply(at);
    return known != null ? known : usual(at);
  }

  private Code usual(Expr at) {
    return switch (at) {
      case Expr.Bool e -> e.value() ? Code.Text.TRUE : Code.Text.FALSE;
      case Expr.Numeral e -> Code.name(e.value().toPlainString() + (isNatural(e) ? "L" : ""));
      case Expr.Variable e -> variable(e);
      case Expr.Parameter e when e.type().base() instanceof Type.MapOf ->
          throw new NotExecutable(
              e.pos(), "'" + e.name() + "' is a method in Java; expected arguments after it");
      case Expr.Parameter e -> Code.name(JavaTypes.name(e.name()));
      case Expr.Component e -> component(e.name());
      case Expr.At e -> apply(e);
      case Expr.Call e -> called(e);
      case Expr.Get e -> get(e);
      case Expr.Make e ->
          types.make(
              (Type.Sum) e.type().base(), e.constructor().name(), all(e.arguments()), e.pos());
      case Expr.MakeRecord e -> new Code.New(types.of(e.type(), e.pos()), all(e.values()));
      case Expr.Is e -> is(of(e.of()), (Type.Sum) e.of().type().base(), e.constructor(), e.pos());
      case Expr.Match e -> Choices.of(e, this, this::of);
      case Expr.Not e -> Code.not(of(e.of()));
      case Expr.Negative e -> new Code.Prefix("-", Code.strong(of(e.of()), Code.PRIMARY));
      case Expr.Binary e -> binary(e);
      case Expr.Quantified e -> finite.quantified(e);
      case Expr.If e -> Code.choice(of(e.condition()), of(e.then()), of(e.otherwise()));
      case Expr.SuchThat e -> finite.set(e);
      case Expr.SetOf e -> set(e);
      case Expr.MapOf e -> finite.map(e);
      case Expr.ListOf e ->
          Code.call(types.use("java.util.List") + ".of", all(e.elements()).toArray(Code[]::new));
      case Expr.None e -> types.bottom();
      case Expr.Some e ->
          new Code.New(types.use("org.starl.spec.automaton.Lift") + ".up<>", List.of(of(e.of())));
      case Expr.BuiltIn e -> builtIn(e);
      case Expr.Enabled e ->
          mentionsElsewhere(e) ? of(inlining.condition(e)) : enabled(e).then("isTrue");
      case Expr.Started e ->
          throw new NotExecutable(e.pos(), "'start?' has a Java form only after 'start'");
    };
  }

  /** Whether the used automaton can be asked: it depends on no variable of which nothing is known. */
  boolean canAsk(Expr.Enabled at) {
    return !mentionsElsewhere(at);
  }

  /** Whether, and why not, the step of a used automaton may happen. */
  Code enabled(Expr.Enabled at) {
    return Code.name(machine(at.used()))
        .then("enabled", step(at.automaton(), at.action(), at.arguments()), component(at.used()));
  }

  /** An action of a used automaton. */
  Code step(Automaton used, Action action, List<Expr> arguments) {
    return new Code.New(types.action(used, action.name()), all(arguments));
  }

  /** The field that has the automaton of this component. */
  static String machine(String component) {
    return JavaTypes.name(component) + Names.SUFFIX;
  }

  private List<Code> all(List<Expr> parts) {
    return parts.stream().map(this::of).toList();
  }

  private static boolean isNatural(Expr e) {
    return e.type().base() == Type.Num.NAT;
  }

  private Code variable(Expr.Variable at) {
    if (elsewhere.contains(at.name())) {
      throw new NotExecutable(
          at.pos(),
          "the values of '"
              + at.name()
              + "' that matter here are not known to be finitely many; expected "
              + at.name()
              + " to be compared, looked up in a set, or the argument of a map");
    }
    Code value = variables.get(at.name());
    if (value == null) {
      throw new NotExecutable(
          at.pos(), "'" + at.name() + "' varies here; expected values that do not depend on it");
    }
    return value;
  }

  Code component(String name) {
    String plain = JavaTypes.name(name);
    return state.isEmpty() ? Code.name(plain) : Code.name(state).field(plain);
  }

  private Code apply(Expr.At at) {
    if (at.map() instanceof Expr.Parameter given) {
      boolean isCondition =
          given.type().base() instanceof Type.MapOf map && map.result() == Type.Bool.BOOL;
      Code known = own.apply(given);
      return (known == null ? Code.name(JavaTypes.name(given.name())) : known)
          .then(isCondition ? "test" : "apply", all(at.arguments()).toArray(Code[]::new));
    }
    if (at.arguments().stream().anyMatch(this::isElsewhere)
        && StartState.isOwnForEach(automaton, types, at.map())) {
      throw ownForEach(at.pos());
    }
    Code value = of(at.map());
    for (Expr argument : at.arguments()) {
      value = isElsewhere(argument) ? value.then("defaultValue") : value.then("at", of(argument));
    }
    return value;
  }

  private static NotExecutable ownForEach(Pos pos) {
    return new NotExecutable(
        pos,
        "each argument has a value of its own at the start; expected a condition on finitely many"
            + " arguments, such as 'i in S =>'");
  }

  private Code called(Expr.Call at) {
    if (mentionsElsewhere(at)) {
      return of(inlining.body(at));
    }
    if (!at.used().isEmpty()) {
      return calledInUsed(at, Functions.used(automaton, at.used()));
    }
    List<Code> arguments = new ArrayList<>(all(at.arguments()));
    String name = JavaTypes.function(at.function().name());
    if (!at.function().readsState()) {
      return Code.call(name, arguments.toArray(Code[]::new));
    }
    if (Functions.needsParameters(automaton, at.function().name())) {
      arguments.add(Code.name(state));
      return Code.call(name, arguments.toArray(Code[]::new));
    }
    return state.isEmpty()
        ? Code.call(name, arguments.toArray(Code[]::new))
        : Code.name(state).then(name, arguments.toArray(Code[]::new));
  }

  private Code calledInUsed(Expr.Call at, Automaton used) {
    if (!Functions.isWritten(used, at.function().name())) {
      return of(inlining.body(at));
    }
    List<Code> arguments = new ArrayList<>(all(at.arguments()));
    String name = JavaTypes.function(at.function().name());
    Code of = component(at.used());
    if (Functions.needsParameters(used, at.function().name())) {
      if (at.function().readsState()) {
        arguments.add(of);
      }
      of = Code.name(machine(at.used()));
    } else if (!at.function().readsState()) {
      of = Code.name(types.automaton(used));
    }
    return of.then(name, arguments.toArray(Code[]::new));
  }

  private Code get(Expr.Get at) {
    Code of = of(at.of());
    if (at.of().type().base() instanceof Type.Sum sum) {
      String constructor =
          sum.constructors().stream()
              .filter(c -> c.fields().stream().anyMatch(f -> f.name().equals(at.field())))
              .findFirst()
              .orElseThrow()
              .name();
      String form = types.of(sum, at.pos()) + "." + JavaTypes.form(sum, constructor);
      of =
          tells && sum.constructors().size() > 1
              ? told("form", at.pos(), Code.string(at.field()), Code.name(form + ".class"), of)
              : new Code.Prefix("(" + form + ") ", of);
    }
    return of.then(JavaTypes.name(at.field()));
  }

  Code is(Code of, Type.Sum sum, Type.Constructor constructor, Pos pos) {
    String type = types.of(sum, pos);
    String name = JavaTypes.form(sum, constructor.name());
    return sum.isEnum()
        ? Code.infix("==", of, Code.name(type).field(name))
        : new Code.InstanceOf(of, type + "." + name);
  }

  private Code set(Expr.SetOf at) {
    JavaTypes.Sets form = types.form(at.type());
    if (form == JavaTypes.Sets.OWN) {
      if (at.elements().isEmpty()) {
        return types.any(at.type(), at.pos());
      }
      throw new NotExecutable(
          at.pos(), "a " + at.type() + " has a Java type of its own; expected no elements here");
    }
    if (form == JavaTypes.Sets.FUN) {
      return at.elements().isEmpty() ? types.always(Code.Text.FALSE) : finite.set(asCondition(at));
    }
    String sets = types.use("org.starl.spec.automaton.Sets");
    if (at.elements().isEmpty()) {
      return types.emptyset();
    }
    Code set = Code.call(sets + ".singleton", of(at.elements().getFirst()));
    for (Expr more : at.elements().subList(1, at.elements().size())) {
      set = Code.call(sets + ".add", of(more), set);
    }
    return set;
  }

  private Code builtIn(Expr.BuiltIn at) {
    Code of = of(at.of());
    return switch (at.name()) {
      case THE -> tells ? told("the", at.pos(), of) : of.then("get");
      case HEAD -> tells ? told("head", at.pos(), of) : of.then("get", Code.name("0"));
      case TAIL ->
          tells ? told("tail", at.pos(), of) : of.then("subList", Code.name("1"), of.then("size"));
      case CARD -> {
        requireFinite(at, "card");
        yield new Code.Prefix("(long) ", of.then("size"));
      }
      case CHOOSE -> {
        requireFinite(at, "choose");
        yield tells ? told("choose", at.pos(), of) : of.then("first");
      }
      case WITHIN -> {
        Type.Range range = (Type.Range) at.type().base();
        Code low = JavaTypes.bound(range.low());
        Code high = JavaTypes.bound(range.high());
        yield tells ? told("within", at.pos(), low, high, of) : of;
      }
      case LENGTH -> new Code.Prefix("(long) ", of.then("size"));
      case ELEMENTS -> Code.call(types.use("org.starl.spec.automaton.Sets") + ".of", of);
      case DISTINCT ->
          Code.infix(
              "==",
              Code.call(types.use("org.starl.spec.automaton.Sets") + ".of", of).then("size"),
              of.then("size"));
    };
  }

  private void requireFinite(Expr.BuiltIn at, String word) {
    if (types.form(at.of().type()) != JavaTypes.Sets.FINITE) {
      throw new NotExecutable(
          at.pos(),
          "a %s may be infinite in Java; expected no '%s' of it".formatted(at.of().type(), word));
    }
  }

  private Code binary(Expr.Binary at) {
    return switch (at.operator()) {
      case AND -> Code.and(of(at.left()), of(at.right()));
      case OR -> Code.or(of(at.left()), of(at.right()));
      case IMPLIES -> Code.or(Code.not(of(at.left())), of(at.right()));
      case IFF, EQUAL -> equal(at.left(), at.right());
      case UNEQUAL -> Code.not(equal(at.left(), at.right()));
      case LESS, AT_MOST, GREATER, AT_LEAST ->
          Code.infix(at.operator().text(), number(at.left()), number(at.right()));
      case PLUS, LESS_BY, TIMES -> arithmetic(at);
      case DIVIDED_BY -> {
        if (types.of(at.type(), at.pos()).equals("long")) {
          throw new NotExecutable(
              at.pos(), "quotients need java " + at.type() + " = \"double\"; it is \"long\"");
        }
        yield arithmetic(at);
      }
      case MOD -> {
        Code of = of(at.left());
        Code by = of(at.right());
        yield tells ? told("remainder", at.pos(), of, by) : Code.call("Math.floorMod", of, by);
      }
      case IN -> in(at.left(), at.right());
      case SUBSET, DISJOINT, UNION, MINUS, INTERSECT -> sets(at);
      case JOIN ->
          Code.call(
              types.use("org.starl.spec.automaton.Sets") + ".append",
              of(at.left()),
              of(at.right()));
      case NTH -> {
        Code list = of(at.left());
        Code n = of(at.right());
        yield tells
            ? told("nth", at.pos(), list, n)
            : list.then("get", Code.call("Math.toIntExact", n)); // of an object, too
      }
    };
  }

  private Code arithmetic(Expr.Binary at) {
    boolean isOfLiterals = at.left() instanceof Expr.Numeral && at.right() instanceof Expr.Numeral;
    Code left = isOfLiterals ? of(at.left()) : number(at.left());
    Code right = number(at.right());
    if (tells && at.operator() == Operator.DIVIDED_BY) {
      return told("quotient", at.pos(), left, right);
    }
    return tells
            && at.operator() == Operator.LESS_BY
            && !Type.isNumber(at.type(), Type.Num::hasNegative)
        ? told("difference", at.pos(), left, right)
        : Code.infix(at.operator().text(), left, right);
  }

  /** An {@code int} needs no suffix beside an operator, unless both sides are literals. */
  private Code number(Expr at) {
    boolean isInt = at instanceof Expr.Numeral e && e.value().compareTo(MOST_INT) <= 0;
    return isInt ? Code.name(((Expr.Numeral) at).value().toPlainString()) : of(at);
  }

  private Code equal(Expr left, Expr right) {
    if (isElsewhere(left) && isElsewhere(right)) {
      return sameElsewhere((Expr.Variable) left, (Expr.Variable) right);
    }
    if (isElsewhere(left) || isElsewhere(right)) {
      return Code.Text.FALSE;
    }
    if (isEmpty(left) || isEmpty(right)) {
      Expr other = isEmpty(left) ? right : left;
      boolean isFun =
          other.type().base() instanceof Type.SetOf
              && types.form(other.type()) != JavaTypes.Sets.FINITE;
      if (!isFun) {
        return of(other).then("isEmpty");
      }
    }
    if (left instanceof Expr.None || right instanceof Expr.None) {
      return Code.not(of(left instanceof Expr.None ? right : left).then("isUp"));
    }
    if (isPrimitive(left.type())) {
      if (left instanceof Expr.Bool || right instanceof Expr.Bool) {
        Code other = of(left instanceof Expr.Bool ? right : left);
        boolean isTrue = (left instanceof Expr.Bool a ? a : (Expr.Bool) right).value();
        return isTrue ? other : Code.not(other);
      }
      if (!isBoxed(left) || !isBoxed(right)) {
        return Code.infix("==", number(left), number(right));
      }
      if (!isObject(left)) {
        return Code.call(types.use("java.util.Objects") + ".equals", of(left), of(right));
      }
      return of(left).then("equals", of(right));
    }
    if (left.type().base() instanceof Type.Sum sum && sum.isEnum()) {
      return Code.infix("==", of(left), of(right));
    }
    // Such a map is equal to itself alone.
    if (StartState.isOwnForEach(automaton, types, left)
        || StartState.isOwnForEach(automaton, types, right)) {
      throw ownForEach(left.pos());
    }
    return of(left).then("equals", of(right));
  }

  private Code sameElsewhere(Expr.Variable left, Expr.Variable right) {
    if (left.name().equals(right.name())) {
      return Code.Text.TRUE;
    }
    throw new NotExecutable(
        left.pos(),
        "'" + left.name() + "' and '" + right.name() + "' both have infinitely many values here");
  }

  private static boolean isEmpty(Expr at) {
    return (at instanceof Expr.SetOf set && set.elements().isEmpty())
        || (at instanceof Expr.ListOf list && list.elements().isEmpty());
  }

  private static boolean isPrimitive(Type type) {
    return type.base() instanceof Type.Bool || Type.plain(type).base() instanceof Type.Num;
  }

  /** Whether its Java value may be an object, so that {@code ==} may compare two references. */
  private boolean isBoxed(Expr at) {
    return own.apply(at) != null
        || !(at instanceof Expr.Numeral
            || (at instanceof Expr.Binary of && of.operator() != Operator.NTH)
            || (at instanceof Expr.Variable of && !boxed.contains(of.name()))
            || at instanceof Expr.Component
            || at instanceof Expr.Call
            || at instanceof Expr.Get);
  }

  /** Whether it is certainly no primitive value: a variable may be one. */
  private boolean isObject(Expr at) {
    return own.apply(at) != null
        || at instanceof Expr.At
        || (at instanceof Expr.Binary b && b.operator() == Operator.NTH)
        || (at instanceof Expr.BuiltIn of
            && (of.name() == Expr.BuiltIn.Name.THE || of.name() == Expr.BuiltIn.Name.HEAD));
  }

  private Code in(Expr element, Expr set) {
    if (set instanceof Expr.SetOf literal) {
      Code any = Code.Text.FALSE;
      for (Expr each : literal.elements()) {
        any = Code.or(any, equal(element, each));
      }
      return any;
    }
    if (isElsewhere(element)) {
      return switch (types.form(set.type())) {
        case FINITE -> Code.Text.FALSE;
        case FUN -> of(set).then("defaultValue");
        case OWN -> variable((Expr.Variable) element);
      };
    }
    return of(set)
        .then(types.form(set.type()) == JavaTypes.Sets.FUN ? "at" : "contains", of(element));
  }

  private Code sets(Expr.Binary at) {
    return switch (types.form(at.left().type())) {
      case FINITE -> finiteSets(at);
      case FUN -> funs(at);
      case OWN ->
          throw new NotExecutable(
              at.pos(),
              "a " + at.left().type() + " has a Java type of its own; expected 'in' alone");
    };
  }

  private Code finiteSets(Expr.Binary at) {
    String sets = types.use("org.starl.spec.automaton.Sets");
    boolean isOne = at.right() instanceof Expr.SetOf right && right.elements().size() == 1;
    if (isOne && (at.operator() == Operator.UNION || at.operator() == Operator.MINUS)) {
      Expr element = ((Expr.SetOf) at.right()).elements().getFirst();
      String function = at.operator() == Operator.UNION ? ".add" : ".remove";
      return Code.call(sets + function, of(element), of(at.left()));
    }
    Code left = of(at.left());
    Code right = of(at.right());
    return switch (at.operator()) {
      case SUBSET -> right.then("containsAll", left);
      case DISJOINT -> Code.call(sets + ".disjoint", left, right);
      case UNION -> Code.call(sets + ".union", left, right);
      case MINUS -> Code.call(sets + ".difference", left, right);
      default -> Code.call(sets + ".intersection", left, right);
    };
  }

  private Code funs(Expr.Binary at) {
    boolean isOne = at.right() instanceof Expr.SetOf right && right.elements().size() == 1;
    if (isOne && (at.operator() == Operator.UNION || at.operator() == Operator.MINUS)) {
      Expr element = ((Expr.SetOf) at.right()).elements().getFirst();
      boolean isIn = at.operator() == Operator.UNION;
      return of(at.left()).then("with", of(element), isIn ? Code.Text.TRUE : Code.Text.FALSE);
    }
    return switch (at.operator()) {
      case SUBSET, DISJOINT ->
          of(new Expr.Quantified(true, List.of(element(at)), condition(at), at.pos()));
      default -> finite.set(asCondition(at));
    };
  }

  private static Field element(Expr set) {
    Type type = set instanceof Expr.Binary both ? both.left().type() : set.type();
    return new Field("element_", ((Type.SetOf) type.base()).element());
  }

  /** A set as {@code {x | ...}}. */
  private static Expr.SuchThat asCondition(Expr set) {
    return new Expr.SuchThat(element(set), condition(set), set.type(), set.pos());
  }

  /** Of the elements of a set, or, of {@code subset} and {@code disjoint}, of all values. */
  private static Expr condition(Expr set) {
    Expr x = new Expr.Variable("element_", element(set).type(), set.pos());
    if (set instanceof Expr.SetOf literal) {
      Expr any = new Expr.Bool(false, set.pos());
      for (Expr each : literal.elements()) {
        any = both(Operator.OR, any, both(Operator.EQUAL, x, each));
      }
      return any;
    }
    Expr.Binary at = (Expr.Binary) set;
    Expr left = both(Operator.IN, x, at.left());
    Expr right = both(Operator.IN, x, at.right());
    Expr notRight = new Expr.Not(right, at.pos());
    return switch (at.operator()) {
      case SUBSET -> both(Operator.IMPLIES, left, right);
      case DISJOINT -> both(Operator.IMPLIES, left, notRight);
      case UNION -> both(Operator.OR, left, right);
      case MINUS -> both(Operator.AND, left, notRight);
      default -> both(Operator.AND, left, right);
    };
  }

  private static Expr both(Operator operator, Expr left, Expr right) {
    return new Expr.Binary(operator, left, right, Type.Bool.BOOL, left.pos());
  }
}
