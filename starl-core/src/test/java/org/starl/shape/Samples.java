package org.starl.shape;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

/** Values with the nastiest contents that their types allow. */
public final class Samples {

  private Samples() {}

  public static Arbitrary<String> strings() {
    Arbitrary<String> nasty =
        Arbitraries.of(
            "",
            "\"",
            "\\",
            "\\u0041",
            "a\nb\r\tc\b\f\0",
            "\u007f\u0085\u2028\u2029",
            "\ud83e\udd16",
            "\ud83e",
            "\udd16\ud83e",
            "{\"kind\":\"end\"}",
            "Grüße 世界");
    // Every UTF-16 unit, so that surrogates stand alone now and then.
    Arbitrary<String> any = Arbitraries.strings().withCharRange('\0', '\uffff').ofMaxLength(12);
    return Arbitraries.oneOf(nasty, any, Arbitraries.strings().ascii().ofMaxLength(20));
  }

  public static Arbitrary<Double> numbers() {
    Arbitrary<Double> nasty =
        Arbitraries.of(
            0.0,
            -0.0,
            0.0005,
            -0.0005,
            0.00049999999999999,
            1.0005,
            4.35,
            999.9995,
            9.999999995e11,
            1e12,
            -1e12,
            9.007199254740993e12,
            Math.PI,
            -Math.PI,
            Double.MIN_VALUE,
            Double.MAX_VALUE,
            -Double.MAX_VALUE);
    Arbitrary<Double> bits =
        Arbitraries.longs().map(Double::longBitsToDouble).filter(Double::isFinite);
    Arbitrary<Double> usual =
        Arbitraries.integers().between(-9_999_999, 9_999_999).map(i -> i / 1e4);
    return Arbitraries.oneOf(nasty, bits, usual);
  }

  private static Arbitrary<Long> integers() {
    return Arbitraries.oneOf(Arbitraries.longs(), Arbitraries.of(0L, Long.MIN_VALUE));
  }

  private static Arbitrary<RobotId> robots() {
    return Arbitraries.of("a", "bot0", "Z9._-").map(RobotId::new);
  }

  /** Texts whose UTF-8 has at most 255 bytes. */
  static Arbitrary<String> wellFormed() {
    return strings().filter(text -> text.chars().noneMatch(c -> Character.isSurrogate((char) c)));
  }

  /** Samples with such texts. */
  public static Arbitrary<Sample> of(Arbitrary<String> texts) {
    Arbitrary<Sample> numbers =
        Combinators.combine(
                Arbitraries.integers().between(0, 0xFF),
                Arbitraries.integers().between(0, 0xFFFF),
                Arbitraries.integers(),
                integers(),
                numbers(),
                Arbitraries.of(true, false))
            .as(Sample.Numbers::new);
    Arbitrary<Sample> names =
        Combinators.combine(
                texts,
                robots(),
                Combinators.combine(robots(), Arbitraries.longs().between(1, Long.MAX_VALUE))
                    .as(ProcessId::new),
                Arbitraries.of(Sample.Colour.class),
                Combinators.combine(numbers(), numbers()).as(Sample.Place::new))
            .as(Sample.Names::new);
    Arbitrary<SortedMap<RobotId, List<String>>> maps =
        Arbitraries.maps(robots(), texts.list().ofMaxSize(2))
            .map(map -> Collections.unmodifiableSortedMap(new TreeMap<>(map)));
    Arbitrary<Sample> several =
        Combinators.combine(
                texts.list().ofMaxSize(3),
                integers().set().ofMaxSize(3).map(TreeSet::new),
                maps,
                texts.optional(),
                Arbitraries.oneOf(numbers, names).map(Optional::of))
            .as(Sample.Several::new);
    return Arbitraries.oneOf(Arbitraries.of(new Sample.Nothing()), numbers, names, several);
  }
}
