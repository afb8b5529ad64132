package org.starl.lang.pvs;

import static org.starl.lang.pvs.Doc.Space.LINE;
import static org.starl.lang.pvs.Doc.Space.SOFT;
import static org.starl.lang.pvs.Doc.group;
import static org.starl.lang.pvs.Doc.join;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.starl.lang.tree.Action.Effect;
import org.starl.lang.tree.Action.Selector;
import org.starl.lang.tree.Bound;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Expr.Binary;
import org.starl.lang.tree.Expr.Operator;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/** Types, expressions and effects in PVS. Parentheses stand where PVS or a reader needs them. */
final class PvsExpr {

  // How tightly the operators of PVS bind.
  private static final int IFF = 1;
  private static final int IMPLIES = 2;
  private static final int OR = 3;
  private static final int AND = 4;
  private static final int NOT = 5;
  private static final int COMPARISON = 6;
  private static final int SUM = 7;
  private static final int PRODUCT = 8;
  private static final int MINUS = 9;
  private static final int ATOM = 10;

  private final PvsNames names;
  private final String own;

  PvsExpr(PvsNames names) {
    this(names, "");
  }

  /** @param own of types of other automata, forms are named with their theory; empty: they are not */
  PvsExpr(PvsNames names, String own) {
    this.names = names;
    this.own = own;
  }

  /** A type where it is used. */
  static String type(Type type) {
    return switch (type) {
      case Type.Bool bool -> "bool";
      case Type.Num.TIME -> "nonneg_real";
      case Type.Num number -> number.toString();
      case Type.Range range -> "subrange(" + bound(range.low()) + ", " + bound(range.high()) + ")";
      case Type.SetOf set -> "set[" + type(set.element()) + "]";
      case Type.ListOf list -> "list[" + type(list.element()) + "]";
      case Type.OptionOf option -> "lift[" + type(option.element()) + "]";
      case Type.MapOf map -> "[" + types(map.arguments()) + " -> " + type(map.result()) + "]";
      case Type.StateOf state -> PvsNames.id(state.automaton().name()) + ".states";
      case Type.Opaque named -> PvsNames.id(named.name());
      case Type.Alias named -> PvsNames.id(named.name());
      case Type.Rec named -> PvsNames.id(named.name());
      case Type.Sum named -> PvsNames.id(named.name());
    };
  }

  /** PVS 8.0 fails on a negative numeral in the type of an action's parameter. */
  private static String bound(Bound of) {
    return of.text("0 - ", PvsNames::id, "");
  }

  /** That a range has a value. */
  static String nonEmpty(Type.Range range) {
    return bound(range.low()) + " <= " + bound(range.high());
  }

  private static String types(List<Type> types) {
    return types.stream().map(PvsExpr::type).collect(Collectors.joining(", "));
  }

  /** {@code i: PIDS, z: Zones}. */
  static String fields(List<Field> fields) {
    return fields.stream()
        .map(field -> PvsNames.variable(field.name()) + ": " + type(field.type()))
        .collect(Collectors.joining(", "));
  }

  /** The same of a record. */
  static String components(List<Field> fields) {
    return fields.stream()
        .map(field -> PvsNames.field(field.name()) + ": " + type(field.type()))
        .collect(Collectors.joining(", "));
  }

  /** An expression that stands alone. */
  Doc of(Expr expr) {
    return of(expr, 0, true);
  }

  /** Conditions that all hold. */
  Doc all(List<Expr> conditions) {
    if (conditions.isEmpty()) {
      return Doc.of("TRUE");
    }
    return conditions.size() == 1 ? of(conditions.getFirst()) : chain("AND", conditions, true);
  }

  /** What an effect writes: {@code `req_set(i) := emptyset}. */
  Doc effect(Effect effect) {
    return switch (effect) {
      case Effect.Assign assign -> {
        List<Object> place = new ArrayList<>(List.of("`" + PvsNames.field(assign.component())));
        for (Selector selector : assign.selectors()) {
          switch (selector) {
            case Selector.At at -> place.add(arguments(at.arguments()));
            case Selector.Of of -> place.add("`" + PvsNames.field(of.field()));
          }
        }
        place.addAll(List.of(" := ", of(assign.value())));
        yield group(2, place.toArray());
      }
      case Effect.Step step -> {
        Doc after =
            group(
                2,
                PvsNames.id(step.automaton().name()) + ".trans(",
                call(PvsNames.id(step.action().name()), step.arguments()),
                ",",
                SOFT,
                state(step.used()) + ")");
        String place = "`" + PvsNames.field(step.used()) + " := ";
        yield step.condition().isEmpty()
            ? group(2, place, after)
            : group(
                4,
                place,
                group(2, "IF ", of(step.condition().get()), " THEN", LINE, after),
                LINE,
                "ELSE " + state(step.used()) + " ENDIF");
      }
    };
  }

