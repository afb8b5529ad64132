package org.starl.lang.read;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.starl.lang.grammar.StarlParser;
import org.starl.lang.grammar.StarlParser.BinderGroupContext;
import org.starl.lang.grammar.StarlParser.IdContext;
import org.starl.lang.grammar.StarlParser.TypeContext;
import org.starl.lang.tree.Bound;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Constructor;
import org.starl.lang.tree.Type.Field;

/** Reads types, and declarations of types. */
record TypeReader(Scope scope, Problems problems) {

  Type type(TypeContext at) {
    return switch (at) {
      case StarlParser.SetTypeContext set -> new Type.SetOf(type(set.type()));
      case StarlParser.ListTypeContext list -> new Type.ListOf(type(list.type()));
      case StarlParser.OptionTypeContext option -> new Type.OptionOf(type(option.type()));
      case StarlParser.MapTypeContext map -> {
        List<Type> all = new ArrayList<>();
        map.type().forEach(each -> all.add(type(each)));
        yield new Type.MapOf(List.copyOf(all.subList(0, all.size() - 1)), all.getLast());
      }
      case StarlParser.PartialMapTypeContext map -> {
        if (map.arrow != null) {
          problems.add(
              Problems.pos(map.arrow), "found '->'; expected ',' as in 'map[K, V]', or '[K -> V]'");
        }
        yield new Type.MapOf(List.of(type(map.type(0))), new Type.OptionOf(type(map.type(1))));
      }
      case StarlParser.RangeTypeContext range -> range(range);
      case StarlParser.NamedTypeContext named -> named(named.name);
      default -> throw new IllegalStateException("type " + at.getText());
    };
  }

  private Type range(StarlParser.RangeTypeContext at) {
    Type.Range range = new Type.Range(bound(at.bound(0)), bound(at.bound(1)));
    if (range.low().plus(-1, range.high()).isAtLeast(1)) {
      problems.add(at, "the range " + range + " is empty; expected the lower number first");
      throw new Wrong();
    }
    boolean hasParameters = !range.low().isNumber() || !range.high().isNumber();
    if (hasParameters && scope.ranges.stream().noneMatch(each -> each.type().equals(range))) {
      Pos pos = Problems.pos(at);
      scope.ranges.add(
          new Expr.BuiltIn(Expr.BuiltIn.Name.WITHIN, range.low().expr(pos), range, pos));
    }
    return range;
  }

  private Bound bound(StarlParser.BoundContext at) {
    Bound sum = Bound.of(0);
    try {
      for (int i = 0; i < at.product().size(); i++) {
        boolean isTaken = i == 0 ? at.negative != null : at.sign(i - 1).getText().equals("-");
        sum = sum.plus(isTaken ? -1 : 1, product(at.product(i), at));
      }
    } catch (ArithmeticException e) {
      throw noBound(at);
    }
    return sum;
  }

  private Bound product(StarlParser.ProductContext at, StarlParser.BoundContext whole) {
    Bound product = Bound.of(1);
    for (StarlParser.FactorContext factor : at.factor()) {
      Bound value = factor(factor, whole);
      if (!product.isNumber() && !value.isNumber()) {
        throw noBound(whole);
      }
      product =
          value.isNumber()
              ? Bound.of(0).plus(value.plus(), product)
              : Bound.of(0).plus(product.plus(), value);
    }
    return product;
  }

  private Bound factor(StarlParser.FactorContext at, StarlParser.BoundContext whole) {
    String text = at.getText();
    if (at.bound() != null) {
      return bound(at.bound());
    }
    if (text.matches("[0-9]{1,9}")) {
      return Bound.of(Integer.parseInt(text));
    }
    if (!scope.numbers.contains(text)) {
      if (scope.types.get(text) instanceof Type.Opaque) {
        problems.add(at, "'" + text + "' is a type; expected '" + text + ": nat' as a parameter");
        throw new Wrong();
      }
      throw noBound(whole);
    }
    if (at.id() != null) {
      problems.refer(at.id(), text + ": nat", scope.place(text, at));
    }
    return Bound.of(text);
  }

  private Wrong noBound(StarlParser.BoundContext at) {
    problems.add(
        at,
        "'"
            + SourceText.of(at)
            + "' is no bound of a type; expected whole numbers of at most 9 digits, nat parameters of"
            + " the automaton, and sums of them; others in a condition: 'i in 0..n'");
    return new Wrong();
  }

