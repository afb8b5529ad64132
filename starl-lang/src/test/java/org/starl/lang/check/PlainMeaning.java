package org.starl.lang.check;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Action.Effect;
import org.starl.lang.tree.Action.Selector;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/**
 * The meaning of a small part of the language, written down a second time and in the plainest way:
 * trees are walked, ids are strings, sets are sets of strings, maps of one id are maps.
 */
final class PlainMeaning {

  /** An operation has no value. */
  static final class Undefined extends RuntimeException {
    private static final long serialVersionUID = 1L;
  }

  private final Automaton automaton;
  private final List<String> ids;
  private final int nat;

  PlainMeaning(Automaton automaton, List<String> ids, int nat) {
    this.automaton = automaton;
    this.ids = ids;
    this.nat = nat;
  }

  List<?> values(Type type) {
    return switch (type) {
      case Type.Opaque opaque -> ids;
      case Type.Num num -> java.util.stream.IntStream.rangeClosed(0, nat).boxed().toList();
      default -> throw new IllegalArgumentException(type.toString());
    };
  }

  Object value(Expr expr, Map<String, Object> state, Map<String, Object> variables) {
    return switch (expr) {
      case Expr.Bool bool -> bool.value();
      case Expr.Numeral numeral -> numeral.value().intValueExact();
      case Expr.Variable variable -> variables.get(variable.name());
      case Expr.Component component -> state.get(component.name());
      case Expr.At at ->
          ((Map<?, ?>) value(at.map(), state, variables))
              .get(value(at.arguments().getFirst(), state, variables));
      case Expr.Not not -> !(Boolean) value(not.of(), state, variables);
      case Expr.Negative minus -> -(Integer) value(minus.of(), state, variables);
      case Expr.None none -> Optional.empty();
      case Expr.Some some -> Optional.of(value(some.of(), state, variables));
      case Expr.ListOf list ->
          list.elements().stream().map(each -> value(each, state, variables)).toList();
      case Expr.BuiltIn length when length.name() == Expr.BuiltIn.Name.LENGTH ->
          ((List<?>) value(length.of(), state, variables)).size();
      case Expr.BuiltIn card when card.name() == Expr.BuiltIn.Name.CARD ->
          ((Set<?>) value(card.of(), state, variables)).size();
      case Expr.BuiltIn the ->
          ((Optional<?>) value(the.of(), state, variables)).orElseThrow(Undefined::new);
      case Expr.SetOf set -> {
        Set<Object> all = new TreeSet<>();
        set.elements().forEach(each -> all.add(value(each, state, variables)));
        yield all;
      }
      case Expr.SuchThat set -> {
        Set<Object> all = new TreeSet<>();
        for (Object id : values(set.variable().type())) {
          if ((Boolean) value(set.body(), state, with(variables, set.variable(), id))) {
            all.add(id);
          }
        }
        yield all;
      }
      case Expr.If choice ->
          value(
              (Boolean) value(choice.condition(), state, variables)
                  ? choice.then()
                  : choice.otherwise(),
              state,
              variables);
      case Expr.Quantified quantified -> {
        boolean all = true;
        boolean some = false;
        for (Object id : values(quantified.variables().getFirst().type())) {
          boolean one =
              (Boolean)
                  value(
                      quantified.body(),
                      state,
                      with(variables, quantified.variables().getFirst(), id));
          all &= one;
          some |= one;
        }
        yield quantified.forAll() ? all : some;
      }
      case Expr.Binary binary -> binary(binary, state, variables);
      default -> throw new IllegalArgumentException(expr.toString());
    };
  }

  private Object binary(Expr.Binary at, Map<String, Object> state, Map<String, Object> variables) {
    Object left = value(at.left(), state, variables);
    return switch (at.operator()) {
      case AND -> (Boolean) left ? value(at.right(), state, variables) : Boolean.FALSE;
      case OR -> (Boolean) left ? Boolean.TRUE : value(at.right(), state, variables);
      case IMPLIES -> (Boolean) left ? value(at.right(), state, variables) : Boolean.TRUE;
      default -> strict(at, left, value(at.right(), state, variables));
    };
  }

