package org.starl.sim.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.starl.platform.StrandClosed;
import org.starl.platform.Timer;

/** One thing at a time, on each carrier. */
class KernelTest {

  private final List<String> log = new ArrayList<>();

  @Test
  void virtualThreadsAreTheDefaultSinceJava24() {
    if (Runtime.version().feature() >= 24) {
      assertThat(CarrierKind.fallbackReason()).isNull();
      assertThat(CarrierKind.best()).isEqualTo(CarrierKind.VIRTUAL);
    } else {
      assertThat(CarrierKind.fallbackReason()).contains("need Java 24 or later");
      assertThat(CarrierKind.best()).isEqualTo(CarrierKind.PLATFORM);
    }
  }

  @ParameterizedTest
  @EnumSource
  void anAppSleepsWhileHandlersRun(CarrierKind kind) {
    try (Kernel kernel = new Kernel(kind)) {
      SimStrand robot = kernel.strand("robot0");
      robot.start(() -> {
        log.add("app " + kernel.nowNs());
        robot.sleepUntil(100);
        log.add("app " + kernel.nowNs());
      });
      kernel.schedule(50, robot, () -> log.add("handler " + kernel.nowNs()));
      kernel.schedule(100, () -> log.add("world " + kernel.nowNs()));
      kernel.run(1_000, () -> false);
      assertThat(log).containsExactly("app 0", "handler 50", "world 100", "app 100");
      assertThat(kernel.nowNs()).isEqualTo(100);
      assertThat(kernel.events()).isEqualTo(4);
    }
  }

  @ParameterizedTest
  @EnumSource
  void prefetchingDoesNotChangeTheOrder(CarrierKind kind) {
    List<String> plain = runOfACrowd(kind, strand -> {});
    List<String> hinted =
        runOfACrowd(
            kind,
            strand -> {
              strand.prefetch(strand, strand.name(), new long[9]);
              strand.prefetch(new Object());
            });
    assertThat(plain).hasSize(3 * 39 + 1).isEqualTo(hinted);
  }

  /** Forty apps with events at one instant; the first app closes the strand of the last one. */
  private List<String> runOfACrowd(CarrierKind kind, Consumer<SimStrand> atStart) {
    log.clear();
    try (Kernel kernel = new Kernel(kind)) {
      List<SimStrand> crowd = new ArrayList<>();
      for (int i = 0; i < 40; i++) {
        SimStrand robot = kernel.strand("robot" + i);
        crowd.add(robot);
        atStart.accept(robot);
        Timer cancelled = robot.timer(() -> log.add("cancelled"));
        robot.start(() -> {
          cancelled.set(1_000_001);
          robot.sleepUntil(1_000_000);
          log.add(robot + " woke");
          cancelled.cancel();
          robot.sleepUntil(2_000_000);
          log.add(robot + " ends");
        });
        kernel.schedule(500_000, robot, () -> log.add(robot + " is shown"));
      }
      kernel.schedule(
          400_000,
          () -> {
            crowd.get(39).close();
            log.add("closed");
          });
      kernel.run(3_000_000, () -> false);
    }
    return List.copyOf(log);
  }

  @ParameterizedTest
  @EnumSource
  void aSleepUntilThePastReturnsAfterAllDueEvents(CarrierKind kind) {
    try (Kernel kernel = new Kernel(kind)) {
      SimStrand robot = kernel.strand("robot0");
      robot.start(() -> {
        robot.post(() -> log.add("posted"));
        robot.sleepUntil(-5);
        log.add("app " + kernel.nowNs());
      });
      kernel.schedule(0, () -> log.add("world"));
      kernel.run(1_000, () -> false);
      assertThat(log).containsExactly("world", "posted", "app 0");
    }
  }

  @ParameterizedTest
  @EnumSource
  void anAwaitingAppResumesDirectlyAfterThePieceThatMakesItsConditionTrue(CarrierKind kind) {
    try (Kernel kernel = new Kernel(kind)) {
      SimStrand robot = kernel.strand("robot0");
      int[] received = {0};
      robot.start(() -> {
        boolean held = robot.awaitUntil(() -> received[0] == 2, Long.MAX_VALUE);
        log.add("app " + held + " at " + kernel.nowNs());
      });
      for (int at = 10; at <= 30; at += 10) {
        kernel.schedule(at, robot, () -> log.add("received " + ++received[0]));
        kernel.schedule(at, () -> log.add("world " + kernel.nowNs()));
      }
      kernel.run(1_000, () -> false);
      assertThat(log)
          .containsExactly(
              "received 1",
              "world 10",
              "received 2",
              "app true at 20",
              "world 20",
              "received 3",
              "world 30");
    }
  }

  @ParameterizedTest
  @EnumSource
  void anAwaitEndsAtItsDeadline(CarrierKind kind) {
    try (Kernel kernel = new Kernel(kind)) {
      SimStrand robot = kernel.strand("robot0");
      robot.start(() -> {
        log.add("met at once " + robot.awaitUntil(() -> true, 0));
        log.add("met " + robot.awaitUntil(() -> false, 70) + " at " + kernel.nowNs());
        log.add("met " + robot.awaitUntil(() -> kernel.nowNs() == 90, 90));
      });
      kernel.run(1_000, () -> false);
      assertThat(log).containsExactly("met at once true", "met false at 70", "met true");
    }
  }

