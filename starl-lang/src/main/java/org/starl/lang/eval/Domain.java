// Longer than 500 lines because the subclasses of a sealed class are in one file, one for each kind
// of type.
package org.starl.lang.eval;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Type;

/** The values of a type at the sizes of a run, numbered from 0; each kind of type is a class here. */
public abstract sealed class Domain {

  /** The largest number of values that are ever gone through. */
  public static final long MOST = 1 << 20;

  private static final long TOO_MANY = Long.MAX_VALUE;

  private final Type type;
  private final long size;
  private final Set<String> ids;
  private final boolean isBounded;
  private final boolean isOpen;
  private final boolean isTruncated;
  private @Nullable List<Object> values;
  private @Nullable List<Object> instances;

  /**
   * @param parts the domains of the parts of its values
   */
  Domain(Type type, long size, List<Domain> parts) {
    this.type = type;
    this.size = size;
    ids =
        type instanceof Type.Opaque of
            ? Set.of(of.name())
            : parts.stream().flatMap(part -> part.ids.stream()).collect(Collectors.toSet());
    // The elements of a set and the arguments of a map are numbered, and so within the bounds.
    isBounded =
        this instanceof Numbers
            || this instanceof Lists
            || (!(this instanceof Sets) && parts.stream().anyMatch(part -> part.isBounded));
    isOpen =
        type instanceof Type.Num
            || this instanceof Lists
            || parts.stream().anyMatch(part -> part.isOpen);
    isTruncated =
        parts.stream().anyMatch(part -> part.isTruncated)
            || (this instanceof Maps
                && parts.subList(0, parts.size() - 1).stream().anyMatch(a -> a.isOpen));
  }

  /** Its type. */
  public Type type() {
    return type;
  }

  /** The number of its values; {@link Long#MAX_VALUE} also if there are more. */
  public long size() {
    return size;
  }

  /** All values, in the order of their numbers; {@link #size} is {@link #MOST} at most. */
  public List<Object> values() {
    if (values == null) {
      values = IntStream.range(0, (int) size).mapToObj(this::make).toList();
    }
    return values;
  }

  /** The opaque types of whose elements its values are made. */
  final Set<String> ids() {
    return ids;
  }

  /** Whether the type has more values, beyond the bounds. */
  public final boolean isOpen() {
    return isOpen;
  }

  /** Whether its values are maps that are known at arguments within the bounds alone, or have such. */
  final boolean isTruncated() {
    return isTruncated;
  }

  /** All values, then {@link #others}. */
  List<Object> instances() {
    if (instances == null) {
      List<Object> all = new ArrayList<>(values());
      if (isOpen) {
        all.addAll(others());
      }
      instances = List.copyOf(all);
    }
    return instances;
  }

  /** Whether the type has values that no instance stands for. */
  boolean hasMore() {
    return isOpen;
  }

  /** Values beyond the bounds: of numbers the next one, and one that stands for all after it; also below. */
  List<Object> others() {
    return List.of();
  }

  /**
   * The number of a value.
   *
   * @throws Beyond if the value is beyond the bounds
   */
  public abstract int number(Object value);

  /** The value of a number. */
  abstract Object make(int number);

  /** As in a source. */
  public abstract String text(Object value);

  /** Whether no part of the value is beyond the bounds. */
  public boolean contains(Object value) {
    return !isBounded || holds(value);
  }

  boolean holds(Object value) {
    return true;
  }

  /** The value with other elements of the opaque types in place of those that are in it. */
  public Object renamed(Object value, Renaming renaming) {
    return !ids.isEmpty() ? rename(value, renaming) : value;
  }

  Object rename(Object value, Renaming renaming) {
    return value;
  }

  /**
   * A number in which an element of an opaque type counts as what stands for it, which others may
   * share: equal for values that are equal after a renaming of elements with equal ones.
   */
  public long mark(Object value, Renaming marks) {
    return !ids.isEmpty() ? mix(0, marked(value, marks)) : mix(1, value.hashCode());
  }

  long marked(Object value, Renaming marks) {
    return value.hashCode();
  }

  /** Spreads {@code a}, then {@code b}: their order counts. */
  public static long mix(long a, long b) {
    long mixed = (a * 0x9E3779B97F4A7C15L ^ b) * 0xBF58476D1CE4E5B9L;
    return mixed ^ mixed >>> 29;
  }

