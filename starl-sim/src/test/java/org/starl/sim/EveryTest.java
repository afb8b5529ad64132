package org.starl.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.platform.Timer;
import org.starl.sim.fault.FaultPlan;

/** {@link LogicThread#every}: a second flow beside {@code callStarL}, or beside steps. */
class EveryTest {

  private static final long MS = 1_000_000;

  private final List<Long> ticksMs = new ArrayList<>();
  private final List<Long> stepsMs = new ArrayList<>();
  private long createdMs;

  private final class Ticker extends LogicThread {
    private final Function<Ticker, List<Object>> body;

    Ticker(GlobalVarHolder gvh, Function<Ticker, List<Object>> body) {
      super(gvh);
      this.body = body;
    }

    @Override
    public List<Object> callStarL() {
      return body.apply(this);
    }

    Timer tick(long periodMs) {
      return every(periodMs, () -> ticksMs.add(gvh.plat.clock.nowNs() / MS));
    }

    List<Object> waitMs(long ms) {
      sleep(ms);
      return List.of();
    }
  }

  private void run(Function<Ticker, List<Object>> body, String... faults) {
    Simulation.Builder simulation =
        Simulation.builder().robots(1, gvh -> new Ticker(gvh, body)).seed(1);
    for (String fault : faults) {
      simulation.faults(FaultPlan.parse(fault));
    }
    simulation.build().run();
  }

  @Test
  void itRunsOncePerPeriodWhileTheProgramWaits() {
    run(app -> {
      app.tick(100);
      return app.waitMs(350);
    });
    assertThat(ticksMs).containsExactly(100L, 200L, 300L);
  }

  @Test
  void itCanBeCancelled() {
    run(app -> {
      Timer timer = app.tick(100);
      app.waitMs(250);
      timer.cancel();
      return app.waitMs(500);
    });
    assertThat(ticksMs).containsExactly(100L, 200L);
  }

  @Test
  void itEndsWithTheProgramAndTheNextOneHasItsOwn() {
    run(
        app -> {
          app.tick(100);
          return app.waitMs(250);
        },
        "crash(bot0,at=150ms,restart=1s)");
    // The clock goes on; the program that starts again ticks from its own start.
    assertThat(ticksMs).hasSize(3).startsWith(100L);
    assertThat(ticksMs.get(1)).isGreaterThan(1_150L);
    assertThat(ticksMs.get(2) - ticksMs.get(1)).isEqualTo(100);
  }

  /** Steps and ticks on one strand, where each takes 30 ms, so that they hold up each other. */
  private final class Stepper extends LogicThread {
    Stepper(GlobalVarHolder gvh) {
      super(gvh, 100);
      createdMs = gvh.plat.clock.nowNs() / MS;
      every(90, () -> ticksMs.add(gvh.plat.clock.nowNs() / MS));
    }

    @Override
    protected boolean step() {
      stepsMs.add(gvh.plat.clock.nowNs() / MS);
      return stepsMs.size() < 50;
    }
  }

  @Test
  void whatComesLateDoesNotMakeTheNextLater() {
    Simulation.builder()
        .robots(1, Stepper::new)
        .seed(1)
        .faults(FaultPlan.parse("compute(bot0,30ms)"))
        .build()
        .run();
    assertLate(stepsMs, createdMs, 100);
    assertLate(ticksMs, createdMs + 90, 90);
  }

  /** Some of these times are late, none by more than two actions. */
  private static void assertLate(List<Long> timesMs, long firstMs, long periodMs) {
    List<Long> lateMs = new ArrayList<>();
    for (int i = 0; i < timesMs.size(); i++) {
      lateMs.add(timesMs.get(i) - firstMs - i * periodMs);
    }
    assertThat(lateMs).allMatch(ms -> ms >= 0 && ms <= 60).anyMatch(ms -> ms > 0);
  }

  @Test
  void aPeriodIsAboveZero() {
    assertThatThrownBy(() -> run(app -> List.of(app.tick(0))))
        .hasRootCauseMessage("period 0 ms: expected above 0");
  }
}
