package org.starl.sim.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;
import org.starl.comms.Codec;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.shape.Json;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;
import org.starl.trace.Instance;
import org.starl.trace.Note;
import org.starl.trace.TraceCodec;
import org.starl.trace.TraceEvent;
import org.starl.trace.Var;

class EventStoreTest {

  private static final int SIZE = 200_000;

  private static final RobotId BOT = new RobotId("bot0");
  private static final Var<Integer> X = Var.of("x", Shapes.INT);

  private static final IntFunction<TraceEvent> EVENT =
      i -> new TraceEvent.Variable(i, BOT, Instance.APP, X, i % 999);

  @Test
  void anInterruptedThreadWritesAndReadsTheFile() {
    EventStore store = new EventStore();
    Thread.currentThread().interrupt();
    try {
      for (int i = 0; i < SIZE; i++) {
        store.add(EVENT.apply(i), false);
      }
      assertThat(store.get(0)).isEqualTo(EVENT.apply(0));
    } finally {
      assertThat(Thread.interrupted()).isTrue();
    }
    for (int i = 0; i < SIZE; i++) {
      assertThat(store.get(i)).isEqualTo(EVENT.apply(i));
    }
  }

  /** What the store reads from its file, in which this event is the first. */
  private static TraceEvent again(TraceEvent... events) {
    EventStore store = new EventStore();
    for (TraceEvent event : events) {
      store.add(event, false);
    }
    for (int i = events.length; i < SIZE; i++) {
      store.add(EVENT.apply(i), false);
    }
    return store.get(0);
  }

  private record Point(int x) {
    static final RecordShape<Point> SHAPE =
        Shapes.of(Point.class, Shapes.part("x", Shapes.INT, Point::x), Point::new);
  }

  @Test
  void factsMessagesAndVariablesKeepTheirTypes() {
    Instance mutex = Instance.of("mutex", "m");
    for (TraceEvent event :
        List.of(
            TraceEvent.Action.of(0, BOT, mutex, Point.SHAPE.named("at"), new Point(1)),
            TraceEvent.Action.of(0, BOT, mutex, Note.SHAPE, new Note("so", List.of("a b"))),
            new TraceEvent.Variable(0, BOT, mutex, Var.of("at", Point.SHAPE), new Point(2)),
            new TraceEvent.Sent(0, BOT, "*", mutex, 1, 9, Point.SHAPE, new Point(3)),
            new TraceEvent.Delivered(0, BOT, BOT, mutex, 1, Point.SHAPE, new Point(4)))) {
      assertThat(again(event)).isEqualTo(event);
    }
  }

  @Test
  void aMessageOfBytesAloneIsReadAsItsText() {
    Codec<Point> bytes = Codec.of((point, out) -> out.i32(point.x()), in -> new Point(in.i32()));
    TraceEvent read =
        again(new TraceEvent.Sent(0, BOT, "*", Instance.APP, 1, 9, bytes, new Point(3)));
    assertThat(read)
        .isInstanceOfSatisfying(
            TraceEvent.Sent.class, sent -> assertThat(sent.message()).hasToString("Point[x=3]"));
  }

  @Test
  void variablesOfOneNameAndTwoTypesAreReadAsJson() {
    Var<Point> other = Var.of("x", Point.SHAPE);
    TraceEvent read =
        again(new TraceEvent.Variable(0, BOT, Instance.APP, other, new Point(3)), EVENT.apply(1));
    assertThat(read)
        .isInstanceOfSatisfying(
            TraceEvent.Variable.class,
            variable -> assertThat(variable.value()).isEqualTo(new Json("{\"x\":3}")));
  }

  @Test
  void theFileRoundsNumbersAsATraceDoes() {
    EventStore store = new EventStore();
    IntFunction<TraceEvent> moved =
        i -> {
          Pose pose = new Pose(i / 3.0, -i / 3.0, i % 9 / 3.0);
          return new TraceEvent.Moved(i, new RobotId("bot0"), pose, i / 3.0, 1 / 3.0);
        };
    for (int i = 0; i < SIZE; i++) {
      store.add(moved.apply(i), false);
    }
    int inMemory = SIZE % 4096;
    for (int i = 0; i < SIZE; i++) {
      TraceEvent event = moved.apply(i);
      assertThat(store.get(i)).isEqualTo(i < SIZE - inMemory ? TraceCodec.rounded(event) : event);
    }
  }
}
