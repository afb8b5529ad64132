package org.starl.cli.report;

import java.util.List;
import java.util.Locale;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.cli.report.Claims.Claim;
import org.starl.cli.report.Pictured.Shot;
import org.starl.sim.check.CampaignResult.Run;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.check.RunOutcome.Verdict;
import org.starl.spec.SpecReport.Violation;

/** The runs that did not go well: what was wrong, pictures, story, how to run them again. */
final class BadRunsPart {

  private static final int MOST_STORY_LINES = 200;
  private static final long NS_PER_S = 1_000_000_000;
  private static final long NS_PER_MS = 1_000_000;

  private final Html html;
  private final Report report;

  BadRunsPart(Html html, Report report) {
    this.html = html;
    this.report = report;
  }

  /** Where a run is told, if it is. */
  static String anchor(long seed) {
    return "seed" + seed;
  }

  void write() {
    int bad = report.bad().size();
    html.open("section").element("h2", "What did not go well");
    if (report.pictured().size() < bad) {
      html.element(
          "p",
          "Of "
              + Say.count(bad, "run")
              + " that did not go well, "
              + report.pictured().size()
              + " are told here, with pictures: the first of each kind, then by seed. All of them"
              + " are in the table of runs.",
          "class",
          "note");
    }
    shrunk();
    SortedMap<Long, Run> runs = new TreeMap<>();
    report.bad().forEach(run -> runs.put(run.seed(), run));
    for (Pictured pictured : report.pictured()) {
      Run run = runs.get(pictured.seed());
      if (run == null) {
        throw new IllegalStateException("seed " + pictured.seed() + " has a picture, but no run");
      }
      write(run.outcome(), pictured);
    }
    html.close();
  }

  private void shrunk() {
    if (report.shrunk().isEmpty()) {
      return;
    }
    html.open("div", "class", "shrunk").element("h3", "The smallest that goes the same way");
    html.open("ul");
    report.shrunk().forEach(line -> html.element("li", line));
    html.close().close();
  }

  private void write(RunOutcome outcome, Pictured pictured) {
    html.open("article", "id", anchor(pictured.seed()));
    html.open("h3").text("Seed " + pictured.seed() + ": ");
    html.element("span", Page.of(outcome.verdict()), "class", "tag bad").close();
    html.element("p", outcome.detail(), "class", "detail");
    if (outcome.verdict() == Verdict.VIOLATED) {
      claims(outcome.what());
    }
    others(pictured.seed());
    if (!pictured.outcome().detail().equals(outcome.detail())) {
      html.element(
          "p",
          "Run again for its pictures, it ended otherwise: " + pictured.outcome().detail(),
          "class",
          "detail");
    }
    html.open("p", "class", "replay").text("Replay: ");
    html.command(report.subject().replay().apply(pictured.seed()));
    html.close();
    shots(pictured, outcome);
    story(pictured);
    html.close();
  }

  private void claims(String lemma) {
    for (Claim claim : report.claims().of(lemma)) {
      if (!claim.text().isEmpty()) {
        html.open("p", "class", "claim").element("code", lemma).text(" says: " + claim.text());
        html.close();
      }
    }
  }

  /** Besides the first. */
  private void others(long seed) {
    RunFacts facts = report.facts().get(seed);
    if (facts == null || facts.violated() < 2) {
      return;
    }
    List<Violation> more = facts.violations().subList(1, facts.violations().size());
    html.open("details");
    html.element("summary", Say.count(facts.violated() - 1, "more violation") + " in this run");
    html.open("ul");
    more.forEach(violation -> html.element("li", violation.toString()));
    long left = facts.violated() - 1 - more.size();
    if (left > 0) {
      html.element("li", "and " + Say.count(left) + " more");
    }
    html.close().close();
  }

  private void shots(Pictured pictured, RunOutcome outcome) {
    List<Shot> shots = pictured.shots();
    if (shots.isEmpty()) {
      return;
    }
    long momentNs = shots.get(shots.size() - 1).timeNs();
    html.open("div", "class", "film");
    for (Shot shot : shots) {
      String when = when(shot.timeNs(), momentNs, outcome.verdict());
      html.open("figure", "class", shot.isWhole() ? "whole" : "floor");
      html.empty(
          "img",
          "src",
          shot.address(),
          "alt",
          "Seed " + pictured.seed() + ", picture of the floor at " + when);
      html.element("figcaption", when).close();
    }
    html.close();
  }

  private static String when(long timeNs, long momentNs, Verdict verdict) {
    // Cut off, not rounded: as the violation's own text has it.
    String at =
        String.format(
            Locale.ROOT, "%d.%03d\u00A0s", timeNs / NS_PER_S, timeNs % NS_PER_S / NS_PER_MS);
    if (timeNs == momentNs) {
      return at + (verdict == Verdict.VIOLATED ? ": the violation" : ": the end");
    }
    return at + ", " + Say.with("s", (double) (momentNs - timeNs) / NS_PER_S) + " before";
  }

  private void story(Pictured pictured) {
    if (pictured.story().isEmpty()) {
      return;
    }
    List<String> lines = pictured.story();
    int told = Math.min(lines.size(), MOST_STORY_LINES);
    html.open("details", "open", "open").element("summary", "Story").open("ol", "class", "story");
    lines.subList(0, told).forEach(line -> html.element("li", line));
    html.close();
    if (told < lines.size()) {
      html.element("p", "and " + Say.count(lines.size() - told, "more line"));
    }
    html.close();
  }
}
