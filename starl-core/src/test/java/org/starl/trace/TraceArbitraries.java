package org.starl.trace;

import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.shape.Sample;
import org.starl.shape.Samples;

/** Events and headers with the nastiest contents that their types allow. */
final class TraceArbitraries {

  private static final Var<Sample> SAMPLE = Var.of("a \"sample\"", Sample.SHAPE);

  private TraceArbitraries() {}

  static Arbitrary<RobotId> robots() {
    return Arbitraries.of("a", "bot0", "bot10", "Z9._-", "abcdefghijklmnopqrstuvwxyz012345")
        .map(RobotId::new);
  }

  static Arbitrary<TraceEvent> events() {
    return Combinators.combine(
            Arbitraries.integers().between(0, 10),
            Arbitraries.longs(),
            robots(),
            Samples.strings().list().ofSize(2),
            Samples.of(Samples.strings()),
            Samples.numbers().list().ofSize(5),
            robots())
        .as(TraceArbitraries::event);
  }

  static Arbitrary<TraceHeader> headers() {
    return Combinators.combine(
            Samples.strings(),
            Samples.strings(),
            Arbitraries.longs(),
            Arbitraries.longs(),
            Arbitraries.maps(Samples.strings(), Samples.strings()).ofMaxSize(4),
            robots().list().ofMaxSize(4))
        .as(TraceHeader::new);
  }

  private static TraceEvent event(
      int kind,
      long number,
      RobotId robot,
      List<String> texts,
      Sample sample,
      List<Double> values,
      RobotId other) {
    String a = texts.get(0);
    String b = texts.get(1);
    Pose pose = new Pose(values.get(0), values.get(1), values.get(2));
    return switch (kind) {
      case 0 -> TraceEvent.Action.of(number, robot, Instance.named(a), Sample.SHAPE, sample);
      case 1 -> new TraceEvent.Variable(number, robot, Instance.named(a), SAMPLE, sample);
      case 2 ->
          new TraceEvent.Sent(
              number, robot, a, Instance.named(b), ~number, (int) number, Sample.SHAPE, sample);
      case 3 ->
          new TraceEvent.Delivered(
              number, robot, other, Instance.named(a), ~number, Sample.SHAPE, sample);
      case 4 -> new TraceEvent.Dropped(number, robot, a, b);
      case 5 -> new TraceEvent.Moved(number, robot, pose, values.get(3), values.get(4));
      case 6 -> new TraceEvent.Joined(number, robot, pose, values.get(3));
      case 7 -> new TraceEvent.Fault(number, robot, a, b, a + b);
      case 8 -> new TraceEvent.Intervention(number, robot, ~number, a, b);
      case 9 ->
          TraceEvent.Action.of(number, robot, Instance.named(a), Note.SHAPE, new Note(b, texts));
      default -> new TraceEvent.Left(number, robot);
    };
  }
}
