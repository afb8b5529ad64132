package org.starl.spec.automaton;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.spec.SpecReport;
import org.starl.trace.Instance;
import org.starl.trace.Note;
import org.starl.trace.TraceEvent;

/** A lamp that is switched on and off. */
class ReplayTest {

  private static final Instance LAMP = Instance.of("lamp", "x");
  private static final TraceEvent EVENT =
      TraceEvent.Action.of(
          7_000_000, new RobotId("bot1"), LAMP, Note.SHAPE, new Note("switch_on", List.of()));

  private sealed interface Switch extends Action {
    record switch_on(int i) implements Switch {}

    record switch_off(int i, int j) implements Switch {}

    @Override
    default List<Object> args() {
      return switch (this) {
        case switch_on a -> List.of(a.i);
        case switch_off a -> List.of(a.i, a.j);
      };
    }
  }

  private static final class Lamp implements Automaton<Boolean, Switch> {
    @Override
    public String theory() {
      return "Lamp_decls";
    }

    @Override
    public Boolean start() {
      return false;
    }

    @Override
    public Enabled enabled(Switch action, Boolean isOn) {
      return switch (action) {
        case Switch.switch_on a ->
            Enabled.when("i > 0", a.i() > 0, () -> "i = " + a.i())
                .and("NOT on(s)", !isOn, () -> "on(s) = true");
        case Switch.switch_off a -> Enabled.TRUE;
      };
    }

    @Override
    public Boolean trans(Switch action, Boolean isOn) {
      return action instanceof Switch.switch_on;
    }
  }

  private final List<String> steps = new ArrayList<>();
  private final SpecReport report = new SpecReport();
  private final Replay<Boolean, Switch> replay =
      new Replay<>(
          new Lamp(),
          LAMP,
          new AutomatonListener<>() {
            @Override
            public void onStep(Instance instance, TraceEvent event, Switch action, Boolean after) {
              steps.add(instance + " " + action.text() + " " + after);
            }

            @Override
            public void onResult(
                Instance instance, String component, Object argument, Object value) {
              steps.add(instance + " " + component + "(" + argument + ") = " + value);
            }
          });

  @Test
  void enabledStepsArePassedToTheListener() {
    replay.step(EVENT, new Switch.switch_on(1), report);
    replay.result(EVENT, "on", 1, true, replay.state(), report);
    replay.step(EVENT, new Switch.switch_off(1, 2), report);
    assertThat(steps)
        .containsExactly(
            "lamp/x switch_on(1) true", "lamp/x on(1) = true", "lamp/x switch_off(1, 2) false");
    assertThat(report.holds()).isTrue();
    assertThat(report.checks("Lamp_decls")).isEqualTo(3);
  }

  @Test
  void aStepThatIsNotEnabledIsReportedAndEndsTheReplay() {
    replay.step(EVENT, new Switch.switch_on(1), report);
    replay.step(EVENT, new Switch.switch_on(1), report);
    replay.step(EVENT, new Switch.switch_on(0), report);
    replay.result(EVENT, "on", 1, false, replay.state(), report);
    assertThat(replay.hasDeviated()).isTrue();
    assertThat(report.violations())
        .extracting(SpecReport.Violation::toString)
        .containsExactly(
            "Lamp_decls violated at 0.007 s by bot1: lamp/x: switch_on(1) is not enabled:"
                + " NOT on(s) is false: on(s) = true");
    // The listener gets the deviating step as well, so that a proof of the steps finds it.
    assertThat(steps).containsExactly("lamp/x switch_on(1) true", "lamp/x switch_on(1) true");
  }

  @Test
  void theFirstOfSeveralFalseConjunctsIsReported() {
    replay.step(EVENT, new Switch.switch_on(1), report);
    replay.step(EVENT, new Switch.switch_on(-1), report);
    assertThat(report.violations().get(0).detail()).endsWith("i > 0 is false: i = -1");
  }

  @Test
  void aResultThatDiffersFromTheAutomatonIsReported() {
    replay.result(EVENT, "on", 1, true, replay.state(), report);
    assertThat(report.violations())
        .extracting(SpecReport.Violation::detail)
        .containsExactly("lamp/x: on(1) is false, but the trace has true");
  }

  @Test
  void conjunctsAreReportedUpToTheFirstFalseOne() {
    replay.step(EVENT, new Switch.switch_on(1), report);
    replay.step(EVENT, new Switch.switch_on(1), report);
    SpecReport other = new SpecReport();
    new Replay<>(new Lamp(), Instance.of("lamp", "y"), AutomatonListener.none())
        .step(EVENT, new Switch.switch_on(0), other);
    assertThat(counts(report))
        .containsOnly("taken 1", "i > 0 true 2", "NOT on(s) true 1", "NOT on(s) false 1");
    assertThat(counts(other)).containsOnly("i > 0 false 1");
  }

  private static List<String> counts(SpecReport report) {
    List<String> counts = new ArrayList<>();
    report
        .reached()
        .forEach((what, times) ->
            counts.add(
                what.conjunct().isEmpty()
                    ? "taken " + times
                    : what.conjunct() + " " + what.holds() + " " + times));
    return counts;
  }
}
