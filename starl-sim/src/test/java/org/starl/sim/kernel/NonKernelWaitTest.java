package org.starl.sim.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Apps that wait for something the kernel does not know. */
class NonKernelWaitTest {

  private static final Duration SHORT = Duration.ofMillis(50);

  private final List<String> log = new ArrayList<>();

  @ParameterizedTest
  @EnumSource
  void theKernelWaitsForAnAppThatBlocksOutsideTheKernel(CarrierKind kind) {
    try (Kernel kernel = new Kernel(kind)) {
      SimStrand robot = kernel.strand("robot0");
      CountDownLatch entered = new CountDownLatch(1);
      CountDownLatch latch = new CountDownLatch(1);
      robot.start(() -> {
        entered.countDown();
        waitFor(latch);
        log.add("app " + kernel.nowNs());
        robot.sleepUntil(20);
        log.add("app " + kernel.nowNs());
      });
      kernel.schedule(10, () -> log.add("world " + kernel.nowNs()));
      Thread foreign =
          new Thread(() -> {
            waitFor(entered);
            latch.countDown();
          });
      foreign.start();
      kernel.run(100, () -> false);
      assertThat(log).containsExactly("app 0", "world 10", "app 20");
    }
  }

  @ParameterizedTest
  @EnumSource
  void anAppThatBlocksOutsideTheKernelForTooLongIsReportedWithItsStack(CarrierKind kind) {
    RobotError error = errorOf(kind, robot -> waitFor(new CountDownLatch(1)));
    assertThat(error)
        .hasMessageContaining("robot0")
        .hasMessageContaining("outside sleep and await")
        .hasMessageContaining("use gvh.sleep / sleep(ms)");
    assertThat(error.getCause().getStackTrace())
        .anySatisfy(frame -> assertThat(frame.getMethodName()).isEqualTo("waitFor"));
  }

  @ParameterizedTest
  @EnumSource
  void anAppThatParksForeverIsReported(CarrierKind kind) {
    RobotError error =
        errorOf(
            kind,
            robot -> {
              while (log.isEmpty()) {
                LockSupport.park();
              }
            });
    assertThat(error).hasMessageContaining("outside sleep and await");
  }

  @ParameterizedTest
  @EnumSource
  void closingInterruptsAnAppThatBlocksOutsideTheKernel(CarrierKind kind) {
    Kernel kernel = new Kernel(kind, SHORT);
    SimStrand robot = kernel.strand("robot0");
    robot.start(() -> {
      try {
        waitFor(new CountDownLatch(1));
      } finally {
        log.add("finally");
      }
    });
    assertThatThrownBy(() -> kernel.run(100, () -> false)).isInstanceOf(RobotError.class);
    assertThatThrownBy(kernel::close).hasRootCauseInstanceOf(InterruptedException.class);
    assertThat(log).containsExactly("finally");
  }

  @ParameterizedTest
  @EnumSource
  void anInterruptedAppStillSleepsInVirtualTime(CarrierKind kind) {
    try (Kernel kernel = new Kernel(kind)) {
      SimStrand robot = kernel.strand("robot0");
      robot.start(() -> {
        Thread.currentThread().interrupt();
        robot.sleepUntil(50);
        log.add("app " + kernel.nowNs() + " " + Thread.currentThread().isInterrupted());
      });
      kernel.run(100, () -> false);
      assertThat(log).containsExactly("app 50 true");
    }
  }

  @ParameterizedTest
  @EnumSource
  void aYieldAndALeftOverPermitHaveNoEffect(CarrierKind kind) {
    try (Kernel kernel = new Kernel(kind)) {
      SimStrand robot = kernel.strand("robot0");
      robot.start(() -> {
        Thread.yield();
        LockSupport.unpark(Thread.currentThread());
        robot.sleepUntil(50);
        log.add("app " + kernel.nowNs());
        robot.sleepUntil(60);
        log.add("app " + kernel.nowNs());
      });
      kernel.schedule(20, () -> log.add("world"));
      kernel.run(100, () -> false);
      assertThat(log).containsExactly("world", "app 50", "app 60");
    }
  }

  @Test
  void aWaitInAStaticInitialiserIsReportedIfItWouldBlockTheKernel() {
    RobotError error =
        errorOf(
            CarrierKind.VIRTUAL,
            robot -> {
              SleepyClass.sleep = () -> robot.sleepUntil(5);
              log.add("never " + SleepyClass.Initialised.VALUE);
            });
    assertThat(error)
        .hasRootCauseMessage(
            "sleep and await do not work inside a static initialiser or a native method");
    assertThat(log).doesNotContain("never 1");
  }

  @Test
  void aWaitInAStaticInitialiserWorksOnAPlatformThread() {
    try (Kernel kernel = new Kernel(CarrierKind.PLATFORM, SHORT)) {
      SimStrand robot = kernel.strand("robot0");
      robot.start(() -> {
        OtherSleepyClass.sleep = () -> robot.sleepUntil(5);
        log.add("got " + OtherSleepyClass.Initialised.VALUE + " at " + kernel.nowNs());
      });
      kernel.run(100, () -> false);
      assertThat(log).containsExactly("got 1 at 5");
    }
  }

  private static final class SleepyClass {
    private static Runnable sleep;

    private static final class Initialised {
      private static final int VALUE = valueAfter(sleep);
    }
  }

  private static final class OtherSleepyClass {
    private static Runnable sleep;

    private static final class Initialised {
      private static final int VALUE = valueAfter(sleep);
    }
  }

  private static int valueAfter(Runnable action) {
    action.run();
    return 1;
  }

  private RobotError errorOf(CarrierKind kind, Consumer<SimStrand> app) {
    Kernel kernel = new Kernel(kind, SHORT);
    SimStrand robot = kernel.strand("robot0");
    robot.start(() -> app.accept(robot));
    RobotError error = catchThrowableOfType(RobotError.class, () -> kernel.run(9, () -> false));
    log.add("released");
    RobotError atClose = catchThrowableOfType(RobotError.class, kernel::close);
    if (atClose != null) {
      error.addSuppressed(atClose);
    }
    return error;
  }

  private static void waitFor(CountDownLatch latch) {
    try {
      if (!latch.await(60, TimeUnit.SECONDS)) {
        throw new IllegalStateException("no other thread came");
      }
    } catch (InterruptedException e) {
      throw new IllegalStateException("interrupted", e);
    }
  }
}
