package org.starl.sim.kernel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.starl.platform.StrandClosed;

/** Bugs in a robot's program end the run, with place and time in the message. */
class RobotErrorTest {

  @ParameterizedTest
  @EnumSource
  void anExceptionOfTheAppEndsTheRun(CarrierKind kind) {
    IllegalStateException bug = new IllegalStateException("lost its way");
    RobotError error =
        errorOf(
            kind,
            robot -> {
              robot.sleepUntil(1_250_000_000);
              throw bug;
            });
    assertThat(error).hasMessage("robot0 at 1.250000000 s: IllegalStateException: lost its way");
    assertThat(error).hasCause(bug);
    assertThat(error.strand()).isEqualTo("robot0");
    assertThat(error.timeNs()).isEqualTo(1_250_000_000);
  }

  @ParameterizedTest
  @EnumSource
  void anErrorOfTheAppEndsTheRun(CarrierKind kind) {
    RobotError error =
        errorOf(
            kind,
            robot -> {
              throw new AssertionError();
            });
    assertThat(error).hasMessage("robot0 at 0.000000000 s: AssertionError");
  }

  @ParameterizedTest
  @EnumSource
  void anExceptionOfAPieceEndsTheRun(CarrierKind kind) {
    RobotError error =
        errorOf(
            kind,
            robot -> {
              robot.post(() -> List.of().get(7));
              robot.sleepUntil(100);
            });
    assertThat(error).hasCauseInstanceOf(IndexOutOfBoundsException.class);
  }

  @ParameterizedTest
  @EnumSource
  void anExceptionOfAConditionEndsTheRun(CarrierKind kind) {
    int[] evaluations = {0};
    RobotError error =
        errorOf(
            kind,
            robot -> {
              robot.timer(() -> {}).set(30);
              robot.awaitUntil(() -> 1 / (1 - evaluations[0]++) == 0, Long.MAX_VALUE);
            });
    assertThat(error).hasCauseInstanceOf(ArithmeticException.class);
    assertThat(error.timeNs()).isEqualTo(30);
  }

  @ParameterizedTest
  @EnumSource
  void aHandlerThatWaitsIsABug(CarrierKind kind) {
    RobotError error =
        errorOf(
            kind,
            robot -> {
              robot.post(() -> robot.sleepUntil(50));
              robot.sleepUntil(100);
            });
    assertThat(error).hasMessageContaining("only the app may wait");
  }

  @ParameterizedTest
  @EnumSource
  void waitingOnTheStrandOfAnotherRobotIsABug(CarrierKind kind) {
    try (Kernel kernel = new Kernel(kind)) {
      SimStrand other = kernel.strand("other");
      SimStrand robot = kernel.strand("robot0");
      other.start(() -> other.sleepUntil(1_000));
      robot.start(() -> other.sleepUntil(50));
      assertThatThrownBy(() -> kernel.run(100, () -> false))
          .isInstanceOf(RobotError.class)
          .hasMessageContaining("robot0")
          .hasMessageContaining("only the app may wait");
    }
  }

  @ParameterizedTest
  @EnumSource
  void anAppThatDoesNotEndIsReported(CarrierKind kind) {
    Kernel kernel = new Kernel(kind);
    SimStrand robot = kernel.strand("robot0");
    int[] told = {0};
    robot.start(() -> {
      while (true) {
        try {
          robot.sleepUntil(kernel.nowNs() + 10);
        } catch (StrandClosed e) {
          told[0]++;
        }
      }
    });
    kernel.run(100, () -> false);
    assertThatThrownBy(kernel::close)
        .isInstanceOf(RobotError.class)
        .hasMessageContaining("robot0")
        .hasMessageContaining("does it catch StrandClosed?");
    assertThat(told[0]).isGreaterThan(10);
  }

  @ParameterizedTest
  @EnumSource
  void anAppThatWaitsWhileItUnwindsIsInterruptedAgain(CarrierKind kind) {
    List<String> log = new ArrayList<>();
    Kernel kernel = new Kernel(kind);
    SimStrand robot = kernel.strand("robot0");
    robot.start(() -> {
      try {
        robot.sleepUntil(1_000);
      } catch (StrandClosed e) {
        log.add("first");
      }
      try {
        robot.awaitUntil(() -> true, Long.MAX_VALUE);
      } finally {
        log.add("second");
      }
    });
    kernel.run(100, () -> false);
    kernel.close();
    assertThat(log).containsExactly("first", "second");
  }

  @ParameterizedTest
  @EnumSource
  void aFailureDuringUnwindingLeavesNoAppParked(CarrierKind kind) {
    List<String> log = new ArrayList<>();
    Kernel kernel = new Kernel(kind);
    for (int i = 0; i < 3; i++) {
      SimStrand robot = kernel.strand("robot" + i);
      robot.start(() -> {
        try {
          robot.sleepUntil(1_000);
        } finally {
          log.add(robot.name());
          failUnlessFirst(robot);
        }
      });
    }
    kernel.run(100, () -> false);
    RobotError error = catchThrowableOfType(RobotError.class, kernel::close);
    assertThat(error).hasMessageContaining("robot1").hasMessageContaining("in finally");
    assertThat(error.getSuppressed()).hasSize(1);
    assertThat(log).containsExactly("robot0", "robot1", "robot2");
  }

  @Test
  void anExceptionOfTheWorldIsRethrownUnchanged() {
    try (Kernel kernel = new Kernel(CarrierKind.PLATFORM)) {
      IllegalStateException bug = new IllegalStateException("the world is flat");
      kernel.schedule(
          5,
          () -> {
            throw bug;
          });
      assertThatThrownBy(() -> kernel.run(100, () -> false)).isSameAs(bug);
    }
  }

  @Test
  void anAppStartsOnce() {
    try (Kernel kernel = new Kernel(CarrierKind.PLATFORM)) {
      SimStrand robot = kernel.strand("robot0");
      robot.start(() -> {});
      assertThatThrownBy(() -> robot.start(() -> {}))
          .isInstanceOf(IllegalStateException.class)
          .hasMessageContaining("robot0");
    }
  }

  private static void failUnlessFirst(SimStrand robot) {
    if (!robot.name().equals("robot0")) {
      throw new IllegalStateException("in finally");
    }
  }

  private static RobotError errorOf(CarrierKind kind, Consumer<SimStrand> app) {
    try (Kernel kernel = new Kernel(kind)) {
      SimStrand robot = kernel.strand("robot0");
      robot.start(() -> app.accept(robot));
      return catchThrowableOfType(RobotError.class, () -> kernel.run(2_000_000_000, () -> false));
    }
  }
}
