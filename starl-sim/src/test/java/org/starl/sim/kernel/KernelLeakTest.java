package org.starl.sim.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.starl.platform.Timer;

/** A run leaves no memory and no thread behind. */
class KernelLeakTest {

  @Test
  void runsWithParkedRobotsDoNotLeakMemory() {
    List<WeakReference<Object>> apps = new ArrayList<>();
    for (int run = 0; run < 2000; run++) {
      apps.add(runOfParkedRobots(CarrierKind.VIRTUAL, 200));
    }
    System.gc();
    assertThat(apps).allMatch(app -> app.refersTo(null));
  }

  @ParameterizedTest
  @EnumSource
  void noThreadOutlivesItsRun(CarrierKind kind) throws InterruptedException {
    List<Thread> carriers = new ArrayList<>();
    Kernel kernel = new Kernel(kind);
    for (int i = 0; i < 50; i++) {
      SimStrand robot = kernel.strand("robot" + i);
      robot.start(() -> {
        carriers.add(Thread.currentThread());
        robot.awaitUntil(() -> false, Long.MAX_VALUE);
      });
    }
    kernel.run(10, () -> false);
    assertThat(carriers).hasSize(50).allMatch(Thread::isAlive).allMatch(Thread::isDaemon);
    kernel.close();
    for (Thread carrier : carriers) {
      carrier.join(60_000);
      assertThat(carrier.isAlive()).isFalse();
    }
  }

  @ParameterizedTest
  @EnumSource
  void anEndedAppIsReleased(CarrierKind kind) {
    try (Kernel kernel = new Kernel(kind)) {
      WeakReference<Object> app = endedApp(kernel);
      System.gc();
      assertThat(app.refersTo(null)).isTrue();
    }
  }

  @Test
  void aTimerSetAMillionTimesIsOneEvent() {
    try (Kernel kernel = new Kernel(CarrierKind.PLATFORM)) {
      SimStrand robot = kernel.strand("robot0");
      Timer timer = robot.timer(() -> {});
      for (int i = 0; i < 1_000_000; i++) {
        timer.set(30_000_000_000L + i % 7);
        if (i % 3 == 0) {
          timer.cancel();
        }
      }
      timer.set(5);
      assertThat(kernel.queue.size()).isEqualTo(1);
      kernel.run(Long.MAX_VALUE, () -> false);
      assertThat(kernel.events()).isEqualTo(1);
      assertThat(kernel.nowNs()).isEqualTo(5);
    }
  }

  private static WeakReference<Object> runOfParkedRobots(CarrierKind kind, int robots) {
    try (Kernel kernel = new Kernel(kind)) {
      Object held = new Object();
      for (int i = 0; i < robots; i++) {
        SimStrand robot = kernel.strand("robot" + i);
        robot.start(() -> {
          robot.sleepUntil(Long.MAX_VALUE);
          throw new IllegalStateException("woke with " + held);
        });
      }
      kernel.run(10, () -> false);
      return new WeakReference<>(held);
    }
  }

  private static WeakReference<Object> endedApp(Kernel kernel) {
    Object held = new Object();
    SimStrand robot = kernel.strand("robot0");
    robot.start(() -> robot.sleepUntil(held.toString().length()));
    kernel.run(1_000, () -> false);
    return new WeakReference<>(held);
  }
}