  /**
   * Adds a text for each part of a value that differs: {@code req_set(bot0): {} -> {A}}.
   *
   * @param name of the value
   */
  public void tellChanges(String name, Object before, Object after, List<String> changes) {
    if (!before.equals(after)) {
      changes.add(name + ": " + text(before) + " -> " + text(after));
    }
  }

  /** Other elements for those of opaque types. */
  public interface Renaming {

    /** What stands for element {@code number} of the type. */
    int of(String type, int number);
  }

  static long times(long a, long b) {
    long high = Math.multiplyHigh(a, b);
    return high != 0 || a * b < 0 ? TOO_MANY : a * b;
  }

  static long power(long base, long exponent) {
    long product = 1;
    for (long i = 0; i < exponent && product != TOO_MANY && base > 1; i++) {
      product = times(product, base);
    }
    return exponent > 0 && base == 0 ? 0 : product;
  }

  private static String joined(List<String> texts) {
    return String.join(", ", texts);
  }

  /** {@code bool}. */
  static final class Bools extends Domain {

    Bools() {
      super(Type.Bool.BOOL, 2, List.of());
    }

    @Override
    public int number(Object value) {
      return (Boolean) value ? 1 : 0;
    }

    @Override
    Object make(int number) {
      return number == 1;
    }

    @Override
    public String text(Object value) {
      return value.toString();
    }
  }

  /** Whole numbers from {@code least} to {@code most}; fractions between them are contained. */
  static final class Numbers extends Domain {

    private final Num least;
    private final Num most;

    Numbers(Type type, long least, long most) {
      super(type, Math.max(0, most - least + 1), List.of());
      this.least = Num.of(least);
      this.most = Num.of(most);
    }

    @Override
    public int number(Object value) {
      Num num = (Num) value;
      if (!num.isWhole() || !holds(num)) {
        throw new Beyond();
      }
      return (int) (num.over() - least.over());
    }

    @Override
    Object make(int number) {
      return Num.of(least.over() + number);
    }

    /** What a value of a range is not, if it is none. */
    String outside(Object value) {
      return least.compareTo(most) > 0
          ? "the range " + least + ".." + most + " is empty"
          : value + " is not in " + least + ".." + most;
    }

    @Override
    boolean holds(Object value) {
      return least.compareTo((Num) value) <= 0 && most.compareTo((Num) value) >= 0;
    }

    @Override
    boolean hasMore() {
      return !Type.isNumber(type(), Type.Num::isWhole);
    }

    @Override
    List<Object> others() {
      Num next = Num.of(most.over() + 1);
      List<Object> above = List.of(next, Num.above(next.over()));
      List<Object> below = List.of(next.negative(), Num.above(next.over()).negative());
      return hasMore() || !isOpen()
          ? List.of()
          : type() == Type.Num.NAT ? above : Stream.of(above, below).flatMap(List::stream).toList();
    }

    @Override
    public String text(Object value) {
      return value.toString();
    }
  }

  /** The elements of an opaque type. */
  static final class Ids extends Domain {

    private final String name;
    private final List<String> texts;
    private final List<Object> all = new ArrayList<>();

    Ids(Type.Opaque type, List<String> texts) {
      super(type, texts.size(), List.of());
      name = type.name();
      this.texts = texts;
      for (int i = 0; i < texts.size(); i++) {
        all.add(new Id(i));
      }
    }

    @Override
    public int number(Object value) {
      return ((Id) value).number();
    }

    @Override
    Object make(int number) {
      return all.get(number);
    }

    @Override
    public String text(Object value) {
      return texts.get(number(value));
    }

    @Override
    Object rename(Object value, Renaming renaming) {
      return all.get(renaming.of(name, number(value)));
    }

    @Override
    long marked(Object value, Renaming marks) {
      return marks.of(name, number(value));
    }
  }

  /** Values of several parts, each with its domain: numbered as digits are. */
  static final class Product {

    final List<Domain> parts;
    final long size;

    Product(List<Domain> parts) {
      this.parts = List.copyOf(parts);
      size = parts.stream().mapToLong(Domain::size).reduce(1, Domain::times);
    }

