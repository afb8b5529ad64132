package org.starl.spec;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.spec.SpecReport.Violation;
import org.starl.trace.Instance;
import org.starl.trace.Note;
import org.starl.trace.TraceEvent;

class SpecReportTest {

  private static final RobotId ONE = new RobotId("bot1");
  private static final RobotId TWO = new RobotId("bot2");

  @Test
  void theTextHasOneLinePerLemmaAndPerViolation() {
    SpecReport report = new SpecReport();
    report.expect(List.of("Promise", "Connected"));
    report.checked("Exclusive");
    report.checked("Exclusive");
    report.checked("Connected");
    assertThat(report.holds()).isTrue();

    report.violated("Exclusive", 12_345_678_901L, List.of(ONE, TWO), "both hold A");

    assertThat(report.holds()).isFalse();
    assertThat(report)
        .hasToString(
            "Connected: 1 check, held\n"
                + "Exclusive: 2 checks, violated once\n"
                + "Promise: never checked\n"
                + "Exclusive violated at 12.345 s by bot1 bot2: both hold A");
  }

  @Test
  void aLemmaWithoutACheckIsNeitherHeldNorInapplicableUnlessAMonitorSaysSo() {
    LemmaMonitor monitor =
        new LemmaMonitor() {
          {
            lemma("found", "A thing is found.");
            lemma("nothing", "Nothing is found.");
            lemma("checked", "This one is checked.");
            never("nothing", "an object is there");
          }

          @Override
          public void observe(TraceEvent event, Report report) {
            report.checked("checked");
          }
        };
    Monitors monitors = new Monitors(List.of(new ExceptRobots(monitor, List.of(), List.of(), "")));
    monitors.observe(new TraceEvent.Left(1, ONE));
    assertThat(monitors.report().neverChecked()).containsExactly("found", "nothing");
    assertThat(monitors.report().inapplicable("nothing")).isEqualTo("an object is there");
    assertThat(monitors.report().inapplicable("found")).isEmpty();
  }

  @Test
  void violationsThatAreNotKeptAreCounted() {
    SpecReport report = new SpecReport();
    int found = SpecReport.MAX_KEPT_PER_LEMMA + 7;
    for (int i = 0; i < found; i++) {
      report.violated("Kept", 5_000_000, List.of(), "again");
    }
    assertThat(report.violations()).hasSize(SpecReport.MAX_KEPT_PER_LEMMA);
    assertThat(report.violations("Kept")).isEqualTo(found);
    assertThat(report.violations().get(0)).hasToString("Kept violated at 0.005 s: again");
  }

  @Test
  void monitorsSeeEveryEventAndTheEndOnce() {
    Monitors monitors = new Monitors(List.of(new EveryActionIs("go"), new EveryActionIs("stop")));
    monitors.observe(said(1, "go"));
    monitors.finish(9);

    assertThat(monitors.lemmas()).containsExactly("go", "stop");
    assertThat(monitors.report().checks("go")).isEqualTo(2);
    assertThat(monitors.report().violations("go")).isZero();
    assertThat(monitors.report().violations("stop")).isEqualTo(1);
    assertThatThrownBy(() -> monitors.finish(9)).isInstanceOf(IllegalStateException.class);
    assertThatThrownBy(() -> monitors.observe(said(9, "go")))
        .isInstanceOf(IllegalStateException.class);
  }

  @Test
  void newViolationsAreReturnedOnce() {
    Monitors monitors = new Monitors(List.of(new EveryActionIs("go")));
    assertThat(monitors.newViolations()).isEmpty();
    monitors.observe(said(1, "stop"));
    monitors.observe(said(2, "halt"));
    assertThat(monitors.newViolations())
        .extracting(Violation::detail)
        .containsExactly("stop", "halt");
    assertThat(monitors.newViolations()).isEmpty();
    monitors.observe(said(3, "stay"));
    assertThat(monitors.newViolations()).extracting(Violation::detail).containsExactly("stay");
    assertThat(monitors.report().violations()).hasSize(3);
  }

  @Test
  void companionsFollowTheCreatedMonitorsOncePerClass() {
    Monitors monitors =
        Monitors.of(
            List.of(
                () -> new Accompanied("left"),
                () -> new Accompanied("right"),
                () -> new EveryActionIs("go")));
    assertThat(monitors.lemmas()).containsExactly("left", "right", "go", "with left");
    assertThat(new Monitors(List.of(new Accompanied("left"))).lemmas()).containsExactly("left");
  }

  private record Accompanied(String name) implements Monitor {

    @Override
    public List<String> lemmas() {
      return List.of(name);
    }

    @Override
    public List<Monitor> companions() {
      return List.of(new EveryActionIs("go too"), new Companion("with " + name));
    }

    @Override
    public void observe(TraceEvent event, Report report) {}
  }

  private static TraceEvent said(long timeNs, String word) {
    return TraceEvent.Action.of(timeNs, ONE, Instance.APP, Note.SHAPE, new Note(word, List.of()));
  }

  private record Companion(String name) implements Monitor {

    @Override
    public List<String> lemmas() {
      return List.of(name);
    }

    @Override
    public void observe(TraceEvent event, Report report) {}
  }

  private record EveryActionIs(String name) implements Monitor {

    @Override
    public List<String> lemmas() {
      return List.of(name);
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      report.checked(name);
      if (event instanceof TraceEvent.Action action && !action.name().equals(name)) {
        report.violated(name, event.timeNs(), List.of(event.robot()), action.name());
      }
    }

    @Override
    public void finish(long endNs, Report report) {
      report.checked(name);
    }
  }
}
