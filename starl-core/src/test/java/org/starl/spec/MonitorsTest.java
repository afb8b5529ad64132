package org.starl.spec;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;

/** Which monitors, and which of their lemmas, a run checks. */
class MonitorsTest {

  private static final RobotId BOT = new RobotId("bot0");

  /** Finds every one of its lemmas violated at each event. */
  private static final class Grumbler extends LemmaMonitor {

    Grumbler(String safety, String progress) {
      if (!safety.isEmpty()) {
        lemma(safety, "");
      }
      progress(progress, "");
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      for (String lemma : lemmas()) {
        report.checked(lemma);
        report.overdue(lemma, event.timeNs(), List.of(BOT), "");
      }
    }
  }

  private static Monitors observed(Specs specs) {
    Monitors monitors =
        Monitors.of(
            List.of(() -> new Grumbler("safe", "live"), () -> new Grumbler("", "prompt")), specs);
    monitors.observe(new TraceEvent.Left(0, BOT));
    monitors.finish(1);
    return monitors;
  }

  @Test
  void allAreCheckedUnlessFewerAreWanted() {
    Monitors monitors = observed(Specs.ALL);
    assertThat(monitors.report().violations()).hasSize(3);
    assertThat(monitors.report().leftOut()).isEmpty();
  }

  @Test
  void safetyLeavesOutProgressAndTheMonitorsOfNothingElse() {
    Monitors monitors = observed(Specs.SAFETY);
    assertThat(monitors.monitors()).hasSize(1);
    assertThat(monitors.report().lemmas()).containsExactly("safe");
    assertThat(monitors.report().violations()).hasSize(1);
    assertThat(monitors.report().leftOut()).containsExactly("live", "prompt");
  }

  private static final class Friendly extends LemmaMonitor {
    @Override
    public void observe(TraceEvent event, Report report) {}

    @Override
    public List<Monitor> companions() {
      return List.of(new FriendsFriendly());
    }
  }

  private static final class FriendsFriendly extends LemmaMonitor {
    @Override
    public void observe(TraceEvent event, Report report) {}

    @Override
    public List<Monitor> companions() {
      return List.of(new Grumbler("safe", "live"), new Friendly());
    }
  }

  @Test
  void companionsHaveCompanionsToo() {
    assertThat(Monitors.of(List.of(Friendly::new)).monitors())
        .extracting(Monitor::getClass)
        .containsExactly(Friendly.class, FriendsFriendly.class, Grumbler.class);
  }

  /** Throws at each event, and at the end. */
  private static final class Broken extends LemmaMonitor {

    @Override
    public void observe(TraceEvent event, Report report) {
      throw new IllegalArgumentException("no such robot");
    }

    @Override
    public void finish(long endNs, Report report) {
      throw new IllegalArgumentException("no robots");
    }
  }

  @Test
  void aMonitorThatThrowsIsNamed() {
    Monitors monitors = new Monitors(List.of(new Broken()));
    assertThatThrownBy(() -> monitors.observe(new TraceEvent.Left(0, BOT)))
        .hasMessageContaining("the monitor " + Broken.class.getName() + " failed at Left[")
        .hasMessageContaining("no such robot");
    assertThatThrownBy(() -> monitors.finish(1))
        .hasMessageContaining("the monitor " + Broken.class.getName() + " failed at the end")
        .hasMessageContaining("no robots");
  }

  @Test
  void offChecksNothing() {
    Monitors monitors = observed(Specs.OFF);
    assertThat(monitors.monitors()).isEmpty();
    assertThat(monitors.report().lemmas()).isEmpty();
    assertThat(monitors.report().specs()).isEqualTo(Specs.OFF);
  }
}
