package org.starl.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.platform.Timer;
import org.starl.sim.check.Campaign;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.kernel.RobotError;
import org.starl.sim.kernel.Stalled;
import org.starl.time.Time;

/** A run in which virtual time stands still ends with robot, time, cause and stack. */
class StalledRunTest {

  /** Calls its body after half a second. */
  private static final class App extends LogicThread {
    private final Consumer<App> body;

    App(GlobalVarHolder gvh, Consumer<App> body) {
      super(gvh);
      this.body = body;
    }

    @Override
    public List<Object> callStarL() {
      sleep(500);
      body.accept(this);
      return returnResults();
    }

    void loopOnATrueCondition() {
      while (gvh.plat.clock.nowNs() >= 0) {
        await(() -> true);
      }
    }

    void sleepForEver() {
      while (gvh.plat.clock.nowNs() >= 0) {
        sleep(60_000);
      }
    }

    void loopWithoutSleep() {
      while (gvh.plat.clock.nowNs() >= 0) {
        sleep(0);
      }
    }

    void spin() {
      long spins = 0;
      while (gvh.plat.clock.nowNs() < 1_000_000_000) {
        spins++;
      }
      throw new AssertionError("time passed after " + spins + " spins");
    }

    void timerAtOnce() {
      Timer[] timer = new Timer[1];
      timer[0] = gvh.plat.timers.timer(() -> timer[0].set(gvh.plat.clock.nowNs()));
      timer[0].set(gvh.plat.clock.nowNs());
      sleep(1000);
    }
  }

  private static Simulation.Builder simulation(CarrierKind kind, Consumer<App> body) {
    return Simulation.builder()
        .name("stalls")
        .seed(7)
        .robots(1, gvh -> new App(gvh, body))
        .carriers(kind)
        .actionLimit(Duration.ofMillis(100));
  }

  private static SimulationFailed failureOf(CarrierKind kind, Consumer<App> body) {
    SimulationFailed failed =
        catchThrowableOfType(SimulationFailed.class, simulation(kind, body).build()::run);
    assertThat(failed).hasMessageStartingWith("stalls, seed 7: bot0 at 0.500000000 s: Stalled: ");
    assertThat(failed).hasCauseInstanceOf(RobotError.class);
    assertThat(failed).hasRootCauseInstanceOf(Stalled.class);
    return failed;
  }

  private static void assertStackNames(SimulationFailed failed, String method) {
    assertThat(Arrays.stream(failed.getCause().getCause().getStackTrace()))
        .as("the stack of the stalled action")
        .anyMatch(frame -> frame.getMethodName().contains(method));
  }

  @ParameterizedTest
  @EnumSource
  void aLoopOfAwaitsWhoseConditionHoldsEndsTheRun(CarrierKind kind) {
    SimulationFailed failed = failureOf(kind, App::loopOnATrueCondition);
    assertThat(failed).hasMessageContaining("100000 awaits in one action");
    assertThat(failed)
        .message()
        .matches("(?s).*; at StalledRunTest.java:\\d+ .loopOnATrueCondition.*");
    assertStackNames(failed, "loopOnATrueCondition");
  }

  @ParameterizedTest
  @EnumSource
  void aLoopThatSleepsZeroEndsTheRun(CarrierKind kind) {
    SimulationFailed failed = failureOf(kind, App::loopWithoutSleep);
    assertThat(failed).hasMessageContaining("100000 actions at one virtual time");
    assertStackNames(failed, "loopWithoutSleep");
  }

  @ParameterizedTest
  @EnumSource
  void aLoopThatNeitherWaitsNorEndsEndsTheRun(CarrierKind kind) {
    SimulationFailed failed = failureOf(kind, App::spin);
    assertThat(failed).hasMessageContaining("of processor time and does not end");
    assertThat(failed).message().matches("(?s).*; at StalledRunTest.java:\\d+ .spin.*");
    assertStackNames(failed, "spin");
  }

  @ParameterizedTest
  @EnumSource
  void aTimerThatIsSetToTheSameTimeForEverEndsTheRun(CarrierKind kind) {
    SimulationFailed failed = failureOf(kind, App::timerAtOnce);
    assertThat(failed).hasMessageContaining("100000 actions at one virtual time");
    assertStackNames(failed, "timerAtOnce");
  }

  @Test
  void aRunWithoutATimeLimitEndsAfterTwentyMinutes() {
    SimResult result =
        simulation(CarrierKind.best(), App::sleepForEver)
            .settings(SimSettings.defaults())
            .build()
            .run();
    assertThat(result.isFinished()).isFalse();
    assertThat(result.endNs()).isEqualTo(1200 * Time.NS_PER_S);
  }

  @Test
  void anObserverMayComputeLongAfterTheLastEvent() {
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    SimObserver slow =
        new SimObserver() {
          @Override
          public void finished(SimResult result) {
            long fromNs = threads.getCurrentThreadCpuTime();
            while (threads.getCurrentThreadCpuTime() - fromNs < 900_000_000) {
              Thread.onSpinWait();
            }
          }
        };
    assertThat(simulation(CarrierKind.best(), app -> {}).observer(slow).build().run().isFinished())
        .isTrue();
  }

  @Test
  void aCampaignGoesOnAfterAStalledRun() throws InterruptedException {
    List<RunOutcome.Verdict> verdicts =
        new Campaign(1, 4)
                .run(
                    seed ->
                        RunOutcome.of(
                            simulation(CarrierKind.best(), seed == 2 ? App::spin : app -> {})
                                .seed(seed)
                                .build()
                                .run()),
                    (finished, planned, bad) -> {})
                .runs()
                .stream()
                .map(run -> run.outcome().verdict())
                .toList();
    assertThat(verdicts)
        .containsExactlyElementsOf(
            LongStream.rangeClosed(1, 4)
                .mapToObj(s -> s == 2 ? RunOutcome.Verdict.FAILED : RunOutcome.Verdict.GOOD)
                .toList());
  }
}
