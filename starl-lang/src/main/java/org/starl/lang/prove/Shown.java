package org.starl.lang.prove;

import static org.starl.lang.prove.Val.smt;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.starl.lang.prove.Val.Cells;
import org.starl.lang.prove.Val.Fn;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Constructor;
import org.starl.lang.tree.Type.Field;

/** Writes a model of Z3 in the notation of the language. */
final class Shown {

  /** Numbers above this one are not gone through. */
  private static final int MOST_NUMBER = 5;

  private static final int MOST_DIGITS = 9;

  private final Sorts sorts;
  private final Translator translator;
  private final Solver solver;
  private final TreeSet<Integer> numbers = new TreeSet<>();

  Shown(Translator translator, Solver solver) {
    this.translator = translator;
    this.solver = solver;
    sorts = translator.sorts();
    numbers.add(0);
  }

  /** {@code release(i: PIDS, RS: Zoneset)}. */
  static String head(Action action) {
    return action.name()
        + "("
        + String.join(
            ", ", action.parameters().stream().map(p -> p.name() + ": " + p.type()).toList())
        + ")";
  }

  // --- a small model -----------------------------------------------------------------------------

  /** Asks for few and small values, first of {@code variables}, then of the state. */
  void minimise(List<Field> fields, List<Val> variables, Scope state) {
    for (int i = 0; i < fields.size(); i++) {
      small(fields.get(i).type(), variables.get(i));
    }
    if (!solver.hasModel()) {
      return; // the names of places are values, too
    }
    for (Place place : places(state.automaton(), "", state.cells())) {
      small(place.type(), place.value());
    }
    for (int i = 0; i < fields.size(); i++) {
      if (solver.hasModel() && fields.get(i).type().base() == Type.Num.NAT) {
        String number = solver.number(smt(variables.get(i)));
        if (number.length() < MOST_DIGITS) {
          numbers.add(Integer.parseInt(number));
        }
      }
    }
    for (int n = 0; n <= MOST_NUMBER && n <= numbers.last(); n++) { // those between, too
      numbers.add(n);
    }
    if (!solver.hasModel()) {
      return;
    }
    places(state.automaton(), "", state.cells()).forEach(p -> preferUsual(p.type(), p.value()));
    for (int i = 0; i < fields.size(); i++) {
      preferUsual(fields.get(i).type(), variables.get(i));
    }
  }

  private void small(Type type, Val value) {
    if (!Type.isNumber(type, Type.Num::isWhole)) {
      return;
    }
    String number =
        Type.plain(type).base() == Type.Num.INT ? Smt.call("abs", smt(value)) : smt(value);
    for (int most = 0; most < MOST_NUMBER; most++) {
      String low = Smt.call("<=", number, String.valueOf(most));
      solver.prefer(low);
      if (!solver.hasModel() || solver.isTrue(low)) {
        return;
      }
    }
  }

  private void preferUsual(Type type, Val value) {
    if (Sorts.isMap(type)) {
      Type.MapOf map = Sorts.map(type);
      for (List<String> x : arguments(map.arguments())) {
        preferUsual(map.result(), ((Fn) value).at().apply(x));
      }
      return;
    }
    String usual = usual(type, smt(value));
    if (!usual.equals(Smt.TRUE)) {
      solver.prefer(usual);
    }
  }

  /** That a value is what most are: {@code false}, 0, {@code none}, the first form. */
  private String usual(Type type, String value) {
    return switch (type.base()) {
      case Type.Bool bool -> Smt.not(value);
      case Type.Num number -> Smt.equal(value, number.isWhole() ? "0" : "0.0");
      case Type.Range range -> Smt.equal(value, "0");
      case Type.OptionOf option -> Smt.not(sorts.someTest(option, value));
      case Type.ListOf list -> Smt.not(sorts.notEmpty(list, value));
      case Type.Sum sum ->
          "((_ is " + sorts.form(sum, sum.constructors().getFirst()) + ") " + value + ")";
      case Type.Rec rec ->
          Smt.and(
              rec.fields().stream()
                  .filter(f -> !Sorts.isMap(f.type()))
                  .map(f -> usual(f.type(), Smt.call(sorts.field(rec, f), value)))
                  .toList());
      case Type.Opaque opaque -> Smt.equal(value, sorts.elements(opaque).getFirst());
      default -> Smt.TRUE;
    };
  }

  // --- texts -------------------------------------------------------------------------------------

  /** A part of a state that is shown by itself: {@code crit_set(bot0)}. */
  private record Place(String name, Type type, Val value) {}

  private List<Place> places(Automaton automaton, String prefix, Map<String, Val> cells) {
    List<Place> all = new ArrayList<>();
    for (Automaton.Component each : automaton.state()) {
      Val value = Objects.requireNonNull(cells.get(each.name()));
      String name = prefix + each.name();
      if (each.type() instanceof Type.StateOf used) {
        all.addAll(places(used.automaton(), name + ".", ((Cells) value).cells()));
      } else if (each.type().base() instanceof Type.MapOf map) {
        for (List<String> x : arguments(map.arguments())) {
          List<String> names = new ArrayList<>();
          for (int i = 0; i < x.size(); i++) {
            names.add(text(map.arguments().get(i), new Val.Term(x.get(i))));
          }
          all.add(
              new Place(
                  name + "(" + String.join(", ", names) + ")",
                  map.result(),
                  ((Fn) value).at().apply(x)));
        }
      } else {
        all.add(new Place(name, each.type(), value));
      }
    }
    return all;
  }