  /**
   * @param level how tightly the operator around it binds
   * @param isLast whether nothing follows that a quantifier would include
   */
  private Doc of(Expr expr, int level, boolean isLast) {
    if (level(expr) < level || (level(expr) == 0 && !isLast)) {
      return Doc.of("(", new Doc.Nest(1, bare(expr, true)), ")");
    }
    return bare(expr, isLast);
  }

  private Doc atom(Expr expr) {
    return of(expr, ATOM, false);
  }

  /** How tightly the operator of {@code expr} binds; 0 if it extends as far as it can. */
  private static int level(Expr expr) {
    return switch (expr) {
      case Expr.Quantified of -> 0;
      case Expr.MapOf of -> 0;
      case Expr.Not of -> NOT;
      case Expr.Negative of -> MINUS;
      case Binary of -> level(of);
      case Expr.BuiltIn of when of.name() == Expr.BuiltIn.Name.WITHIN -> level(of.of());
      default -> ATOM;
    };
  }

  private static int level(Binary binary) {
    return switch (binary.operator()) {
      case IFF -> IFF;
      case IMPLIES -> IMPLIES;
      case OR -> OR;
      case AND -> AND;
      case UNEQUAL -> isEmptyTest(binary) ? ATOM : NOT;
      case EQUAL -> isEmptyTest(binary) ? ATOM : COMPARISON;
      case LESS, AT_MOST, GREATER, AT_LEAST -> COMPARISON;
      case PLUS, LESS_BY -> SUM;
      case TIMES, DIVIDED_BY -> PRODUCT;
      case IN, SUBSET, DISJOINT, UNION, MINUS, INTERSECT, JOIN, NTH, MOD -> ATOM;
    };
  }

  private Doc bare(Expr expr, boolean isLast) {
    return switch (expr) {
      case Expr.Bool of -> Doc.of(of.value() ? "TRUE" : "FALSE");
      case Expr.Numeral of -> Doc.of(of.value().toPlainString());
      case Expr.Variable of -> Doc.of(PvsNames.variable(of.name()));
      case Expr.Parameter of -> Doc.of(PvsNames.id(of.name()));
      case Expr.Component of -> Doc.of(state(of.name()));
      case Expr.At of -> Doc.of(atom(of.map()), arguments(of.arguments()));
      case Expr.Call of -> call(of);
      case Expr.Enabled of ->
          group(
              2,
              PvsNames.id(of.automaton().name()) + ".enabled(",
              call(PvsNames.id(of.action().name()), of.arguments()),
              ",",
              SOFT,
              state(of.used()) + ")");
      case Expr.Started of ->
          Doc.of(PvsNames.id(of.automaton().name()) + ".start(" + state(of.used()) + ")");
      case Expr.Get of -> get(of);
      case Expr.Make of -> call(form(of), of.arguments());
      case Expr.MakeRecord of -> record(of);
      case Expr.Is of -> Doc.of(PvsNames.id(of.constructor().name()) + "?(", of(of.of()), ")");
      case Expr.Match of -> match(of);
      case Expr.Not of -> Doc.of("NOT ", of(of.of(), NOT, isLast));
      case Expr.Negative of -> Doc.of("-", of(of.of(), MINUS, isLast));
      case Binary of -> binary(of, isLast);
      case Expr.Quantified of ->
          group(
              2,
              (of.forAll() ? "FORALL " : "EXISTS ") + names.binders(of.variables()) + ":",
              LINE,
              of(of.body()));
      case Expr.MapOf of ->
          group(2, "LAMBDA " + names.binders(of.variables()) + ":", LINE, of(of.body()));
      case Expr.If of -> conditional(of);
      case Expr.SuchThat of ->
          group(2, "{" + names.bound(of.variable()) + " |", SOFT, of(of.body()), "}");
      case Expr.SetOf of -> set(of.elements());
      case Expr.ListOf of -> list(of.elements());
      case Expr.None of -> Doc.of("bottom");
      case Expr.Some of -> Doc.of("up(", of(of.of()), ")");
      case Expr.BuiltIn of when of.name() == Expr.BuiltIn.Name.WITHIN -> bare(of.of(), isLast);
      case Expr.BuiltIn of -> Doc.of(builtIn(of), "(", of(of.of()), ")");
    };
  }

