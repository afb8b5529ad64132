package org.starl.cli.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.starl.Version;
import org.starl.sim.check.RunOutcome.Verdict;

/** The verdict, the campaign's description and the key figures. */
final class HeadPart {

  private final Html html;
  private final Report report;

  HeadPart(Html html, Report report) {
    this.html = html;
    this.report = report;
  }

  /** {@code all 200 runs went well}. */
  static String verdict(Report report) {
    int runs = report.result().runs().size();
    long bad = report.bad().size();
    if (bad == 0) {
      return runs == 1
          ? "its run went well"
          : "all " + NumberFormats.count(runs) + " runs went well";
    }
    List<String> how = new ArrayList<>();
    for (Verdict verdict : List.of(Verdict.VIOLATED, Verdict.FAILED, Verdict.UNFINISHED)) {
      if (report.count(verdict) > 0) {
        how.add(NumberFormats.count(report.count(verdict)) + " " + Page.of(verdict));
      }
    }
    return NumberFormats.count(bad)
        + " of "
        + NumberFormats.count(runs, "run")
        + " did not go well ("
        + String.join(", ", how)
        + ")";
  }

  void write() {
    boolean isGood = report.bad().isEmpty();
    html.open("header");
    html.open("h1").text(report.description().app()).close();
    html.element("p", report.description().summary(), "class", "summary");
    html.open("p", "class", isGood ? "verdict good" : "verdict bad");
    html.element("span", isGood ? "\u2713" : "\u2717", "aria-hidden", "true", "class", "sign");
    html.text(" " + NumberFormats.capitalized(verdict(report)) + ".").close();
    description();
    figures();
    example();
    html.close();
  }

  private void description() {
    CampaignDescription description = report.description();
    html.open("dl", "class", "ran");
    html.element("dt", "Command").open("dd").command(description.command());
    html.close();
    html.element("dt", "Seeds").element("dd", description.seeds());
    html.element("dt", "Faults").open("dd");
    if (description.faults().isEmpty()) {
      html.text("none requested");
    } else {
      html.open("ul");
      description.faults().forEach(fault -> html.open("li").element("code", fault).close());
      html.close();
    }
    html.close();
    if (!description.given().isEmpty()) {
      html.element("dt", "Settings").open("dd").open("ul");
      for (Map.Entry<String, String> setting : description.given().entrySet()) {
        html.open("li").element("code", setting.getKey() + "=" + setting.getValue()).close();
      }
      html.close().close();
    }
    html.element("dt", "StarL").element("dd", Version.STARL).close();
  }

  private void figures() {
    html.open("ul", "class", "figures");
    int runs = report.result().runs().size();
    long good = report.count(Verdict.GOOD);
    figure(NumberFormats.count(good) + " of " + NumberFormats.count(runs), "runs went well");
    long came = report.facts().values().stream().mapToLong(run -> run.measures().came()).sum();
    long done = report.facts().values().stream().mapToLong(run -> run.measures().completed()).sum();
    if (came > 0) {
      figure(
          NumberFormats.count(done) + " of " + NumberFormats.count(came),
          "robots completed their task");
    }
    Distribution waits =
        Distribution.ofAll(
            report.facts().values().stream()
                .map(run -> run.measures().waitsNs().stream().map(ns -> ns / 1e9).toList())
                .toList());
    if (!waits.isEmpty()) {
      figure(NumberFormats.measured("s", waits.percentile(50)), "waiting time, median");
      figure(NumberFormats.measured("s", waits.percentile(95)), "waiting time, 95th percentile");
    }
    if (report.result().samples("end_s") > 0) {
      figure(
          NumberFormats.measured("s", report.result().percentile("end_s", 50)),
          "simulated time of a run, median");
    }
    long checks = report.lemmas().values().stream().mapToLong(RunFacts.Checks::checks).sum();
    if (checks > 0) {
      figure(
          NumberFormats.count(checks),
          "checks of " + NumberFormats.count(report.lemmas().size(), "specification"));
    }
    html.close();
  }

  private void figure(String value, String what) {
    html.open("li").element("strong", value).text(" ").element("span", what).close();
  }

  private void example() {
    IllustratedRun example = report.example();
    if (example == null || example.shots().isEmpty()) {
      return;
    }
    html.open("figure", "class", "example");
    html.empty(
        "img",
        "src",
        example.shots().get(0).address(),
        "alt",
        "The floor and the robots with their states, at one moment of the run with seed "
            + example.seed());
    html.element("figcaption", "Seed " + example.seed() + ", at the moment that shows most.");
    html.close();
  }
}
