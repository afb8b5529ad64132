package org.starl.spec;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Joined;

class ExceptRobotsTest {

  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");
  private static final RobotId C = new RobotId("c");
  private static final Rectangle DOCK = new Rectangle(0, 0, 1_000, 1_000);

  @Test
  void aViolationByAnExceptedRobotIsLeftOutAndOthersStay() {
    Monitors monitors = at(List.of(C), A, C);
    assertThat(monitors.report().holds()).isTrue();
    assertThat(monitors.report().checks("alone")).isPositive();
    assertThat(at(List.of(C), A, B).report().violations("alone")).isEqualTo(1);
  }

  @Test
  void onlyTheNamedLemmasAreLeftOutAlsoAtTheEnd() {
    Monitor breaksAll = new BreaksAll();
    for (String excepted : List.of("late", "ends", "other")) {
      Monitors monitors =
          new Monitors(
              List.of(new ExceptRobots(breaksAll, List.of(A), List.of(excepted), "wander")));
      monitors.observe(new Joined(0, A, new Pose(0, 0, 0), 165));
      monitors.finish(1);
      for (String lemma : breaksAll.lemmas()) {
        assertThat(monitors.report().violations(lemma))
            .as("%s, except %s", lemma, excepted)
            .isEqualTo(lemma.equals(excepted) ? 0 : 1);
      }
    }
  }

  /** One deadline that passes, and one violation at the end, and another one. */
  private static final class BreaksAll extends LemmaMonitor {
    BreaksAll() {
      lemma("late", "Is never in time.");
      lemma("ends", "Does not end.");
      lemma("other", "Is not.");
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      report.violated("other", event.timeNs(), List.of(A), "is");
      report.overdue("late", event.timeNs(), List.of(A), "is late");
    }

    @Override
    public void finish(long endNs, Report report) {
      report.violated("ends", endNs, List.of(A), "ends");
    }
  }

  @Test
  void theReportNamesTheExceptedRobotsAndTheReason() {
    assertThat(at(List.of(C, B), A).report().exceptions())
        .containsExactly("not required of b c, which drive at random: alone");
    assertThat(at(List.of(), A).report().exceptions()).isEmpty();
  }

  @Test
  void aLemmaOfAnotherMonitorIsRefused() {
    Monitor monitor = Require.eventuallyIn("there", DOCK, Duration.ofSeconds(1));
    assertThatThrownBy(() -> new ExceptRobots(monitor, List.of(A), List.of("alone"), "wander"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("[alone]: expected some of [there]");
  }

  /** After these robots have joined in one place. */
  private static Monitors at(List<RobotId> excepted, RobotId... robots) {
    Monitor alone = Require.neverTwoIn("alone", DOCK);
    Monitors monitors =
        new Monitors(
            List.of(new ExceptRobots(alone, excepted, List.of("alone"), "drive at random")));
    for (RobotId robot : robots) {
      monitors.observe(new Joined(0, robot, new Pose(500, 500, 0), 165));
    }
    monitors.finish(1);
    return monitors;
  }
}