  @SuppressWarnings("unchecked") // sources are checked: sets are sets
  private static Object strict(Expr.Binary at, Object left, Object right) {
    return switch (at.operator()) {
      case EQUAL -> left.equals(right);
      case UNEQUAL -> !left.equals(right);
      case LESS -> (Integer) left < (Integer) right;
      case PLUS -> (Integer) left + (Integer) right;
      case LESS_BY -> {
        if (at.type() != Type.Num.INT && (Integer) left < (Integer) right) {
          throw new Undefined();
        }
        yield (Integer) left - (Integer) right;
      }
      case JOIN -> Stream.concat(((List<?>) left).stream(), ((List<?>) right).stream()).toList();
      case NTH -> {
        if ((Integer) right >= ((List<?>) left).size()) {
          throw new Undefined();
        }
        yield ((List<?>) left).get((Integer) right);
      }
      case IN -> ((Set<Object>) right).contains(left);
      case SUBSET -> ((Set<Object>) right).containsAll((Set<Object>) left);
      case UNION -> {
        Set<Object> both = new TreeSet<>((Set<Object>) left);
        both.addAll((Set<Object>) right);
        yield both;
      }
      case MINUS -> {
        Set<Object> rest = new TreeSet<>((Set<Object>) left);
        rest.removeAll((Set<Object>) right);
        yield rest;
      }
      default -> throw new IllegalArgumentException(at.toString());
    };
  }

  static Map<String, Object> with(Map<String, Object> variables, Field variable, Object value) {
    Map<String, Object> more = new LinkedHashMap<>(variables);
    more.put(variable.name(), value);
    return more;
  }

  boolean enabled(Action action, Map<String, Object> state, Map<String, Object> arguments) {
    for (Action.Conjunct conjunct : action.pre()) {
      if (!(Boolean) value(conjunct.condition(), state, arguments)) {
        return false;
      }
    }
    return true;
  }

  /** The state after an action; empty if it is beyond the bound. */
  Optional<Map<String, Object>> after(
      Action action, Map<String, Object> state, Map<String, Object> arguments) {
    Map<String, Object> after = new LinkedHashMap<>(state);
    for (Effect effect : action.eff()) {
      Effect.Assign assign = (Effect.Assign) effect;
      Object value = value(assign.value(), state, arguments);
      if ((value instanceof Integer number && Math.abs(number) > nat)
          || (value instanceof List<?> list && list.size() > nat)) {
        return Optional.empty();
      }
      if (assign.selectors().isEmpty()) {
        after.put(assign.component(), value);
      } else {
        Expr at = ((Selector.At) assign.selectors().getFirst()).arguments().getFirst();
        Map<Object, Object> map = new LinkedHashMap<>((Map<?, ?>) after.get(assign.component()));
        map.put(value(at, state, arguments), value);
        after.put(assign.component(), map);
      }
    }
    return Optional.of(after);
  }

  boolean holds(Map<String, Object> state) {
    return automaton.invariants().stream()
        .allMatch(invariant -> (Boolean) value(invariant.condition(), state, Map.of()));
  }

  boolean isWithin(Map<String, Object> state) {
    return automaton.constraints().stream()
        .allMatch(constraint -> (Boolean) value(constraint.condition(), state, Map.of()));
  }

  /** As a domain writes it. */
  static String text(Object value) {
    return switch (value) {
      case Set<?> set ->
          "{" + String.join(", ", set.stream().map(PlainMeaning::text).toList()) + "}";
      case List<?> list ->
          "[" + String.join(", ", list.stream().map(PlainMeaning::text).toList()) + "]";
      case Optional<?> option -> option.map(of -> "some(" + text(of) + ")").orElse("none");
      case Map<?, ?> map ->
          "["
              + String.join(
                  ", ",
                  map.entrySet().stream()
                      .map(e -> text(e.getKey()) + " -> " + text(e.getValue()))
                      .toList())
              + "]";
      default -> value.toString();
    };
  }

  /** With other names of ids. */
  Object renamed(Object value, Map<String, String> names) {
    return switch (value) {
      case Set<?> set -> {
        Set<Object> renamed = new TreeSet<>();
        set.forEach(each -> renamed.add(renamed(each, names)));
        yield renamed;
      }
      case List<?> list -> list.stream().map(each -> renamed(each, names)).toList();
      case Optional<?> option -> option.map(of -> renamed(of, names));
      case Map<?, ?> map -> {
        Map<Object, Object> renamed = new java.util.TreeMap<>();
        map.forEach((key, of) -> renamed.put(renamed(key, names), renamed(of, names)));
        yield renamed;
      }
      case String id -> names.get(id);
      default -> value;
    };
  }
}