  @ParameterizedTest
  @EnumSource
  void settingATimerAgainReplacesItsExpiry(CarrierKind kind) {
    try (Kernel kernel = new Kernel(kind)) {
      SimStrand robot = kernel.strand("robot0");
      Timer timer = robot.timer(() -> log.add("expired " + kernel.nowNs()));
      Timer cancelled = robot.timer(() -> log.add("never"));
      kernel.schedule(
          0,
          robot,
          () -> {
            timer.set(40);
            timer.set(20);
            cancelled.set(20);
          });
      kernel.schedule(
          20,
          robot,
          () -> {
            // Both have expired already, and wait for the strand.
            cancelled.cancel();
            timer.set(0);
            assertThat(timer.isSet()).isTrue();
            log.add("set anew");
          });
      kernel.run(10, () -> false);
      kernel.schedule(20, robot, () -> log.add("between"));
      kernel.run(1_000, () -> false);
      assertThat(log).containsExactly("set anew", "between", "expired 20");
      assertThat(timer.isSet()).isFalse();
      assertThat(cancelled.isSet()).isFalse();
    }
  }

  @ParameterizedTest
  @EnumSource
  void closingAStrandStopsItsPiecesAndUnwindsItsApp(CarrierKind kind) {
    try (Kernel kernel = new Kernel(kind)) {
      SimStrand robot = kernel.strand("robot0");
      Timer timer = robot.timer(() -> log.add("timer"));
      robot.start(() -> {
        try {
          robot.sleepUntil(1_000);
        } catch (StrandClosed e) {
          log.add("told");
          throw e;
        } finally {
          log.add("finally at " + kernel.nowNs());
          robot.post(() -> log.add("posted"));
        }
      });
      kernel.schedule(0, robot, () -> timer.set(60));
      kernel.schedule(60, robot, () -> log.add("handler"));
      kernel.schedule(50, robot::close);
      kernel.run(2_000, () -> false);
      timer.cancel();
      timer.set(3_000);
      kernel.schedule(3_000, robot, () -> log.add("late"));
      robot.post(() -> log.add("late"));
      kernel.run(4_000, () -> false);
      assertThat(log).containsExactly("told", "finally at 50");
      assertThat(robot.isClosed()).isTrue();
      assertThat(timer.isSet()).isFalse();
    }
  }

  @ParameterizedTest
  @EnumSource
  void closingTheKernelUnwindsEveryAppInOrder(CarrierKind kind) {
    Kernel kernel = new Kernel(kind);
    for (int i = 0; i < 3; i++) {
      SimStrand robot = kernel.strand("robot" + i);
      robot.start(() -> {
        try {
          robot.awaitUntil(() -> false, Long.MAX_VALUE);
        } finally {
          log.add(robot.name());
        }
      });
    }
    kernel.run(1_000, () -> false);
    assertThat(log).isEmpty();
    kernel.close();
    assertThat(log).containsExactly("robot0", "robot1", "robot2");
    kernel.close();
    assertThatThrownBy(() -> kernel.run(2_000, () -> false))
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("closed");
  }

  @ParameterizedTest
  @EnumSource
  void anAppThatClosesItsOwnStrandEndsAtItsNextWait(CarrierKind kind) {
    try (Kernel kernel = new Kernel(kind)) {
      SimStrand robot = kernel.strand("robot0");
      robot.start(() -> {
        robot.close();
        log.add("leaving");
        robot.sleepUntil(10);
        log.add("never");
      });
      kernel.run(1_000, () -> false);
      assertThat(log).containsExactly("leaving");
    }
  }

  @ParameterizedTest
  @EnumSource
  void aRobotClosedByAnotherEndsAfterTheCallersPiece(CarrierKind kind) {
    try (Kernel kernel = new Kernel(kind)) {
      SimStrand victim = kernel.strand("victim");
      SimStrand killer = kernel.strand("killer");
      victim.start(() -> {
        try {
          victim.sleepUntil(100);
        } finally {
          log.add("unwound");
        }
      });
      killer.start(() -> {
        killer.sleepUntil(50);
        victim.close();
        log.add("goes on");
      });
      kernel.run(1_000, () -> false);
      assertThat(log).containsExactly("goes on", "unwound");
    }
  }

  @ParameterizedTest
  @EnumSource
  void aHandlerThatClosesItsStrandEndsTheAwaitingAppAfterwards(CarrierKind kind) {
    try (Kernel kernel = new Kernel(kind)) {
      SimStrand robot = kernel.strand("robot0");
      robot.start(() -> {
        try {
          robot.awaitUntil(robot::isClosed, Long.MAX_VALUE);
          log.add("never");
        } finally {
          log.add("unwound");
        }
      });
      kernel.schedule(
          5,
          robot,
          () -> {
            robot.close();
            log.add("handler is over");
          });
      kernel.run(1_000, () -> false);
      assertThat(log).containsExactly("handler is over", "unwound");
    }
  }

  @Test
  void runStopsAtTheGivenTime() {
    try (Kernel kernel = new Kernel(CarrierKind.PLATFORM)) {
      for (int at = 0; at < 5; at++) {
        kernel.schedule(at * 10L, () -> log.add("at " + kernel.nowNs()));
      }
      kernel.run(15, () -> false);
      assertThat(log).containsExactly("at 0", "at 10");
      assertThat(kernel.nowNs()).isEqualTo(15);
      kernel.schedule(15, () -> log.add("scheduled between two runs"));
      kernel.run(Long.MAX_VALUE, () -> log.size() == 4);
      assertThat(kernel.nowNs()).isEqualTo(20);
      kernel.run(Long.MAX_VALUE, () -> false);
      assertThat(log).last().isEqualTo("at 40");
      assertThat(kernel.nowNs()).isEqualTo(40);
    }
  }

  @Test
  void thePastCannotBeScheduled() {
    try (Kernel kernel = new Kernel(CarrierKind.PLATFORM)) {
      kernel.schedule(10, () -> {});
      kernel.run(100, () -> false);
      assertThatThrownBy(() -> kernel.schedule(9, () -> {}))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("9 ns")
          .hasMessageContaining("10 ns");
    }
  }
}
