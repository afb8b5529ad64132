package org.starl.sim.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Obstacles;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.sim.SimObserver;
import org.starl.sim.record.Layer;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;

class TraceLoaderTest {

  private static final RobotId BOT = new RobotId("bot1");

  /** Reports crashes and the end as violations, but blocks until {@code mayCheck} is zero. */
  private static final class BlockingMonitor implements Monitor {
    private final CountDownLatch mayCheck;

    BlockingMonitor(CountDownLatch mayCheck) {
      this.mayCheck = mayCheck;
    }

    @Override
    public List<String> lemmas() {
      return List.of("no_crash", "an_end");
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      try {
        mayCheck.await();
      } catch (InterruptedException e) {
        throw new IllegalStateException(e);
      }
      if (event instanceof TraceEvent.Fault fault && fault.name().equals(TraceEvent.Fault.CRASH)) {
        report.violated("no_crash", event.timeNs(), List.of(event.robot()), "crashed");
      }
    }

    @Override
    public void finish(long endNs, Report report) {
      report.violated("an_end", endNs, List.of(BOT), "ended");
    }
  }

  private static void crashing(List<SimObserver> observers) {
    var run = Wander.simulation(3).fault("crash(bot1,at=9s,restart=3s)");
    observers.forEach(run::observer);
    run.build().run();
  }

  private static void brokenAfterCrash(List<SimObserver> observers) {
    crashing(observers);
    throw new BadInput("a.trace:9: expected a line of a trace");
  }

  private static TraceLoader reading(
      Consumer<List<SimObserver>> trace, Supplier<List<Monitor>> monitors) {
    return new TraceLoader(new Recording(Obstacles.NONE, Layer.NONE), trace, monitors, List::of);
  }

  @Test
  void allEventsAreReadBeforeAnyIsChecked() throws InterruptedException {
    CountDownLatch isRead = new CountDownLatch(1);
    CountDownLatch mayCheck = new CountDownLatch(1);
    try (TraceLoader reading =
        reading(
            TraceLoaderTest::crashing,
            () -> {
              isRead.countDown();
              return List.of(new BlockingMonitor(mayCheck));
            })) {
      Recording recording = reading.recording();
      reading.start();
      isRead.await();
      assertThat(recording.isOver()).isTrue();
      assertThat(recording.isChecked()).isFalse();
      assertThat(recording.checked()).isZero();
      assertThat(new Cursor(recording).scene().robots()).isEmpty();
      assertThat(recording.marks())
          .isNotEmpty()
          .noneMatch(mark -> mark.kind() == Mark.Kind.VIOLATION);
      mayCheck.countDown();
      reading.await();
      assertThat(recording.isChecked()).isTrue();
      assertThat(recording.checked()).isEqualTo(recording.size());
    }
  }

  @Test
  void aViolationIsMarkedAtItsEvent() throws InterruptedException {
    try (TraceLoader reading =
        reading(
            TraceLoaderTest::crashing, () -> List.of(new BlockingMonitor(new CountDownLatch(0))))) {
      reading.start();
      reading.await();
      Recording recording = reading.recording();
      Mark crash = only(recording, Mark.Kind.CRASH).get(0);
      List<Mark> violations = only(recording, Mark.Kind.VIOLATION);
      assertThat(violations)
          .extracting(Mark::index)
          .containsExactly(crash.index(), lastOf(recording));
      assertThat(violations.get(0).timeNs()).isEqualTo(crash.timeNs());
      assertThat(reading.failure()).isNull();
    }
  }

  @Test
  void eventsBeforeABrokenLineAreKeptAndChecked() throws InterruptedException {
    try (TraceLoader reading =
        reading(
            TraceLoaderTest::brokenAfterCrash,
            () -> List.of(new BlockingMonitor(new CountDownLatch(0))))) {
      reading.start();
      reading.await();
      Recording recording = reading.recording();
      assertThat(recording.failure()).isEqualTo("a.trace:9: expected a line of a trace");
      assertThat(reading.failure()).isInstanceOf(BadInput.class);
      assertThat(recording.isChecked()).isTrue();
      assertThat(only(recording, Mark.Kind.VIOLATION))
          .singleElement()
          .extracting(Mark::text)
          .asString()
          .contains("no_crash");
    }
  }

  @Test
  void closingStopsTheChecking() throws InterruptedException {
    CountDownLatch isRead = new CountDownLatch(1);
    CountDownLatch mayCheck = new CountDownLatch(1);
    TraceLoader reading =
        reading(
            TraceLoaderTest::crashing,
            () -> {
              isRead.countDown();
              return List.of(new BlockingMonitor(mayCheck));
            });
    reading.start();
    isRead.await();
    Thread closing = new Thread(reading::close);
    closing.start();
    while (!reading.isClosed()) {
      Thread.onSpinWait();
    }
    mayCheck.countDown();
    closing.join();
    assertThat(reading.recording().isChecked()).isFalse();
    assertThat(only(reading.recording(), Mark.Kind.VIOLATION)).isEmpty();
  }

  private static List<Mark> only(Recording recording, Mark.Kind kind) {
    return recording.marks().stream().filter(mark -> mark.kind() == kind).toList();
  }

  private static int lastOf(Recording recording) {
    return recording.size() - 1;
  }
}
