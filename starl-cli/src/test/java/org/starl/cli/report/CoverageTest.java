package org.starl.cli.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.spec.SpecReport;
import org.starl.spec.automaton.Action;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Replay;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;

class CoverageTest {

  /** Counts to three, and back. */
  private static final class Counter implements Automaton<Integer, Step> {
    @Override
    public String theory() {
      return "Counter_decls";
    }

    @Override
    public Integer start() {
      return 0;
    }

    @Override
    public Enabled enabled(Step step, Integer count) {
      return switch (step) {
        case Up up -> Enabled.when("count < 3", count < 3, () -> "count = " + count);
        case Down down -> Enabled.when("count > 0", count > 0, () -> "count = " + count);
        case Reset reset -> Enabled.TRUE;
      };
    }

    @Override
    public Integer trans(Step step, Integer count) {
      return switch (step) {
        case Up up -> count + 1;
        case Down down -> count - 1;
        case Reset reset -> 0;
      };
    }
  }

  private sealed interface Step extends Action {}

  private record Up() implements Step {
    @Override
    public List<Object> args() {
      return List.of();
    }
  }

  private record Down() implements Step {
    @Override
    public List<Object> args() {
      return List.of();
    }
  }

  private record Reset() implements Step {
    @Override
    public List<Object> args() {
      return List.of();
    }
  }

  private static SpecReport run(Step... steps) {
    SpecReport report = new SpecReport();
    Replay<Integer, Step> replay =
        new Replay<>(new Counter(), Instance.of("counter"), AutomatonListener.none());
    TraceEvent event = new TraceEvent.Left(0, new RobotId("bot0"));
    for (Step step : steps) {
      replay.step(event, step, report);
    }
    return report;
  }

  private static Coverage of(SpecReport report) {
    return Coverage.of(report, new DeliveryCounter());
  }

  @Test
  void actionsThatNoRunTookAreNamed() {
    Coverage coverage = new Coverage();
    coverage.add(of(run(new Up(), new Up())));
    assertThat(coverage.lines())
        .containsExactly(
            "coverage of Counter_decls: 1 of 3 actions, 0 of 1 guards seen false; never: Down Reset");
    coverage.add(of(run(new Up(), new Down())));
    assertThat(coverage.lines().get(0)).contains("2 of 3 actions").endsWith("never: Reset");
  }

  @Test
  void aPartThatFewRunsReachedIsRare() {
    RareParts parts = new RareParts();
    Coverage common = of(run(new Up()));
    for (long seed = 1; seed <= 9; seed++) {
      parts.add(seed, seed == 3 || seed == 8 ? of(run(new Up(), new Down())) : common);
    }
    assertThat(parts.seeds(3)).containsExactly(3L, 8L, 3L);
    parts.add(10, of(run(new Reset())));
    assertThat(parts.seeds(4)).as("the rarest first").containsExactly(10L, 3L, 10L, 8L);
  }

  @Test
  void ifAllRunsReachTheSameNoPartIsRare() {
    RareParts parts = new RareParts();
    parts.add(1, of(run(new Up())));
    parts.add(2, of(run(new Up())));
    assertThat(parts.seeds(3)).isEmpty();
  }

  @Test
  void aGuardThatWouldHaveStoppedAnEarlierActionCounts() {
    List<Step> steps = new ArrayList<>();
    // Up to three and down to none, again and again: each guard is false at one end.
    for (int round = 0; round < 20; round++) {
      steps.addAll(List.of(new Up(), new Up(), new Up(), new Down(), new Down(), new Down()));
    }
    Coverage coverage = new Coverage();
    coverage.add(of(run(steps.toArray(Step[]::new))));
    assertThat(coverage.lines().get(0)).contains("2 of 3 actions, 2 of 2 guards seen false");
  }

  @Test
  void conjunctsAreCountedByTheirValues() {
    List<Step> steps = new ArrayList<>();
    for (int round = 0; round < 20; round++) {
      steps.addAll(List.of(new Up(), new Up(), new Up(), new Down(), new Down(), new Down()));
    }
    Coverage.Action up =
        Objects.requireNonNull(
            Objects.requireNonNull(
                    of(run(steps.toArray(Step[]::new))).theories().get("Counter_decls"))
                .get("Up"));
    assertThat(up.taken()).isEqualTo(60);
    assertThat(up.guard()).containsOnlyKeys("count < 3");
    Coverage.Values values = Objects.requireNonNull(up.guard().get("count < 3"));
    // Sixty times for the actions, and again for each try.
    assertThat(values.held()).isGreaterThan(60);
    assertThat(values.failed()).isBetween(1L, 17L);
  }
}