  private String form(Expr.Make made) {
    String owner = ((Type.Sum) made.type().base()).owner();
    String name = PvsNames.id(made.constructor().name());
    return own.isEmpty() || own.equals(owner) ? name : PvsNames.id(owner) + "." + name;
  }

  /** A component of the state. */
  private static String state(String component) {
    return "s`" + PvsNames.field(component);
  }

  private Doc arguments(List<Expr> arguments) {
    List<Doc> all = arguments.stream().map(this::of).toList();
    return group(2, "(", join(all, ",", SOFT), ")");
  }

  Doc call(String name, List<Expr> arguments) {
    return arguments.isEmpty() ? Doc.of(name) : Doc.of(name, arguments(arguments));
  }

  private Doc call(Expr.Call call) {
    List<Doc> arguments = new ArrayList<>(call.arguments().stream().map(this::of).toList());
    if (call.function().readsState()) {
      arguments.add(Doc.of(call.used().isEmpty() ? "s" : state(call.used())));
    }
    String name = names.function(call);
    return arguments.isEmpty()
        ? Doc.of(name)
        : group(2, name, "(", join(arguments, ",", SOFT), ")");
  }

  /** A field of a record is selected; that of a constructor's value has a function of its name. */
  private Doc get(Expr.Get get) {
    return get.of().type().base() instanceof Type.Sum
        ? Doc.of(PvsNames.variable(get.field()) + "(", of(get.of()), ")")
        : Doc.of(atom(get.of()), "`" + PvsNames.field(get.field()));
  }

  private Doc record(Expr.MakeRecord made) {
    Type.Rec type = (Type.Rec) made.type().base();
    List<Doc> all = new ArrayList<>();
    for (int i = 0; i < made.values().size(); i++) {
      all.add(
          Doc.of(PvsNames.field(type.fields().get(i).name()) + " := ", of(made.values().get(i))));
    }
    return group(3, "(# ", join(all, ",", SOFT), " #)");
  }

  private Doc match(Expr.Match match) {
    List<Doc> cases = new ArrayList<>();
    for (Expr.Case each : match.cases()) {
      cases.add(
          group(2, pattern(each.constructor().name(), each.variables()), SOFT, of(each.value())));
    }
    return new Doc.Group(
        Doc.of(
            "CASES ",
            of(match.of()),
            " OF",
            new Doc.Nest(2, Doc.of(LINE, join(cases, ",", LINE))),
            LINE,
            "ENDCASES"));
  }

  /** {@code failed(M):}, where a case begins. */
  static String pattern(String constructor, List<Field> variables) {
    String head = PvsNames.id(constructor);
    return variables.isEmpty()
        ? head + ":"
        : head
            + variables.stream()
                .map(field -> PvsNames.variable(field.name()))
                .collect(Collectors.joining(", ", "(", "):"));
  }

  private Doc conditional(Expr.If first) {
    List<Object> parts = new ArrayList<>();
    String word = "IF ";
    Expr rest = first;
    while (rest instanceof Expr.If next) {
      parts.add(group(2, word, of(next.condition()), " THEN", LINE, of(next.then())));
      parts.add(LINE);
      word = "ELSIF ";
      rest = next.otherwise();
    }
    parts.addAll(List.of(group(2, "ELSE", LINE, of(rest)), LINE, "ENDIF"));
    return new Doc.Group(Doc.of(parts.toArray()));
  }

  private Doc set(List<Expr> elements) {
    if (elements.isEmpty()) {
      return Doc.of("emptyset");
    }
    Doc set = Doc.of("singleton(", of(elements.getLast()), ")");
    for (Expr element : elements.reversed().subList(1, elements.size())) {
      set = Doc.of("add(", of(element), ", ", set, ")");
    }
    return set;
  }

  private Doc list(List<Expr> elements) {
    return elements.isEmpty()
        ? Doc.of("null")
        : group(3, "(: ", join(elements.stream().map(this::of).toList(), ",", SOFT), " :)");
  }

  private static String builtIn(Expr.BuiltIn of) {
    return switch (of.name()) {
      case THE -> "down";
      case HEAD -> "car";
      case TAIL -> "cdr";
      case LENGTH -> "length";
      case CARD -> "card";
      case ELEMENTS -> "list2set";
      case DISTINCT -> "distinct?";
      case WITHIN -> throw new IllegalStateException(of.toString());
      // A source may have a function or action of this name.
      case CHOOSE -> "sets[" + type(of.type()) + "].choose";
    };
  }

