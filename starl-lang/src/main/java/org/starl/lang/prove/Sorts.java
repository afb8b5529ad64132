package org.starl.lang.prove;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Expr.Operator;
import org.starl.lang.tree.Exprs;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Constructor;
import org.starl.lang.tree.Type.Field;

/**
 * Types as sorts: an opaque type is a sort of its own, or one with so many elements as {@code size} says;
 * records, sums, options and lists are datatypes; sets and maps inside these are arrays. Lists are Z3's
 * sequences where they are joined, or asked for their length or an element: of these it knows the
 * laws. Datatypes are faster elsewhere.
 */
final class Sorts {

  /** As many values of a type at most as a quantifier is written out for. */
  private static final int MOST_ELEMENTS = 64;

  /** The largest number where they are few. */
  static final int MOST_NUMBER = 3;

  private static final Set<String> TAKEN =
      Set.of("Int", "Real", "Bool", "Array", "String", "Seq", "List", "Set", "option", "list");

  private final Automaton automaton;
  private final Map<String, List<String>> opaque = new LinkedHashMap<>();
  private final int size;
  private final boolean isFinite;
  private final boolean isRecursive;
  private final boolean hasSequences;

  /**
   * @param size elements of each opaque type, and the largest value of each parameter in bounds of
   *     ranges; 0 if any number
   */
  Sorts(Automaton automaton, int size) {
    this.automaton = automaton;
    this.size = size;
    isFinite = size > 0;
    isRecursive = isRecursive(automaton);
    hasSequences = hasSequences(automaton);
    for (String type : automaton.typeParameters()) {
      List<String> names = new ArrayList<>();
      for (int i = 0; i < size; i++) {
        names.add(element(type, opaque.size(), i));
      }
      opaque.put(type, List.copyOf(names));
    }
  }

  /** The first opaque type is that of the robots. */
  private static String element(String type, int number, int i) {
    return switch (number) {
      case 0 -> "bot" + i;
      case 1 -> String.valueOf((char) ('A' + i));
      default -> type + i;
    };
  }

  /** Whether functions call themselves, here or in used automata. */
  static boolean isRecursive(Automaton automaton) {
    return automaton.functions().stream().anyMatch(f -> f.measure().isPresent())
        || automaton.uses().values().stream().anyMatch(Sorts::isRecursive);
  }

  private static boolean hasSequences(Automaton of) {
    return of.expressions().anyMatch(Sorts::isOfSequences)
        || of.uses().values().stream().anyMatch(Sorts::hasSequences);
  }

  private static boolean isOfSequences(Expr at) {
    return switch (at) {
      case Expr.BuiltIn of when of.name() == Expr.BuiltIn.Name.LENGTH -> true;
      case Expr.Binary of when of.operator() == Operator.JOIN || of.operator() == Operator.NTH ->
          true;
      default -> Exprs.parts(at).stream().anyMatch(Sorts::isOfSequences);
    };
  }

  /** Whether lists are sequences of Z3. */
  boolean hasSequences() {
    return hasSequences;
  }

  /** Whether natural numbers end with {@link #MOST_NUMBER}: then Z3 can work recursive functions out. */
  boolean hasFewNumbers() {
    return isFinite && isRecursive;
  }

  boolean isFinite() {
    return isFinite;
  }

  /** The lines that declare the sorts. */
  List<String> declarations() {
    List<String> lines = new ArrayList<>();
    opaque.forEach((type, names) ->
        lines.add(
            names.isEmpty()
                ? "(declare-sort " + named(type) + " 0)"
                : "(declare-datatypes ((" + named(type) + " 0)) ((" + bracketed(names) + ")))"));
    lines.add("(declare-datatypes ((option 1)) ((par (t.) ((none) (some (the t.))))))");
    lines.add(
        "(declare-datatypes ((list 1)) ((par (t.) ((nil) (cons (head t.) (tail (list t.)))))))");
    declare(automaton, lines, new ArrayList<>());
    return lines;
  }

  private static String bracketed(List<String> names) {
    return "(" + String.join(") (", names) + ")";
  }

  private void declare(Automaton of, List<String> lines, List<String> done) {
    of.uses().values().forEach(used -> declare(used, lines, done));
    if (done.contains(of.name())) {
      return;
    }
    done.add(of.name());
    for (Automaton.Declared each : of.types()) {
      if (each.type() instanceof Type.Rec rec) {
        lines.add(
            datatype(rec, List.of(Smt.call("mk." + sort(rec), fields(rec, "", rec.fields())))));
      } else if (each.type() instanceof Type.Sum sum) {
        List<String> forms = new ArrayList<>();
        for (Constructor form : sum.constructors()) {
          List<String> fields = fields(sum, form.name() + ".", form.fields());
          forms.add(
              fields.isEmpty() ? "(" + form(sum, form) + ")" : Smt.call(form(sum, form), fields));
        }
        lines.add(datatype(sum, forms));
      }
    }
  }

  private String datatype(Type type, List<String> forms) {
    return "(declare-datatypes ((" + sort(type) + " 0)) ((" + String.join(" ", forms) + ")))";
  }

  private List<String> fields(Type owner, String prefix, List<Field> fields) {
    return fields.stream()
        .map(f -> "(" + sort(owner) + "." + prefix + f.name() + " " + inner(f.type()) + ")")
        .toList();
  }

  String form(Type.Sum sum, Constructor form) {
    return sort(sum) + "." + form.name();
  }

  String field(Type.Sum sum, Constructor form, Field field) {
    return form(sum, form) + "." + field.name();
  }

  String field(Type.Rec rec, Field field) {
    return sort(rec) + "." + field.name();
  }

  private String named(String name) {
    return TAKEN.contains(name) ? name + "." : name;
  }