  /** The places of a state that have other values than most. */
  List<String> unusual(Scope state) {
    return places(state.automaton(), "", state.cells()).stream()
        .filter(place -> isUnusual(place.type(), place.value()))
        .map(place -> place.name() + " = " + text(place.type(), place.value()))
        .toList();
  }

  private boolean isUnusual(Type type, Val value) {
    if (!Sorts.isMap(type)) {
      // No element of an opaque type is more usual than another.
      return type.base() instanceof Type.Opaque || !solver.isTrue(usual(type, smt(value)));
    }
    Type.MapOf map = Sorts.map(type);
    return arguments(map.arguments()).stream()
        .anyMatch(x -> isUnusual(map.result(), ((Fn) value).at().apply(x)));
  }

  /** The places of {@code after} whose values differ from those before. */
  List<String> changed(Scope before, Scope after) {
    List<Place> old = places(before.automaton(), "", before.cells());
    List<Place> now = places(after.automaton(), "", after.cells());
    List<String> all = new ArrayList<>();
    for (int i = 0; i < old.size(); i++) {
      String text = text(now.get(i).type(), now.get(i).value());
      if (!text.equals(text(old.get(i).type(), old.get(i).value()))) {
        all.add(now.get(i).name() + " = " + text);
      }
    }
    return all;
  }

  /** The arguments that are gone through: all elements, and the numbers that occur. */
  private List<List<String>> arguments(List<Type> types) {
    List<List<String>> all = new ArrayList<>();
    all.add(List.of());
    for (Type type : types) {
      List<String> values = sorts.elements(type);
      if (type.base() == Type.Num.NAT) {
        values = numbers.stream().map(String::valueOf).toList();
      } else if (type.base() == Type.Num.INT) {
        values =
            numbers.stream()
                .flatMap(n -> n == 0 ? Stream.of("0") : Stream.of("" + n, "(- " + n + ")"))
                .toList();
      }
      List<List<String>> longer = new ArrayList<>();
      for (List<String> one : all) {
        for (String value : values) {
          List<String> next = new ArrayList<>(one);
          next.add(value);
          longer.add(next);
        }
      }
      all = longer;
    }
    return all;
  }

  /** A value as a source would have it. */
  String text(Type type, Val value) {
    return switch (type.base()) {
      case Type.SetOf set -> {
        List<String> elements = new ArrayList<>();
        for (List<String> x : arguments(List.of(set.element()))) {
          if (solver.isTrue(smt(((Fn) value).at().apply(x)))) {
            elements.add(text(set.element(), new Val.Term(x.getFirst())));
          }
        }
        yield "{" + String.join(", ", elements) + "}";
      }
      case Type.MapOf map -> {
        List<String> entries = new ArrayList<>();
        for (List<String> x : arguments(map.arguments())) {
          entries.add(
              String.join(", ", x) + " -> " + text(map.result(), ((Fn) value).at().apply(x)));
        }
        yield "[" + String.join(", ", entries) + "]";
      }
      default -> text(type.base(), smt(value));
    };
  }

  private String text(Type type, String value) {
    return switch (type) {
      case Type.Num number -> solver.number(value);
      case Type.Range range -> solver.number(value);
      case Type.OptionOf option ->
          solver.isTrue(sorts.someTest(option, value))
              ? "some(" + part(option.element(), Smt.call("the", value)) + ")"
              : "none";
      case Type.ListOf list -> {
        List<String> elements = new ArrayList<>();
        String rest = value;
        while (solver.isTrue(sorts.notEmpty(list, rest))) {
          elements.add(part(list.element(), sorts.head(rest)));
          rest = sorts.tail(rest);
        }
        yield "[" + String.join(", ", elements) + "]";
      }
      case Type.Rec rec ->
          rec.name()
              + "("
              + String.join(
                  ", ",
                  rec.fields().stream()
                      .map(f ->
                          f.name() + " := " + part(f.type(), Smt.call(sorts.field(rec, f), value)))
                      .toList())
              + ")";
      case Type.Sum sum -> {
        Constructor form =
            sum.constructors().stream()
                .filter(c -> solver.isTrue("((_ is " + sorts.form(sum, c) + ") " + value + ")"))
                .findFirst()
                .orElseThrow();
        List<String> fields = new ArrayList<>();
        form.fields()
            .forEach(f -> fields.add(part(f.type(), Smt.call(sorts.field(sum, form, f), value))));
        yield form.name() + (fields.isEmpty() ? "" : "(" + String.join(", ", fields) + ")");
      }
      default -> solver.value(value).word();
    };
  }

  private String part(Type type, String value) {
    return text(type, translator.of(value, type));
  }
}
