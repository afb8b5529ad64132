package org.starl.sim.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.random.Rng;
import org.starl.sim.Simulation;
import org.starl.sim.check.Determinism.Difference;
import org.starl.sim.kernel.CarrierKind;

class DeterminismTest {

  private static final boolean BOTH_CARRIERS = CarrierKind.best() == CarrierKind.VIRTUAL;

  private interface Step {
    Object value(int round, GlobalVarHolder gvh, Rng rng);
  }

  /** Drives back and forth; traces one value per round. */
  private static final class Wanderer extends LogicThread {
    private final Step step;
    private final Rng rng;

    Wanderer(GlobalVarHolder gvh, Step step) {
      super(gvh);
      this.step = step;
      rng = gvh.plat.entropy.fork("app");
    }

    @Override
    public List<Object> callStarL() {
      for (int round = 0; round < 10; round++) {
        double xMm = gvh.gps.hasFix() ? gvh.gps.pose().xMm() + 100 : 0;
        gvh.plat.moat.doMove(new ItemPosition("there", xMm, 0));
        gvh.trace.action("app", "round", step.value(round, gvh, rng));
        sleep(100 + rng.nextInt(50));
      }
      return returnResults();
    }
  }

  private static Determinism verify(Step step) throws IOException {
    Function<GlobalVarHolder, LogicThread> app = gvh -> new Wanderer(gvh, step);
    return Determinism.verify(() -> Simulation.builder().name("test").robots(3, app).seed(42));
  }

  @Test
  void aSimulationThatDependsOnlyOnItsSeedPasses() throws IOException {
    Determinism check = verify((round, gvh, rng) -> rng.nextInt(1_000));
    assertThat(check.difference()).isNull();
    assertThat(check.holds()).isTrue();
    assertThat(check.runs())
        .endsWith(BOTH_CARRIERS ? "platform threads" : "platform threads again");
    assertThat(check.runs()).hasSize(BOTH_CARRIERS ? 3 : 2);
    assertThat(check.lines()).isGreaterThan(32);
  }

  @Test
  void stateSharedBetweenRunsIsDetected() throws IOException {
    AtomicInteger calls = new AtomicInteger();
    Determinism check =
        verify((round, gvh, rng) -> {
          int call = calls.getAndIncrement();
          boolean isSecondRun = call >= 30;
          return isSecondRun && round == 4 && gvh.id.name().name().equals("bot1") ? "x" : "y";
        });
    Difference difference = Objects.requireNonNull(check.difference());
    assertThat(difference.secondRun()).isEqualTo(difference.firstRun() + " again");
    assertThat(difference.firstLine())
        .contains("\"robot\":\"bot1\"")
        .endsWith("\"texts\":[\"y\"]}}}");
    assertThat(difference.secondLine())
        .isEqualTo(difference.firstLine().replace("[\"y\"]", "[\"x\"]"));
    String[] lines = difference.toString().split("\n", -1);
    assertThat(lines).hasSize(3);
    assertThat(lines[0])
        .matches("first difference at line " + difference.line() + " \\(0\\.\\d{9} s, bot1\\)");
    assertThat(lines[2]).isEqualTo("  " + difference.secondRun() + ": " + difference.secondLine());
  }

  @Test
  void anAppThatReadsItsThreadIsDetected() throws IOException {
    assumeThat(BOTH_CARRIERS).isTrue();
    Determinism check = verify((round, gvh, rng) -> Thread.currentThread().isVirtual());
    Difference difference = Objects.requireNonNull(check.difference());
    assertThat(difference.secondRun()).isEqualTo("platform threads");
    assertThat(difference.firstLine()).contains("[\"true\"]");
    assertThat(difference.secondLine()).contains("[\"false\"]");
  }

  @Test
  void runsThatFailTheSameWayAreEqual() throws IOException {
    Determinism check =
        verify((round, gvh, rng) -> {
          if (round == 3) {
            throw new IllegalStateException("broken");
          }
          return round;
        });
    assertThat(check.difference()).isNull();
  }

  @Test
  void runsThatFailInDifferentWaysAreNot() throws IOException {
    AtomicInteger calls = new AtomicInteger();
    Determinism check =
        verify((round, gvh, rng) -> {
          if (round == 3) {
            throw new IllegalStateException("broken " + calls.getAndIncrement());
          }
          return round;
        });
    Difference difference = Objects.requireNonNull(check.difference());
    assertThat(difference.line()).isEqualTo(check.lines());
    assertThat(difference.firstLine()).contains("broken 0");
    assertThat(difference.secondLine()).contains("broken 1");
  }

  @Test
  void theTextOfAFailureIsNoEvent() throws IOException {
    AtomicInteger calls = new AtomicInteger();
    Determinism check =
        verify((round, gvh, rng) -> {
          throw new IllegalStateException("\"timeNs\":7, call " + calls.getAndIncrement());
        });
    Difference difference = Objects.requireNonNull(check.difference());
    assertThat(difference.toString())
        .startsWith("first difference at line " + difference.line() + "\n");
  }

  @ParameterizedTest
  @CsvSource(
      nullValues = "-",
      value = {
        "'a,b,', 'a,b,', -",
        "'', '', -",
        "'a,b,', 'a,c,', 2 b c",
        "'a,b,', 'a,bb,', 2 b bb",
        "'a,bb,', 'a,b,', 2 bb b",
        "'a,b,', 'a,', 2 b (nothing more)",
        "'a,', 'a,b,', 2 (nothing more) b",
        "'abc,x,', 'abd,y,', 1 abc abd",
        "'a', 'ab,', 1 a ab",
        "'ab,', 'a', 1 ab a",
        "'', 'x', 1 (nothing more) x"
      })
  void theFirstDifferingLineIsReported(String reference, String written, @Nullable String expected)
      throws IOException {
    byte[] bytes = reference.replace(',', '\n').getBytes(StandardCharsets.UTF_8);
    LineComparer comparer = new LineComparer(new ByteArrayInputStream(bytes));
    comparer.write(written.replace(',', '\n').getBytes(StandardCharsets.UTF_8));
    Difference found = comparer.difference("a", "b");
    assertThat(
            found == null
                ? null
                : found.line() + " " + found.firstLine() + " " + found.secondLine())
        .isEqualTo(expected);
  }
}
