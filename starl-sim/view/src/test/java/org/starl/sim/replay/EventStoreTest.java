package org.starl.sim.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.trace.TraceCodec;
import org.starl.trace.TraceEvent;

class EventStoreTest {

  private static final int SIZE = 200_000;

  private static final IntFunction<TraceEvent> EVENT =
      i -> new TraceEvent.Variable(i, new RobotId("bot0"), "app", "x", "" + i % 999);

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