    int number(Row row) {
      int number = 0;
      for (int i = 0; i < parts.size(); i++) {
        number = number * (int) parts.get(i).size() + parts.get(i).number(row.get(i));
      }
      return number;
    }

    Row make(int number) {
      Object[] items = new Object[parts.size()];
      int rest = number;
      for (int i = items.length - 1; i >= 0; i--) {
        int size = (int) parts.get(i).size();
        items[i] = parts.get(i).make(rest % size);
        rest /= size;
      }
      return new Row(items);
    }

    boolean holds(Row row) {
      return IntStream.range(0, parts.size()).allMatch(i -> parts.get(i).contains(row.get(i)));
    }

    boolean hasMore() {
      return parts.stream().anyMatch(Domain::hasMore) || instanceCount() > MOST;
    }

    private long instanceCount() {
      return parts.stream().mapToLong(part -> part.instances().size()).reduce(1, Domain::times);
    }

    /** The rows of instances, those of values alone left out. */
    List<Row> others() {
      if (instanceCount() > MOST) {
        return List.of();
      }
      List<Row> rows = List.of(Row.EMPTY);
      for (Domain part : parts) {
        List<Row> longer = new ArrayList<>();
        for (Row row : rows) {
          for (Object each : part.instances()) {
            List<Object> items = new ArrayList<>(List.of(row.items()));
            items.add(each);
            longer.add(Row.of(items));
          }
        }
        rows = longer;
      }
      return rows.stream().filter(row -> !holds(row)).toList();
    }

    Row rename(Row row, Renaming renaming) {
      return Row.of(
          IntStream.range(0, parts.size())
              .mapToObj(i -> parts.get(i).renamed(row.get(i), renaming))
              .toList());
    }

    long mark(Row row, Renaming marks) {
      long mark = 0;
      for (int i = 0; i < parts.size(); i++) {
        mark = mix(mark, parts.get(i).mark(row.get(i), marks));
      }
      return mark;
    }

    List<String> texts(Row row) {
      return IntStream.range(0, parts.size()).mapToObj(i -> parts.get(i).text(row.get(i))).toList();
    }
  }

  /** Records, and states of automata. */
  static final class Records extends Domain {

    final List<String> names;
    final Product fields;

    Records(Type type, List<String> names, List<Domain> fields) {
      super(type, new Product(fields).size, fields);
      this.names = names;
      this.fields = new Product(fields);
    }

    @Override
    boolean hasMore() {
      return fields.hasMore();
    }

    @Override
    List<Object> others() {
      return List.copyOf(fields.others());
    }

    @Override
    public int number(Object value) {
      return fields.number((Row) value);
    }

    @Override
    Object make(int number) {
      return fields.make(number);
    }

    @Override
    boolean holds(Object value) {
      return fields.holds((Row) value);
    }

    @Override
    Object rename(Object value, Renaming renaming) {
      return fields.rename((Row) value, renaming);
    }

    @Override
    long marked(Object value, Renaming marks) {
      return fields.mark((Row) value, marks);
    }

    @Override
    public String text(Object value) {
      List<String> texts = new ArrayList<>(fields.texts((Row) value));
      for (int i = 0; i < texts.size(); i++) {
        texts.set(i, names.get(i) + " := " + texts.get(i));
      }
      return type() + "(" + joined(texts) + ")";
    }

    @Override
    public void tellChanges(String name, Object before, Object after, List<String> changes) {
      for (int i = 0; i < names.size(); i++) {
        fields
            .parts
            .get(i)
            .tellChanges(
                name + "." + names.get(i), ((Row) before).get(i), ((Row) after).get(i), changes);
      }
    }
  }

  /** Sums: the values of each constructor after those of the one before. */
  static final class Sums extends Domain {

    final Type.Sum sum;
    final List<Product> forms;

    Sums(Type.Sum sum, List<List<Domain>> forms) {
      super(
          sum,
          forms.stream().mapToLong(form -> new Product(form).size).reduce(0, Sums::plus),
          forms.stream().flatMap(List::stream).toList());
      this.sum = sum;
      this.forms = forms.stream().map(Product::new).toList();
    }

    private static long plus(long a, long b) {
      return a > TOO_MANY - b ? TOO_MANY : a + b;
    }