  private String owned(String owner, String name) {
    return owner.equals(automaton.name()) ? named(name) : owner + "." + name;
  }

  /** The sort of a type inside a datatype: equal maps must be equal arrays. */
  private String inner(Type type) {
    if (hasNumericDomain(type.base())) {
      throw new Unprovable(
          "the type "
              + type
              + " inside another type: a set or map of numbers is not translated there");
    }
    return sort(type);
  }

  /** Whether arrays of this type have values outside their domain: at negative numbers. */
  boolean hasNumericDomain(Type type) {
    return switch (type.base()) {
      case Type.SetOf set -> isNonNegative(set.element()) || hasNumericDomain(set.element());
      case Type.MapOf map ->
          map.arguments().stream().anyMatch(a -> isNonNegative(a) || hasNumericDomain(a))
              || hasNumericDomain(map.result());
      default -> false;
    };
  }

  private static boolean isNonNegative(Type type) {
    return type.base() instanceof Type.Range || Type.isNumber(type, n -> !n.hasNegative());
  }

  String sort(Type type) {
    return switch (type.base()) {
      case Type.Bool bool -> "Bool";
      case Type.Num number -> number.isWhole() ? "Int" : "Real";
      case Type.Range range -> "Int";
      case Type.Opaque of -> named(of.name());
      case Type.Rec rec -> owned(rec.owner(), rec.name());
      case Type.Sum sum -> owned(sum.owner(), sum.name());
      case Type.OptionOf option -> Smt.call("option", inner(option.element()));
      case Type.ListOf list -> Smt.call(hasSequences ? "Seq" : "list", inner(list.element()));
      case Type.SetOf set -> Smt.call("Array", sort(set.element()), "Bool");
      case Type.MapOf map -> {
        List<String> sorts = new ArrayList<>();
        map.arguments().forEach(argument -> sorts.add(sort(argument)));
        sorts.add(sort(map.result()));
        yield Smt.call("Array", sorts);
      }
      case Type.StateOf state ->
          throw new Unprovable("the state of " + state.automaton().name() + " as a value");
      case Type.Alias alias -> throw new IllegalStateException(alias.name());
    };
  }

  /** The sorts tell Z3 which option it is where one is inside another. */
  String someTest(Type.OptionOf option, String value) {
    return "((_ is (some (%s) %s)) %s)".formatted(sort(option.element()), sort(option), value);
  }

  String some(Type type, String value) {
    return Smt.call("(as some " + sort(type) + ")", value);
  }

  String emptyList(Type type) {
    return "(as " + (hasSequences ? "seq.empty " : "nil ") + sort(type) + ")";
  }

  String cons(String head, String tail) {
    return hasSequences
        ? Smt.call("seq.++", Smt.call("seq.unit", head), tail)
        : Smt.call("cons", head, tail);
  }

  String notEmpty(Type.ListOf type, String list) {
    return hasSequences ? "(> (seq.len " + list + ") 0)" : consTest(type, list);
  }

  String consTest(Type.ListOf type, String list) {
    return "((_ is (cons (%1$s %2$s) %2$s)) %3$s)"
        .formatted(sort(type.element()), sort(type), list);
  }

  String head(String list) {
    return hasSequences ? Smt.call("seq.nth", list, "0") : Smt.call("head", list);
  }

  String tail(String list) {
    return hasSequences
        ? "(seq.extract %1$s 1 (- (seq.len %1$s) 1))".formatted(list)
        : Smt.call("tail", list);
  }

  /** All values of a type, if they are few; empty if they are not, or any number. */
  List<String> elements(Type type) {
    List<String> all =
        switch (type.base()) {
          case Type.Bool bool -> List.of(Smt.FALSE, Smt.TRUE);
          case Type.Num number when number == Type.Num.NAT && hasFewNumbers() ->
              IntStream.rangeClosed(0, MOST_NUMBER).mapToObj(String::valueOf).toList();
          case Type.Range range -> numbers(range);
          case Type.Opaque of -> opaque.getOrDefault(of.name(), List.of());
          case Type.Sum sum when sum.isEnum() ->
              sum.constructors().stream().map(form -> form(sum, form)).toList();
          case Type.OptionOf option -> {
            List<String> inner = elements(option.element());
            List<String> values = new ArrayList<>();
            if (!inner.isEmpty()) {
              values.add("(as none " + sort(option) + ")");
              inner.forEach(value -> values.add(some(option, value)));
            }
            yield values;
          }
          default -> List.of();
        };
    boolean isKnown = isFinite || type.base() instanceof Type.Range;
    return isKnown && all.size() <= MOST_ELEMENTS ? all : List.of();
  }

  /** All that may be in a range, if they are few: with parameters at most {@link #size}. */
  private List<String> numbers(Type.Range range) {
    if (!isFinite && !range.parameters().isEmpty()) {
      return List.of();
    }
    long low = range.low().least(size);
    long high = range.high().negated().least(size) * -1;
    return LongStream.rangeClosed(low, Math.min(high, low + MOST_ELEMENTS))
        .mapToObj(n -> Smt.number(BigDecimal.valueOf(n), false))
        .toList();
  }

  /** The largest value of a parameter in bounds of ranges; 0 if any. */
  int size() {
    return size;
  }

  /** Sets as maps to {@code bool}. */
  static Type.MapOf map(Type type) {
    return switch (type.base()) {
      case Type.SetOf set -> new Type.MapOf(List.of(set.element()), Type.Bool.BOOL);
      case Type.MapOf map -> map;
      default -> throw new IllegalStateException(type.toString());
    };
  }

  static boolean isMap(Type type) {
    return type.base() instanceof Type.SetOf || type.base() instanceof Type.MapOf;
  }
}