  private Doc binary(Binary binary, boolean isLast) {
    Expr left = binary.left();
    Expr right = binary.right();
    return switch (binary.operator()) {
      case AND -> chain("AND", operands(binary, Operator.AND), isLast);
      case OR -> chain("OR", operands(binary, Operator.OR), isLast);
      case IMPLIES ->
          group(2, of(left, IMPLIES + 1, false), " IMPLIES", LINE, tail(right, IMPLIES, isLast));
      case IFF -> group(2, of(left, IFF + 1, false), " IFF", LINE, tail(right, IFF + 1, isLast));
      case EQUAL ->
          isEmptyTest(binary) ? emptyTest(binary) : infix("=", COMPARISON + 1, binary, isLast);
      case UNEQUAL ->
          isEmptyTest(binary)
              ? emptyTest(binary)
              : Doc.of("NOT ", infix("=", COMPARISON + 1, binary, isLast));
      case LESS, AT_MOST, GREATER, AT_LEAST ->
          infix(binary.operator().text(), COMPARISON + 1, binary, isLast);
      case PLUS, LESS_BY, TIMES, DIVIDED_BY ->
          infix(binary.operator().text(), level(binary), binary, isLast);
      case IN -> Doc.of(atom(right), "(", of(left), ")");
      case SUBSET -> apply("subset?", left, right);
      case DISJOINT -> apply("disjoint?", left, right);
      case INTERSECT -> apply("intersection", left, right);
      case JOIN -> apply("append", left, right);
      case NTH -> apply("nth", left, right);
      // A source may have a function or action 'rem'.
      case MOD -> Doc.of("modulo_arithmetic.rem(", of(right), ")(", of(left), ")");
      case UNION ->
          single(right).isEmpty()
              ? apply("union", left, right)
              : apply("add", single(right).getFirst(), left);
      case MINUS ->
          single(right).isEmpty()
              ? apply("difference", left, right)
              : apply("remove", single(right).getFirst(), left);
    };
  }

  private Doc apply(String function, Expr... arguments) {
    return call(function, List.of(arguments));
  }

  /** Left to right: the right operand of an equal operator needs parentheses. */
  private Doc infix(String operator, int level, Binary binary, boolean isLast) {
    boolean isComparison = level > COMPARISON && level(binary) <= COMPARISON;
    return group(
        2,
        of(binary.left(), level, false),
        " " + operator,
        SOFT,
        of(binary.right(), isComparison ? level : level + 1, isLast));
  }

  /** The last operand: a quantifier there may extend to the end. */
  private Doc tail(Expr expr, int level, boolean isLast) {
    return level(expr) == 0 && isLast ? bare(expr, true) : of(expr, level, isLast);
  }

  /** Operands of one AND or OR, each on its own line if they do not fit on one. */
  private Doc chain(String operator, List<Expr> operands, boolean isLast) {
    List<Doc> all = new ArrayList<>();
    for (int i = 0; i < operands.size(); i++) {
      boolean isEnd = i == operands.size() - 1;
      // OR binds less than AND, but readers should not have to know.
      all.add(tail(operands.get(i), AND + 1, isEnd && isLast));
    }
    return new Doc.Group(join(all, " " + operator, LINE));
  }

  private static List<Expr> operands(Expr expr, Operator operator) {
    if (expr instanceof Binary binary && binary.operator() == operator) {
      List<Expr> all = new ArrayList<>(operands(binary.left(), operator));
      all.addAll(operands(binary.right(), operator));
      return all;
    }
    return List.of(expr);
  }

  /** The element of a set of one, or nothing. */
  private static List<Expr> single(Expr expr) {
    return expr instanceof Expr.SetOf set && set.elements().size() == 1
        ? set.elements()
        : List.of();
  }

  private static boolean isEmptyTest(Binary binary) {
    return isEmpty(binary.left()) || isEmpty(binary.right());
  }

  private static boolean isEmpty(Expr expr) {
    return expr instanceof Expr.None
        || (expr instanceof Expr.SetOf set && set.elements().isEmpty())
        || (expr instanceof Expr.ListOf list && list.elements().isEmpty());
  }

  /** {@code empty?(S)}, {@code bottom?(x)}, {@code null?(l)}, and their opposites. */
  private Doc emptyTest(Binary binary) {
    boolean isEqual = binary.operator() == Operator.EQUAL;
    Expr empty = isEmpty(binary.right()) ? binary.right() : binary.left();
    Expr other = isEmpty(binary.right()) ? binary.left() : binary.right();
    String test =
        switch (empty) {
          case Expr.None none -> isEqual ? "bottom?" : "up?";
          case Expr.SetOf set -> isEqual ? "empty?" : "nonempty?";
          default -> isEqual ? "null?" : "cons?";
        };
    return apply(test, other);
  }
}