    @Override
    boolean hasMore() {
      return forms.stream().anyMatch(Product::hasMore);
    }

    @Override
    List<Object> others() {
      List<Object> all = new ArrayList<>();
      for (int i = 0; i < forms.size(); i++) {
        int form = i;
        forms.get(i).others().forEach(fields -> all.add(new Form(form, fields)));
      }
      return all;
    }

    @Override
    public int number(Object value) {
      Form form = (Form) value;
      int before = forms.stream().limit(form.constructor()).mapToInt(f -> (int) f.size).sum();
      return before + forms.get(form.constructor()).number(form.fields());
    }

    @Override
    Object make(int number) {
      int rest = number;
      int constructor = 0;
      while (rest >= forms.get(constructor).size) {
        rest -= (int) forms.get(constructor++).size;
      }
      return new Form(constructor, forms.get(constructor).make(rest));
    }

    @Override
    boolean holds(Object value) {
      Form form = (Form) value;
      return forms.get(form.constructor()).holds(form.fields());
    }

    @Override
    Object rename(Object value, Renaming renaming) {
      Form form = (Form) value;
      return new Form(
          form.constructor(), forms.get(form.constructor()).rename(form.fields(), renaming));
    }

    @Override
    long marked(Object value, Renaming marks) {
      Form form = (Form) value;
      return mix(form.constructor(), forms.get(form.constructor()).mark(form.fields(), marks));
    }

    @Override
    public String text(Object value) {
      Form form = (Form) value;
      List<String> texts = forms.get(form.constructor()).texts(form.fields());
      String name = sum.constructors().get(form.constructor()).name();
      return texts.isEmpty() ? name : name + "(" + joined(texts) + ")";
    }
  }

  /** Options: {@code none} is number 0. */
  static final class Options extends Domain {

    private final Domain element;

    Options(Type type, Domain element) {
      super(type, element.size == TOO_MANY ? TOO_MANY : 1 + element.size, List.of(element));
      this.element = element;
    }

    @Override
    boolean hasMore() {
      return element.hasMore();
    }

    @Override
    List<Object> others() {
      return List.copyOf(element.others().stream().map(Optional::of).toList());
    }

    @Override
    public int number(Object value) {
      return ((Optional<?>) value).map(of -> 1 + element.number(of)).orElse(0);
    }

    @Override
    Object make(int number) {
      return number == 0 ? Optional.empty() : Optional.of(element.make(number - 1));
    }

    @Override
    boolean holds(Object value) {
      return ((Optional<?>) value).map(element::contains).orElse(true);
    }

    @Override
    Object rename(Object value, Renaming renaming) {
      return ((Optional<?>) value).map(of -> element.renamed(of, renaming));
    }

    @Override
    long marked(Object value, Renaming marks) {
      return ((Optional<?>) value).map(of -> element.mark(of, marks)).orElse(0L);
    }

    @Override
    public String text(Object value) {
      return ((Optional<?>) value).map(of -> "some(" + element.text(of) + ")").orElse("none");
    }
  }

  /** Sets; the number of a set has a bit for each element. */
  static final class Sets extends Domain {

    final Domain element;

    Sets(Type type, Domain element) {
      super(type, element.size > 62 ? TOO_MANY : 1L << element.size, List.of(element));
      this.element = element;
    }

    @Override
    public int number(Object value) {
      return ((BigInteger) value).intValue();
    }

    @Override
    Object make(int number) {
      return BigInteger.valueOf(number);
    }

    /** The elements, in order. */
    static List<Object> elements(Object set, Domain of) {
      BigInteger bits = (BigInteger) set;
      return IntStream.range(0, bits.bitLength()).filter(bits::testBit).mapToObj(of::make).toList();
    }

    @Override
    Object rename(Object value, Renaming renaming) {
      BigInteger renamed = BigInteger.ZERO;
      for (Object each : elements(value, element)) {
        renamed = renamed.setBit(element.number(element.renamed(each, renaming)));
      }
      return renamed;
    }

    @Override
    long marked(Object value, Renaming marks) {
      // A sum: the order of elements is that of their names.
      return elements(value, element).stream().mapToLong(each -> element.mark(each, marks)).sum();
    }

