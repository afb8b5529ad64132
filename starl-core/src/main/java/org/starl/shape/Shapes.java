package org.starl.shape;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.Supplier;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

/** The shapes of plain values, and those that are made of others. */
public final class Shapes {

  /** One byte, 0 or 1; {@code true} or {@code false}. */
  public static final Shape<Boolean> BOOL =
      new Leaf<>(
          "bool", (v, out) -> out.bool(v), WireReader::bool, Leaf::writeBool, Leaf::readBool);

  /** One byte, 0 to 255. */
  public static final Shape<Integer> U8 = integer("u8", (v, out) -> out.u8(v), WireReader::u8);

  /** Two bytes, 0 to 65,535. */
  public static final Shape<Integer> U16 = integer("u16", (v, out) -> out.u16(v), WireReader::u16);

  /** Four bytes, with a sign. */
  public static final Shape<Integer> INT = integer("i32", (v, out) -> out.i32(v), WireReader::i32);

  /** Eight bytes, with a sign. */
  public static final Shape<Long> LONG =
      new Leaf<>(
          "i64",
          (v, out) -> out.i64(v),
          WireReader::i64,
          (v, out) -> out.number(v),
          in -> in.number(""));

  /** Eight bytes, IEEE 754; neither infinite nor NaN. */
  public static final Shape<Double> REAL =
      new Leaf<>(
          "f64",
          (v, out) -> out.f64(v),
          WireReader::f64,
          (v, out) -> out.number(v),
          JsonReader::real);

  /** Its length in one byte, then at most 255 bytes of UTF-8. */
  public static final Shape<String> TEXT =
      new Leaf<>(
          "string",
          (v, out) -> out.string(v),
          WireReader::string,
          (v, out) -> out.string(v),
          in -> in.text(""));

  /** A robot's name, as {@link #TEXT}. */
  public static final Shape<RobotId> ROBOT =
      new Leaf<>(
          "robot",
          (v, out) -> out.robot(v),
          WireReader::robot,
          (v, out) -> out.string(v.name()),
          in -> new RobotId(in.robotName("")));

  /** A process: its robot, then its incarnation as {@link #LONG}. In JSON a string. */
  public static final Shape<ProcessId> PROCESS =
      TEXT.as("process", ProcessId::toString, ProcessId::parse)
          .bytes((v, out) -> out.process(v), WireReader::process);

  /** A set of robots, as a {@link #list}. */
  public static final Shape<Participants> PARTICIPANTS =
      new ListShape<>(ROBOT, 0xFFFF).as("set of robot", Participants::asList, Participants::of);

  /** Any JSON value; it has no bytes. */
  public static final Shape<Json> JSON =
      new Leaf<>(
          "json",
          (v, out) -> {
            throw new IllegalArgumentException("a value of unknown shape has no bytes");
          },
          in -> {
            throw new WireFormatException("a value of unknown shape");
          },
          (v, out) -> out.value(v.text()),
          in -> new Json(in.value()));

  /** A part of a record. */
  public static <T, V> Part<T, V> part(
      String name, Shape<V> shape, Function<? super T, ? extends V> get) {
    return new Part<>(name, shape, get);
  }

  /** A record of no parts. */
  public static <T> RecordShape<T> of(Class<T> type, Supplier<T> make) {
    return new RecordShape<>(type.getSimpleName(), type, List.of(), in -> make.get());
  }

  /** A record of one part. */
  public static <T, A> RecordShape<T> of(Class<T> type, Part<T, A> a, Function<A, T> make) {
    return new RecordShape<>(type.getSimpleName(), type, List.of(a), in -> make.apply(in.next(a)));
  }

  /** A record of two parts. */
  public static <T, A, B> RecordShape<T> of(
      Class<T> type, Part<T, A> a, Part<T, B> b, BiFunction<A, B, T> make) {
    return new RecordShape<>(
        type.getSimpleName(), type, List.of(a, b), in -> make.apply(in.next(a), in.next(b)));
  }

