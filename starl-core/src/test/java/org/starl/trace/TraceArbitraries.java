package org.starl.trace;

import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;

/** Events and headers with the nastiest contents that their types allow. */
final class TraceArbitraries {

  private TraceArbitraries() {}

  static Arbitrary<String> strings() {
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

  static Arbitrary<Double> numbers() {
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

  static Arbitrary<RobotId> robots() {
    return Arbitraries.of("a", "bot0", "bot10", "Z9._-", "abcdefghijklmnopqrstuvwxyz012345")
        .map(RobotId::new);
  }

  static Arbitrary<TraceEvent> events() {
    return Combinators.combine(
            Arbitraries.integers().between(0, 9),
            Arbitraries.longs(),
            robots(),
            strings().list().ofSize(3),
            numbers().list().ofSize(5),
            robots())
        .as(TraceArbitraries::event);
  }

  static Arbitrary<TraceHeader> headers() {
    return Combinators.combine(
            strings(),
            strings(),
            Arbitraries.longs(),
            Arbitraries.longs(),
            Arbitraries.maps(strings(), strings()).ofMaxSize(4),
            robots().list().ofMaxSize(4))
        .as(TraceHeader::new);
  }

  private static TraceEvent event(
      int kind,
      long number,
      RobotId robot,
      List<String> texts,
      List<Double> values,
      RobotId other) {
    String a = texts.get(0);
    String b = texts.get(1);
    String c = texts.get(2);
    Pose pose = new Pose(values.get(0), values.get(1), values.get(2));
    return switch (kind) {
      case 0 -> new TraceEvent.Action(number, robot, a, b, texts.subList(0, (int) (number & 3)));
      case 1 -> new TraceEvent.Variable(number, robot, a, b, c);
      case 2 -> new TraceEvent.Sent(number, robot, a, b, ~number, (int) number, c);
      case 3 -> new TraceEvent.Delivered(number, robot, other, a, ~number, b);
      case 4 -> new TraceEvent.Dropped(number, robot, a, b);
      case 5 -> new TraceEvent.Moved(number, robot, pose, values.get(3), values.get(4));
      case 6 -> new TraceEvent.Joined(number, robot, pose, values.get(3));
      case 7 -> new TraceEvent.Fault(number, robot, a, b);
      case 8 -> new TraceEvent.Intervention(number, robot, ~number, a, b);
      default -> new TraceEvent.Left(number, robot);
    };
  }
}