    @Override
    public String text(Object value) {
      return "{" + joined(elements(value, element).stream().map(element::text).toList()) + "}";
    }
  }

  /** Lists, the shorter ones first. */
  static final class Lists extends Domain {

    private final Domain element;
    private final int longest;

    Lists(Type type, Domain element, int longest) {
      super(
          type,
          IntStream.rangeClosed(0, longest)
              .mapToLong(length -> power(element.size, length))
              .reduce(0, Sums::plus),
          List.of(element));
      this.element = element;
      this.longest = longest;
    }

    private Product of(int length) {
      return new Product(java.util.Collections.nCopies(length, element));
    }

    @Override
    public int number(Object value) {
      Row row = (Row) value;
      if (row.size() > longest) {
        throw new Beyond();
      }
      return IntStream.range(0, row.size()).map(length -> (int) of(length).size).sum()
          + of(row.size()).number(row);
    }

    @Override
    Object make(int number) {
      int rest = number;
      int length = 0;
      while (rest >= of(length).size) {
        rest -= (int) of(length++).size;
      }
      return of(length).make(rest);
    }

    @Override
    boolean holds(Object value) {
      return ((Row) value).size() <= longest && of(((Row) value).size()).holds((Row) value);
    }

    @Override
    Object rename(Object value, Renaming renaming) {
      return of(((Row) value).size()).rename((Row) value, renaming);
    }

    @Override
    long marked(Object value, Renaming marks) {
      return of(((Row) value).size()).mark((Row) value, marks);
    }

    @Override
    public String text(Object value) {
      return "[" + joined(of(((Row) value).size()).texts((Row) value)) + "]";
    }
  }

  /** Total functions: a row of a result for each number of arguments. */
  static final class Maps extends Domain {

    final Product arguments;
    final Domain result;

    Maps(Type type, List<Domain> arguments, Domain result) {
      super(
          type,
          power(result.size, new Product(arguments).size),
          IntStream.rangeClosed(0, arguments.size())
              .mapToObj(i -> i == arguments.size() ? result : arguments.get(i))
              .toList());
      this.arguments = new Product(arguments);
      this.result = result;
    }

    private Product results() {
      return new Product(java.util.Collections.nCopies((int) arguments.size, result));
    }

    @Override
    public int number(Object value) {
      return results().number((Row) value);
    }

    @Override
    Object make(int number) {
      return results().make(number);
    }

    @Override
    boolean holds(Object value) {
      for (Object item : ((Row) value).items()) {
        if (!result.contains(item)) {
          return false;
        }
      }
      return true;
    }

    @Override
    Object rename(Object value, Renaming renaming) {
      Row row = (Row) value;
      Object[] renamed = new Object[row.size()];
      for (int i = 0; i < renamed.length; i++) {
        int to = arguments.number(arguments.rename(arguments.make(i), renaming));
        renamed[to] = result.renamed(row.get(i), renaming);
      }
      return new Row(renamed);
    }

    @Override
    long marked(Object value, Renaming marks) {
      long sum = 0; // the order of arguments is that of their names
      for (int i = 0; i < ((Row) value).size(); i++) {
        long at = arguments.mark(arguments.make(i), marks);
        sum += mix(at, result.mark(((Row) value).get(i), marks));
      }
      return sum;
    }

    @Override
    public String text(Object value) {
      List<String> texts = new ArrayList<>();
      for (int i = 0; i < ((Row) value).size(); i++) {
        texts.add(
            joined(arguments.texts(arguments.make(i)))
                + " -> "
                + result.text(((Row) value).get(i)));
      }
      return "[" + joined(texts) + "]";
    }

    @Override
    public void tellChanges(String name, Object before, Object after, List<String> changes) {
      for (int i = 0; i < ((Row) before).size(); i++) {
        String at = name + "(" + joined(arguments.texts(arguments.make(i))) + ")";
        result.tellChanges(at, ((Row) before).get(i), ((Row) after).get(i), changes);
      }
    }
  }

  /** The domain of the states of an automaton. */
  static Records states(Automaton automaton, List<Domain> components) {
    return new Records(
        new Type.StateOf(automaton),
        automaton.state().stream().map(Automaton.Component::name).toList(),
        components);
  }
}