  /** A record of three parts. */
  public static <T, A, B, C> RecordShape<T> of(
      Class<T> type, Part<T, A> a, Part<T, B> b, Part<T, C> c, Make3<A, B, C, T> make) {
    return new RecordShape<>(
        type.getSimpleName(),
        type,
        List.of(a, b, c),
        in -> make.apply(in.next(a), in.next(b), in.next(c)));
  }

  /** A record of four parts. */
  public static <T, A, B, C, D> RecordShape<T> of(
      Class<T> type,
      Part<T, A> a,
      Part<T, B> b,
      Part<T, C> c,
      Part<T, D> d,
      Make4<A, B, C, D, T> make) {
    return new RecordShape<>(
        type.getSimpleName(),
        type,
        List.of(a, b, c, d),
        in -> make.apply(in.next(a), in.next(b), in.next(c), in.next(d)));
  }

  /** A record of five parts. */
  public static <T, A, B, C, D, E> RecordShape<T> of(
      Class<T> type,
      Part<T, A> a,
      Part<T, B> b,
      Part<T, C> c,
      Part<T, D> d,
      Part<T, E> e,
      Make5<A, B, C, D, E, T> make) {
    return new RecordShape<>(
        type.getSimpleName(),
        type,
        List.of(a, b, c, d, e),
        in -> make.apply(in.next(a), in.next(b), in.next(c), in.next(d), in.next(e)));
  }

  /** A record of six parts. */
  public static <T, A, B, C, D, E, F> RecordShape<T> of(
      Class<T> type,
      Part<T, A> a,
      Part<T, B> b,
      Part<T, C> c,
      Part<T, D> d,
      Part<T, E> e,
      Part<T, F> f,
      Make6<A, B, C, D, E, F, T> make) {
    return new RecordShape<>(
        type.getSimpleName(),
        type,
        List.of(a, b, c, d, e, f),
        in -> make.apply(in.next(a), in.next(b), in.next(c), in.next(d), in.next(e), in.next(f)));
  }

  /** A record of seven parts. */
  public static <T, A, B, C, D, E, F, G> RecordShape<T> of(
      Class<T> type,
      Part<T, A> a,
      Part<T, B> b,
      Part<T, C> c,
      Part<T, D> d,
      Part<T, E> e,
      Part<T, F> f,
      Part<T, G> g,
      Make7<A, B, C, D, E, F, G, T> make) {
    return new RecordShape<>(
        type.getSimpleName(),
        type,
        List.of(a, b, c, d, e, f, g),
        in ->
            make.apply(
                in.next(a),
                in.next(b),
                in.next(c),
                in.next(d),
                in.next(e),
                in.next(f),
                in.next(g)));
  }

  /** A constructor of 3 arguments. */
  @FunctionalInterface
  public interface Make3<A, B, C, T> {
    T apply(A a, B b, C c);
  }

  /** A constructor of 4 arguments. */
  @FunctionalInterface
  public interface Make4<A, B, C, D, T> {
    T apply(A a, B b, C c, D d);
  }

  /** A constructor of 5 arguments. */
  @FunctionalInterface
  public interface Make5<A, B, C, D, E, T> {
    T apply(A a, B b, C c, D d, E e);
  }

  /** A constructor of 6 arguments. */
  @FunctionalInterface
  public interface Make6<A, B, C, D, E, F, T> {
    T apply(A a, B b, C c, D d, E e, F f);
  }

  /** A constructor of 7 arguments. */
  @FunctionalInterface
  public interface Make7<A, B, C, D, E, F, G, T> {
    T apply(A a, B b, C c, D d, E e, F f, G g);
  }

