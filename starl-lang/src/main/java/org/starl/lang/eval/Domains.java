package org.starl.lang.eval;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.starl.lang.tree.Automaton.Component;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/** The domains of a run's types. */
final class Domains {

  private static final int LETTERS = 26;

  private final Sizes sizes;
  private final List<String> opaque;
  private final Map<Type, Domain> known = new LinkedHashMap<>();

  /** The opaque types of whose elements 'choose' takes the first: these are not alike. */
  private final Set<String> chosen = new TreeSet<>();

  /**
   * @param opaque the names of the opaque types; the elements of the first are robots
   */
  Domains(Sizes sizes, List<String> opaque) {
    this.sizes = sizes;
    this.opaque = opaque;
  }

  Domain of(Type type) {
    Type base = type.base();
    Domain domain = known.get(base);
    if (domain == null) {
      domain = make(base);
      known.put(base, domain);
    }
    return domain;
  }

  /** Of a parameter that bounds of ranges have, its one value. */
  Domain of(Field parameter) {
    return number(parameter.name())
        .<Domain>map(n -> new Domain.Numbers(parameter.type(), n, n))
        .orElseGet(() -> of(parameter.type()));
  }

  Optional<Integer> number(String parameter) {
    return sizes.number(parameter);
  }

  void choose(Domain of) {
    chosen.addAll(of.ids());
  }

  Set<String> chosen() {
    return chosen;
  }

  List<Domain> of(List<Field> fields) {
    return fields.stream().map(field -> of(field.type())).toList();
  }

  /** The elements of all opaque types, as variables. */
  List<Field> elements() {
    List<Field> elements = new ArrayList<>();
    for (String name : opaque) {
      Type type = new Type.Opaque(name);
      names(name).forEach(element -> elements.add(new Field(element, type)));
    }
    return elements;
  }

  /** The values of {@link #elements}, in the same order. */
  List<Object> elementValues() {
    List<Object> values = new ArrayList<>();
    opaque.forEach(name -> values.addAll(of(new Type.Opaque(name)).values()));
    return values;
  }

  private Domain make(Type type) {
    return switch (type) {
      case Type.Bool bool -> new Domain.Bools();
      case Type.Num num ->
          switch (num) {
            case NAT -> new Domain.Numbers(num, 0, sizes.nat());
            case INT -> new Domain.Numbers(num, -sizes.nat(), sizes.nat());
            case TIME -> new Domain.Numbers(num, 0, sizes.time());
            case REAL -> new Domain.Numbers(num, -sizes.time(), sizes.time());
          };
      case Type.Range range ->
          new Domain.Numbers(
              range, range.low().at(sizes.numbers()), range.high().at(sizes.numbers()));
      case Type.Opaque ids -> new Domain.Ids(ids, names(ids.name()));
      case Type.Alias alias -> of(alias.target());
      case Type.Rec rec ->
          new Domain.Records(
              rec, rec.fields().stream().map(Field::name).toList(), of(rec.fields()));
      case Type.Sum sum ->
          new Domain.Sums(sum, sum.constructors().stream().map(c -> of(c.fields())).toList());
      case Type.SetOf set -> new Domain.Sets(set, numbered(set.element(), set));
      case Type.ListOf list -> new Domain.Lists(list, of(list.element()), sizes.nat());
      case Type.OptionOf option -> new Domain.Options(option, of(option.element()));
      case Type.MapOf map -> {
        Domain arguments =
            new Domain.Records(map, List.of(), map.arguments().stream().map(this::of).toList());
        requireFew(arguments, map.toString());
        yield new Domain.Maps(
            map, map.arguments().stream().map(this::of).toList(), of(map.result()));
      }
      case Type.StateOf state ->
          Domain.states(
              state.automaton(),
              state.automaton().state().stream().map(Component::type).map(this::of).toList());
    };
  }

  private Domain numbered(Type element, Type of) {
    Domain domain = of(element);
    requireFew(domain, of.toString());
    return domain;
  }

  /**
   * Requires that all values can be gone through.
   *
   * @param what needs them
   */
  void requireFew(Domain domain, String what) {
    if (domain.size() > Domain.MOST) {
      throw new TooLarge(
          "%s: %s values of %s at these sizes; expected at most %,d: give smaller sizes (--robots, --size, --nat, --time)"
              .formatted(
                  what,
                  domain.size() == Long.MAX_VALUE ? "too many" : "%,d".formatted(domain.size()),
                  domain.type(),
                  Domain.MOST));
    }
  }

  private List<String> names(String type) {
    int size = sizes.of(type);
    int place = opaque.indexOf(type);
    List<String> names = new ArrayList<>();
    for (int i = 0; i < size; i++) {
      if (place == 0) {
        names.add("bot" + i);
      } else if (place == 1 && size <= LETTERS) {
        names.add(String.valueOf((char) ('A' + i)));
      } else {
        names.add(type + i);
      }
    }
    return names;
  }
}
