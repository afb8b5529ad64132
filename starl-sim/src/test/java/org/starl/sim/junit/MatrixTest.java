package org.starl.sim.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectMethod;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.testkit.engine.EngineTestKit;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.sim.Setting;
import org.starl.sim.Simulation;

/** {@link StarlTest#matrix}. */
class MatrixTest {

  private static final List<String> RUNS = new ArrayList<>();

  private static final class Nothing extends LogicThread {
    Nothing(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      return List.of();
    }
  }

  @ExtendWith(StarlTestTest.OnlyFromHere.class)
  static class Fixture {

    @StarlTest(
        seeds = 2,
        matrix = {"messageLoss = 0 | 0.5", "order=set|sequence"})
    void combined(Simulation.Builder simulation, Cell cell, long seed) {
      double loss = simulation.settings().get(Setting.MESSAGE_LOSS);
      RUNS.add(cell.get("order") + " " + loss + " " + seed);
      simulation.robots(1, Nothing::new);
    }

    @StarlTest(seeds = 2, matrix = "order=set|sequence|none")
    void bad(Simulation.Builder simulation, Cell cell, long seed) {
      RUNS.add(cell + " " + seed);
      simulation.robots(
          1,
          gvh -> {
            if (cell.get("order").equals("sequence")) {
              throw new IllegalStateException("on purpose");
            }
            return new Nothing(gvh);
          });
    }

    @StarlTest(matrix = {"order=set", "order=sequence"})
    void twice(Simulation.Builder simulation, Cell cell, long seed) {}

    @StarlTest(matrix = "messageLoss=2")
    void outOfRange(Simulation.Builder simulation, Cell cell, long seed) {}

    @StarlTest(matrix = "order=set")
    void mistyped(Simulation.Builder simulation, Cell cell, long seed) {
      cell.get("odrer");
    }
  }

  @TempDir private Path folder;

  @BeforeEach
  void clear() {
    RUNS.clear();
  }

  /** The message of the failed test; empty if it passed. */
  private String run(String method, String seed, String cell) {
    return EngineTestKit.engine("junit-jupiter")
        .configurationParameter("starl.fixture", "yes")
        .configurationParameter(StarlExtension.SEED, seed)
        .configurationParameter(StarlExtension.CELL, cell)
        .configurationParameter(RunFiles.FOLDER, folder.toString())
        .selectors(
            selectMethod(Fixture.class, method, Simulation.Builder.class, Cell.class, long.class))
        .execute()
        .testEvents()
        .failed()
        .stream()
        .map(event -> event.getRequiredPayload(TestExecutionResult.class).getThrowable().get())
        .map(Throwable::getMessage)
        .findFirst()
        .orElse("");
  }

  @Test
  void allSeedsRunForEachCombinationWithItsSettings() {
    assertThat(run("combined", "", "")).isEmpty();
    assertThat(RUNS)
        .containsExactly(
            "set 0.0 1",
            "set 0.0 2",
            "sequence 0.0 1",
            "sequence 0.0 2",
            "set 0.5 1",
            "set 0.5 2",
            "sequence 0.5 1",
            "sequence 0.5 2");
  }

  @Test
  void aBadRunNamesItsCellAndThePrintedCommandRunsItAlone() {
    String message = run("bad", "", "");
    assertThat(message).contains("bad with order=sequence: 2 of 2 runs went wrong");
    assertThat(message).endsWith(" -Dstarl.seed=1 '-Dstarl.cell=order=sequence'");
    RUNS.clear();
    assertThat(run("bad", "1", "order=sequence")).contains("1 of 1 runs went wrong");
    // The bad run is executed again for its trace.
    assertThat(RUNS).containsOnly("order=sequence 1");
  }

  @Test
  void aWrongMatrixIsRefusedWithItsLine() {
    assertThat(run("twice", "", ""))
        .isEqualTo("matrix: 'order=sequence': expected key=value|value, each key once");
    assertThat(run("outOfRange", "", "")).contains("messageLoss", "'2'");
    assertThat(run("mistyped", "", ""))
        .isEqualTo("no key 'odrer' in the matrix; did you mean order?");
    assertThat(run("bad", "1", "order=no"))
        .isEqualTo(
            "starl.cell='order=no': expected one of [order=set, order=sequence, order=none]");
  }
}