  /** One of several records, each with its number in the bytes: 1, 2, ... in this order. */
  @SafeVarargs
  public static <T> SumShape<T> oneOf(Class<T> type, RecordShape<? extends T>... records) {
    List<RecordShape<? extends T>> all = new ArrayList<>();
    for (RecordShape<? extends T> each : records) {
      all.add(each);
    }
    return new SumShape<>(type.getSimpleName(), Collections.unmodifiableList(all));
  }

  /**
   * A list of at most {@code most} values. Its length is one byte if {@code most} is below 256, else
   * two.
   */
  public static <E> Shape<List<E>> list(Shape<E> element, int most) {
    return new ListShape<>(element, most);
  }

  /** A sorted set, as {@link #list}, in ascending order: equal sets have equal bytes. */
  public static <E extends Comparable<? super E>> Shape<SortedSet<E>> set(
      Shape<E> element, int most) {
    return ListShape.set(element, most);
  }

  /** A sorted map, as a {@link #list} of keys and values, in ascending order of the keys. */
  public static <K extends Comparable<? super K>, V> Shape<SortedMap<K, V>> map(
      Shape<K> key, Shape<V> value, int most) {
    return ListShape.map(key, value, most);
  }

  /** A value or none: a {@link #BOOL} in front of the bytes; in JSON {@code null} for none. */
  public static <V> Shape<Optional<V>> optional(Shape<V> shape) {
    return new Leaf<>(
        shape.describe() + " or null",
        shape.isReadable(),
        (v, out) -> {
          out.bool(v.isPresent());
          v.ifPresent(value -> shape.write(value, out));
        },
        in -> in.bool() ? Optional.of(shape.read(in)) : Optional.empty(),
        (v, out) -> {
          if (v.isPresent()) {
            shape.writeJson(v.get(), out);
          } else {
            out.ascii("null");
          }
        },
        in -> in.take("null") ? Optional.empty() : Optional.of(shape.readJson(in)));
  }

  /** A constant of an enum: one byte, its number from 0; in JSON its name. */
  public static <E extends Enum<E>> Shape<E> constant(Class<E> type) {
    E[] constants = type.getEnumConstants();
    return TEXT.<E>as(type.getSimpleName(), Enum::name, name -> Enum.valueOf(type, name))
        .bytes(
            (v, out) -> out.u8(v.ordinal()),
            in -> {
              int number = in.u8();
              if (number >= constants.length) {
                throw new WireFormatException(type.getSimpleName() + " " + number);
              }
              return constants[number];
            });
  }

  /**
   * A value that is written as text, such as a region.
   *
   * @param parse throws an {@link IllegalArgumentException} for other texts
   */
  public static <V> Shape<V> text(
      String type, Function<V, String> format, Function<String, ? extends V> parse) {
    return TEXT.<V>as(type, format, parse::apply)
        .bytes((v, out) -> out.text(format.apply(v)), in -> parse.apply(in.text()));
  }

  /**
   * Values that a trace shows in words, their {@code toString}. They are not read back, and have no
   * bytes.
   */
  public static <V> Shape<V> words() {
    return new Leaf<>(
        "words",
        false,
        (v, out) -> JSON.write(Json.string(v.toString()), out),
        in -> {
          throw new WireFormatException("words");
        },
        (v, out) -> out.string(v.toString()),
        in -> {
          throw in.expected("a value of a known shape");
        });
  }

  /** Integers of at least {@code least}. */
  public static Shape<Long> atLeast(long least, String what) {
    return within(least, Long.MAX_VALUE, what);
  }

  /** Integers from {@code least} to {@code most}. */
  public static Shape<Long> within(long least, long most, String what) {
    return LONG.where(value -> {
      if (value < least || value > most) {
        throw new IllegalArgumentException(what + " " + value);
      }
    });
  }

  private Shapes() {}

  private static Shape<Integer> integer(
      String name, BiConsumer<Integer, WireWriter> writer, Function<WireReader, Integer> reader) {
    return new Leaf<>(name, writer, reader, (v, out) -> out.number(v), in -> in.smallNumber(""));
  }
}
