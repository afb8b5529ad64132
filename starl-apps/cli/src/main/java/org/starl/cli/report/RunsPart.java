package org.starl.cli.report;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.starl.sim.check.CampaignResult.Run;
import org.starl.sim.check.RunOutcome;

/** A table with a row for each run. */
final class RunsPart {

  /** A browser sorts this many rows without delay. */
  static final int MAX_ROWS = 5_000;

  /** Columns of numbers: the figure and its heading. */
  private static final List<List<String>> FIGURES =
      List.of(
          List.of("end_s", "simulated time, s"),
          List.of("datagrams_sent", "datagrams"),
          List.of("datagrams_lost", "copies lost"),
          List.of("robots_collided", "collisions"),
          List.of("walls_hit", "walls hit"));

  private final Html html;
  private final Report report;
  private final Set<Long> illustrated;

  RunsPart(Html html, Report report) {
    this.html = html;
    this.report = report;
    illustrated =
        report.illustrated().stream().map(IllustratedRun::seed).collect(Collectors.toSet());
  }

  void write() {
    List<Run> rows = rows();
    html.open("section").element("h2", "Every run");
    html.open("p").text("To repeat one run: ");
    html.command(report.description().replay().apply(report.result().runs().get(0).seed()));
    html.close();
    if (rows.size() < report.result().runs().size()) {
      html.element(
          "p",
          "The table has "
              + NumberFormats.count(rows.size())
              + " of "
              + NumberFormats.count(report.result().runs().size(), "run")
              + ". Runs that did not go well have precedence.",
          "class",
          "note");
    }
    html.open("div", "class", "wide runs");
    html.open("table", "id", "runs").open("thead").open("tr");
    head("seed", "");
    head("verdict", "");
    FIGURES.forEach(figure -> head(figure.get(1), "n"));
    head("violations", "n");
    if (!report.bad().isEmpty()) {
      html.element("th", "problem", "scope", "col");
    }
    html.element("th", "replay", "scope", "col");
    html.close().close().open("tbody");
    rows.forEach(this::row);
    html.close().close().close().close();
  }

  private void head(String text, String cssClass) {
    html.element("th", text, "scope", "col", "data-sort", "", "class", cssClass);
  }

  private List<Run> rows() {
    List<Run> runs = report.result().runs();
    if (runs.size() <= MAX_ROWS) {
      return runs;
    }
    Set<Run> chosen = new LinkedHashSet<>(report.bad());
    chosen.addAll(runs);
    SortedMap<Long, Run> bySeed = new TreeMap<>();
    chosen.stream().limit(MAX_ROWS).forEach(run -> bySeed.put(run.seed(), run));
    return new ArrayList<>(bySeed.values());
  }

  private void row(Run run) {
    RunOutcome outcome = run.outcome();
    html.open("tr", "class", outcome.isGood() ? "good" : "bad");
    html.open("th", "scope", "row", "data-v", Long.toString(run.seed()));
    if (illustrated.contains(run.seed())) {
      html.element("a", Long.toString(run.seed()), "href", "#" + BadRunsPart.anchor(run.seed()));
    } else {
      html.text(Long.toString(run.seed()));
    }
    html.close();
    html.open("td", "data-v", Integer.toString(outcome.verdict().ordinal()));
    html.element("span", Page.of(outcome.verdict()), "class", outcome.isGood() ? "tag" : "tag bad");
    html.close();
    for (List<String> figure : FIGURES) {
      Double value = outcome.figures().get(figure.get(0));
      number(
          value == null ? "" : NumberFormats.number(value),
          value == null ? "-1" : value.toString());
    }
    RunFacts facts = report.facts().get(run.seed());
    number(
        facts == null ? "" : NumberFormats.count(facts.violated()),
        facts == null ? "-1" : Long.toString(facts.violated()));
    if (!report.bad().isEmpty()) {
      html.element("td", outcome.detail(), "class", "detail");
    }
    html.open("td", "class", "replay");
    html.element("code", report.description().replay().apply(run.seed()), "class", "command");
    html.close().close();
  }

  private void number(String text, String value) {
    html.element("td", text, "class", "n", "data-v", value);
  }
}
