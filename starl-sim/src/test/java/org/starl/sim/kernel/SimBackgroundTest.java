package org.starl.sim.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class SimBackgroundTest {

  private final Kernel kernel = new Kernel(CarrierKind.PLATFORM);
  private final SimStrand strand = kernel.strand("robot0");
  private final List<String> log = new ArrayList<>();

  @Test
  void aTaskTakesItsCostAndTheNextWaitsForTheWorker() {
    SimBackground background = new SimBackground(kernel, strand, 100);
    kernel.schedule(
        1000,
        strand,
        () -> {
          background.submit(() -> note("task"), () -> note("done"));
          background.submit(() -> note("task"), () -> note("done"));
        });
    kernel.schedule(1250, strand, () -> background.submit(() -> note("task"), () -> note("done")));
    run();
    assertThat(log)
        .containsExactly(
            "task 1000", "task 1000", "done 1100", "done 1200", "task 1250", "done 1350");
  }

  @Test
  void aTaskWithoutCostCompletesInTheNextPieceAtTheSameTime() {
    SimBackground background = new SimBackground(kernel, strand, 0);
    kernel.schedule(
        1000,
        strand,
        () -> {
          background.submit(() -> note("task"), () -> note("done"));
          note("piece is over");
        });
    run();
    assertThat(log).containsExactly("task 1000", "piece is over 1000", "done 1000");
  }

  @Test
  void aClosedStrandReceivesNoResult() {
    SimBackground background = new SimBackground(kernel, strand, 100);
    kernel.schedule(1000, strand, () -> background.submit(() -> note("task"), () -> note("done")));
    kernel.schedule(1050, strand::close);
    run();
    assertThat(log).containsExactly("task 1000");
  }

  private void run() {
    kernel.run(1_000_000, () -> false);
    kernel.close();
  }

  private void note(String what) {
    log.add(what + " " + kernel.nowNs());
  }
}