  private Type named(IdContext at) {
    Type known = scope.types.get(at.getText());
    if (known == null) {
      if (scope.wrongTypes.contains(at.getText())) {
        throw new Wrong();
      }
      String expected = Problems.oneOf(at.getText(), scope.types.keySet());
      problems.add(
          at,
          scope.later.contains(at.getText())
              ? "'" + at.getText() + "' is declared below; expected it above"
              : "'" + at.getText() + "' is no type; " + expected);
      throw new Wrong();
    }
    Pos place = scope.places.get(at.getText());
    if (place != null) {
      problems.refer(at, meaning(known), place);
    }
    return known;
  }

  private static String meaning(Type type) {
    return switch (type) {
      case Type.Alias alias -> "type " + alias + " = " + alias.target();
      case Type.Rec rec -> "type " + rec + " = record(" + list(rec.fields()) + ")";
      case Type.Sum sum ->
          "type "
              + sum
              + " = "
              + sum.constructors().stream()
                  .map(c -> c.name() + (c.fields().isEmpty() ? "" : "(" + list(c.fields()) + ")"))
                  .collect(Collectors.joining(" | "));
      default -> "type " + type;
    };
  }

  /** {@code i: PIDS, n: nat}. */
  static String list(List<Field> fields) {
    return fields.stream()
        .map(field -> field.name() + ": " + field.type())
        .collect(Collectors.joining(", "));
  }

  /** The fields of {@code i, j: PIDS, z: Zones}; a name twice is told. */
  List<Field> fields(List<BinderGroupContext> groups, boolean mayShadow) {
    List<Field> fields = new ArrayList<>();
    Set<String> names = new TreeSet<>();
    for (BinderGroupContext group : groups) {
      Type type = type(group.type());
      for (IdContext id : group.id()) {
        String name = id.getText();
        Optional<String> taken = mayShadow ? Optional.empty() : scope.taken(name);
        if (!names.add(name)) {
          problems.add(id, "'" + name + "' is here twice; expected different names");
        } else if (taken.isPresent()) {
          problems.add(id, "'" + name + "' is " + taken.get() + " already; expected a new name");
        }
        scope.places.put(name, Problems.pos(id));
        fields.add(new Field(name, type));
      }
    }
    return List.copyOf(fields);
  }

  /** Makes these the places of their names again, which others may have had since. */
  void placed(List<BinderGroupContext> groups) {
    groups.forEach(
        group -> group.id().forEach(id -> scope.places.put(id.getText(), Problems.pos(id))));
  }

  /** Declares a type. */
  Type.Named declare(StarlParser.TypePartContext at) {
    String name = at.name.getText();
    scope.later.remove(name);
    scope
        .taken(name)
        .ifPresent(what ->
            problems.add(at.name, "'" + name + "' is " + what + " already; expected a new name"));
    Type.Named type =
        switch (at.typeBody()) {
          case StarlParser.RecordBodyContext body ->
              new Type.Rec(scope.automaton, name, fields(body.binderGroup(), true));
          case StarlParser.SumBodyContext body -> sum(name, body);
          case StarlParser.AliasBodyContext body -> new Type.Alias(name, type(body.type()));
          default -> throw new IllegalStateException("type " + at.getText());
        };
    scope.types.put(name, type);
    scope.places.put(name, Problems.pos(at.name));
    return type;
  }

  private Type.Sum sum(String name, StarlParser.SumBodyContext body) {
    List<Constructor> constructors = new ArrayList<>();
    Set<String> names = new HashSet<>();
    for (StarlParser.ConstructorContext each : body.constructor()) {
      String constructor = each.name.getText();
      Optional<String> taken = scope.taken(constructor);
      if (taken.isPresent() || !names.add(constructor)) {
        problems.add(
            each.name,
            "'%s' is %s already; expected a new name"
                .formatted(constructor, taken.orElse("a value of " + name)));
      }
      scope.places.put(constructor, Problems.pos(each.name));
      constructors.add(new Constructor(constructor, fields(each.binderGroup(), true)));
    }
    Type.Sum sum = new Type.Sum(scope.automaton, name, List.copyOf(constructors));
    constructors.forEach(c -> scope.constructors.put(c.name(), new Scope.Known(sum, c)));
    return sum;
  }
}
