package org.starl.lang.tree;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;

/** A type of the language. Aliases are kept: two types are the same if their {@link #base}s are equal. */
public sealed interface Type {

  /** {@code bool}. */
  enum Bool implements Type {
    /** The only one. */
    BOOL;

    @Override
    public String toString() {
      return "bool";
    }
  }

  /** Numbers. A {@code nat} is an {@code int} and a {@code time}; each of these is a {@code real}. */
  enum Num implements Type {
    /** 0, 1, 2 and so on. */
    NAT("nat"),
    /** Whole numbers, also below 0. */
    INT("int"),
    /** Real numbers that are not negative. */
    TIME("time"),
    /** Real numbers. */
    REAL("real");

    private final String text;

    Num(String text) {
      this.text = text;
    }

    /** Whether its values are whole numbers. */
    public boolean isWhole() {
      return this == NAT || this == INT;
    }

    /** Whether it has values below 0. */
    public boolean hasNegative() {
      return this == INT || this == REAL;
    }

    private boolean isA(Num other) {
      return this == other || this == NAT || other == REAL;
    }

    @Override
    public String toString() {
      return text;
    }
  }

  /** {@code 0..N - 1}: the whole numbers from {@code low} to {@code high}. */
  record Range(Bound low, Bound high) implements Type {

    /** Whether it has no value for some values of its parameters. */
    public boolean mayBeEmpty() {
      return !low.isAtMost(high);
    }

    /** Of which these are values. */
    public Num number() {
      return low.isAtLeast(0) ? Num.NAT : Num.INT;
    }

    @Override
    public String toString() {
      return low + ".." + high;
    }
  }

  /** A type with a name of its own. */
  sealed interface Named extends Type {

    String name();
  }

  /** A parameter of the automaton: its values are compared, nothing else. */
  record Opaque(String name) implements Named {
    @Override
    public String toString() {
      return name;
    }
  }

  /** Another name of {@code target}. */
  record Alias(String name, Type target) implements Named {
    @Override
    public String toString() {
      return name;
    }
  }

  /** {@code record(term: nat, who: option[PIDS])}; equal by its owner and name. */
  record Rec(String owner, String name, List<Field> fields) implements Named {

    /** The field of this name. */
    public Optional<Field> field(String wanted) {
      return fields.stream().filter(f -> f.name().equals(wanted)).findFirst();
    }

    @Override
    public String toString() {
      return name;
    }
  }

  /** {@code open | passed | failed(missing: set[PIDS])}; an enumeration if no constructor has fields. */
  record Sum(String owner, String name, List<Constructor> constructors) implements Named {

    /** Whether no constructor has fields. */
    public boolean isEnum() {
      return constructors.stream().allMatch(c -> c.fields().isEmpty());
    }

    /** The constructor of this name. */
    public Optional<Constructor> constructor(String wanted) {
      return constructors.stream().filter(c -> c.name().equals(wanted)).findFirst();
    }

    @Override
    public String toString() {
      return name;
    }
  }

  /** {@code set[T]}: any set, also an infinite one. */
  record SetOf(Type element) implements Type {
    @Override
    public String toString() {
      return "set[" + element + "]";
    }
  }

  /** {@code list[T]}: finite. */
  record ListOf(Type element) implements Type {
    @Override
    public String toString() {
      return "list[" + element + "]";
    }
  }

  /** {@code option[T]}: {@code none}, or a value. */
  record OptionOf(Type element) implements Type {
    @Override
    public String toString() {
      return "option[" + element + "]";
    }
  }

  /** {@code [A, B -> T]}: a total function. */
  record MapOf(List<Type> arguments, Type result) implements Type {
    @Override
    public String toString() {
      List<String> names = new ArrayList<>();
      arguments.forEach(argument -> names.add(argument.toString()));
      return "[" + String.join(", ", names) + " -> " + result + "]";
    }
  }

  /** The states of a used automaton, which stand in a component of the user's. */
  record StateOf(Automaton automaton) implements Type {
    @Override
    public boolean equals(Object other) {
      return other instanceof StateOf that && automaton.name().equals(that.automaton.name());
    }

    @Override
    public int hashCode() {
      return automaton.name().hashCode();
    }

    @Override
    public String toString() {
      return automaton.name() + ".states";
    }
  }

  /** A named part of a record or constructor, a parameter, or a bound variable. */
  record Field(String name, Type type) {}

  /** A way to make a value of a {@link Sum}. */
  record Constructor(String name, List<Field> fields) {}

  /** The type without aliases, also inside. */
  default Type base() {
    return switch (this) {
      case Alias alias -> alias.target.base();
      case SetOf set -> new SetOf(set.element.base());
      case ListOf list -> new ListOf(list.element.base());
      case OptionOf option -> new OptionOf(option.element.base());
      case MapOf map ->
          new MapOf(map.arguments.stream().map(Type::base).toList(), map.result.base());
      default -> this;
    };
  }

  /** The parameters in the bounds of ranges of which it is made. */
  default Set<String> parameters() {
    Set<String> names = new TreeSet<>();
    switch (base()) {
      case Range range -> {
        names.addAll(range.low.times().keySet());
        names.addAll(range.high.times().keySet());
      }
      case SetOf set -> names.addAll(set.element.parameters());
      case ListOf list -> names.addAll(list.element.parameters());
      case OptionOf option -> names.addAll(option.element.parameters());
      case MapOf map -> {
        map.arguments.forEach(argument -> names.addAll(argument.parameters()));
        names.addAll(map.result.parameters());
      }
      case Rec rec -> rec.fields.forEach(field -> names.addAll(field.type.parameters()));
      case Sum sum ->
          sum.constructors.forEach(
              c -> c.fields.forEach(field -> names.addAll(field.type.parameters())));
      default -> {
        // It is made of no range.
      }
    }
    return names;
  }

  /** Whether it has finitely many values, if each opaque type has. */
  default boolean isFinite() {
    return switch (base()) {
      case Num number -> false;
      case ListOf list -> false;
      case Rec rec -> rec.fields.stream().allMatch(field -> field.type.isFinite());
      case Sum sum ->
          sum.constructors.stream()
              .allMatch(c -> c.fields.stream().allMatch(field -> field.type.isFinite()));
      case SetOf set -> set.element.isFinite();
      case OptionOf option -> option.element.isFinite();
      case MapOf map -> map.arguments.stream().allMatch(Type::isFinite) && map.result.isFinite();
      default -> true;
    };
  }

  /** The type of values of two types; of an {@code int} and a {@code time}, {@code real}. */
  static Type wider(Type a, Type b) {
    if (a.isA(b) || b.isA(a)) {
      return a.isA(b) ? b : a;
    }
    boolean isRange = a.base() instanceof Range || b.base() instanceof Range;
    return isRange ? wider(plain(a), plain(b)) : Num.REAL;
  }

  /** Whether it is a type of such numbers. */
  static boolean isNumber(Type type, Predicate<Num> of) {
    return plain(type).base() instanceof Num number && of.test(number);
  }

  /** The type; of a range, that of its numbers. */
  static Type plain(Type type) {
    return type.base() instanceof Range range ? range.number() : type;
  }

  /** Whether every value of this type is one of {@code other}. */
  default boolean isA(Type other) {
    Type its = other.base();
    if (its instanceof Range wide) {
      return base() instanceof Range range
          && wide.low.isAtMost(range.low)
          && range.high.isAtMost(wide.high);
    }
    Type mine = plain(this).base();
    return (mine instanceof Num a && its instanceof Num b) ? a.isA(b) : mine.equals(its);
  }
}
