package org.starl.cli.report;

import static org.starl.cli.report.NumberFormats.count;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.starl.cli.report.IllustratedRun.Shot;
import org.starl.sim.Diagnosis;
import org.starl.sim.Failure;
import org.starl.sim.check.CampaignResult.Run;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.check.RunOutcome.Verdict;
import org.starl.time.Time;

/** The bad runs, each with its problem, pictures, story and replay command. */
record BadRunsPart(Html html, Report report) {

  private static final int MAX_STORY_LINES = 200;

  /** The id of a run's section. */
  static String anchor(long seed) {
    return "seed" + seed;
  }

  void write() {
    int bad = report.bad().size();
    html.section("Bad runs");
    if (report.illustrated().size() < bad) {
      html.element(
          "p",
          ("%s did not go well. This section shows %s of them, with pictures: the first of each"
                  + " kind, then by seed. The table of runs has all of them.")
              .formatted(count(bad, "run"), report.illustrated().size()),
          "class",
          "note");
    }
    shrunk();
    for (IllustratedRun illustrated : report.illustrated()) {
      Stream<Run> ofSeed = report.bad().stream().filter(run -> run.seed() == illustrated.seed());
      write(ofSeed.findFirst().orElseThrow().outcome(), illustrated);
    }
    html.close();
  }

  private void shrunk() {
    if (report.shrunk().isEmpty()) {
      return;
    }
    html.open("div", "class", "shrunk")
        .element("h3", "The smallest run that fails in the same way");
    html.open("ul");
    report.shrunk().forEach(line -> html.element("li", line));
    html.close().close();
  }

  private void write(RunOutcome outcome, IllustratedRun illustrated) {
    html.open("article", "id", anchor(illustrated.seed()));
    html.open("h3").text("Seed " + illustrated.seed() + ": ");
    html.element("span", Page.of(outcome.verdict()), "class", "tag bad").close();
    html.element("p", outcome.detail(), "class", "detail");
    if (outcome.verdict() == Verdict.VIOLATED) {
      describe(outcome.what());
    }
    moreViolations(illustrated.seed());
    if (!illustrated.outcome().detail().equals(outcome.detail())) {
      html.element(
          "p",
          "Run again for its pictures, it ended differently: " + illustrated.outcome().detail(),
          "class",
          "detail");
    }
    failure(illustrated.failure());
    illustrated.diagnoses().forEach(this::diagnosis);
    html.open("p", "class", "replay").text("Replay: ");
    html.command(report.description().replay().apply(illustrated.seed())).close();
    html.open("p", "class", "replay").text("Shrink: ");
    html.command(report.description().shrink().apply(illustrated.seed())).close();
    shots(illustrated, outcome);
    chart(illustrated);
    player(illustrated);
    story(illustrated);
    html.close();
  }

  private void describe(String lemma) {
    for (String text : report.descriptions(lemma)) {
      html.open("p", "class", "claim").element("code", lemma).text(" says: " + text).close();
    }
  }

  /** All violations after the first. */
  private void moreViolations(long seed) {
    RunFacts facts = report.facts().get(seed);
    if (facts == null || facts.violated() < 2) {
      return;
    }
    List<String> more = facts.violations().subList(1, facts.violations().size());
    String summary = count(facts.violated() - 1, "more violation") + " in this run";
    html.open("details").element("summary", summary);
    html.open("ul");
    more.forEach(violation -> html.element("li", violation));
    long left = facts.violated() - 1 - more.size();
    if (left > 0) {
      html.element("li", "and " + count(left) + " more");
    }
    html.close().close();
  }

  /** Where its robots were, and the likely cause; the story has the faults. */
  private void failure(@Nullable Failure failure) {
    if (failure != null) {
      html.open("ul", "class", "failure");
      failure.reasons().forEach(line -> html.element("li", line));
      html.close();
    }
  }

  private void diagnosis(String when, Diagnosis diagnosis) {
    html.open("div", "class", "diagnosis");
    boolean isCauseKnown = !diagnosis.cause().isEmpty();
    if (isCauseKnown) {
      html.element("p", "Likely cause, " + when + ": " + diagnosis.cause(), "class", "detail");
      new WaitsPicture(html, diagnosis).write();
    }
    String summary = "The robots' state" + (isCauseKnown ? "" : ", " + when);
    html.open("details").element("summary", summary).open("ul");
    diagnosis.lines().forEach(line -> html.element("li", line.strip()));
    html.close().close().close();
  }

  private void shots(IllustratedRun illustrated, RunOutcome outcome) {
    List<Shot> shots = illustrated.shots();
    if (shots.isEmpty()) {
      return;
    }
    long momentNs = shots.get(shots.size() - 1).timeNs();
    html.open("div", "class", "film");
    for (Shot shot : shots) {
      String when = when(shot.timeNs(), momentNs, outcome.verdict());
      html.open("figure", "class", shot.isWhole() ? "whole" : "floor");
      String alt = "Seed " + illustrated.seed() + ", picture of the floor at " + when;
      html.empty("img", "src", shot.address(), "alt", alt);
      html.element("figcaption", when).close();
    }
    html.close();
  }

  private void chart(IllustratedRun illustrated) {
    if (!illustrated.chart().isEmpty()) {
      html.open("details").element("summary", "The messages before it");
      String alt = "Seed " + illustrated.seed() + ", message sequence chart";
      html.empty("img", "src", illustrated.chart(), "alt", alt);
      html.close();
    }
  }

  /** The browser loads the player when the reader opens it. */
  private void player(IllustratedRun illustrated) {
    if (illustrated.page().isEmpty()) {
      return;
    }
    html.open("details", "class", "player").element("summary", "Play the seconds around it");
    html.element(
        "iframe",
        "",
        "title",
        "Seed " + illustrated.seed() + ", played",
        "loading",
        "lazy",
        "sandbox",
        "allow-scripts",
        "srcdoc",
        illustrated.page());
    html.close();
  }

  private static String when(long timeNs, long momentNs, Verdict verdict) {
    // Truncated, not rounded, as in the violation's own text.
    String at =
        String.format(
            Locale.ROOT,
            "%d.%03d\u00A0s",
            timeNs / Time.NS_PER_S,
            timeNs % Time.NS_PER_S / Time.NS_PER_MS);
    if (timeNs == momentNs) {
      return at + (verdict == Verdict.VIOLATED ? ": the violation" : ": the end");
    }
    return at + ", " + NumberFormats.number("s", Time.seconds(momentNs - timeNs)) + " before";
  }

  private void story(IllustratedRun illustrated) {
    if (illustrated.story().isEmpty()) {
      return;
    }
    List<String> lines = illustrated.story();
    int shown = Math.min(lines.size(), MAX_STORY_LINES);
    html.open("details", "open", "open").element("summary", "Story").open("ol", "class", "story");
    lines.subList(0, shown).forEach(line -> html.element("li", line));
    html.close();
    if (shown < lines.size()) {
      html.element("p", "and " + count(lines.size() - shown, "more line"));
    }
    html.close();
  }
}
