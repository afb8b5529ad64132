package org.starl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class ComputationTest {

  private final List<Runnable> pending = new ArrayList<>();

  @Test
  void theResultIsAvailableFromItsPieceOn() {
    List<String> log = new ArrayList<>();
    Computation<String> computation = start("path");
    computation.whenDone(() -> log.add(computation.result()));
    assertThat(computation.isDone()).isFalse();
    assertThatThrownBy(computation::result).hasMessageContaining("isDone()");
    pending.remove(0).run();
    assertThat(computation.isDone()).isTrue();
    assertThat(log).containsExactly("path");
  }

  @Test
  void aListenerSetTooLateIsRefused() {
    Computation<String> computation = start("path");
    pending.remove(0).run();
    assertThatThrownBy(() -> computation.whenDone(() -> {}))
        .hasMessageContaining("available already");
  }

  private Computation<String> start(String outcome) {
    return Computation.start(
        (task, done) -> {
          task.run();
          pending.add(done);
        },
        () -> outcome);
  }
}
