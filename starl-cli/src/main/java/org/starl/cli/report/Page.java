package org.starl.cli.report;

import static org.starl.cli.report.NumberFormats.count;
import static org.starl.cli.report.NumberFormats.measured;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.function.ToLongFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.starl.Version;
import org.starl.input.TextFile;
import org.starl.sim.check.RunOutcome.Verdict;
import org.starl.sim.view.page.RunPage;
import org.starl.time.Time;

/** The page of a campaign: its frame and its head; other classes write the other parts. */
public final class Page {

  private final Report report;
  private final Html html = new Html();

  public Page(Report report) {
    this.report = report;
  }

  /** The HTML of the page. Call it once. */
  public String write() {
    html.open("html", "lang", "en");
    head(html, report.description().app() + ": " + verdict());
    html.open("body");
    header();
    html.contents().open("main");
    if (!report.bad().isEmpty()) {
      new BadRunsPart(html, report).write();
    }
    steered();
    samples();
    CampaignTables tables = new CampaignTables(html, report);
    tables.messages();
    tables.chances();
    tables.lemmas();
    new CoverageTables(html, report.coverage()).write();
    tables.figures();
    tables.runs();
    html.close();
    footer(html);
    return html.page();
  }

  private void steered() {
    if (!report.steered().isEmpty()) {
      html.section("Steered runs");
      report.steered().forEach(line -> html.element("p", line));
      if (!report.steeredReplay().isEmpty()) {
        html.open("p").command(report.steeredReplay()).close();
      }
      html.close();
    }
  }

  /** The end of a page that the same command makes again: closes its body. */
  static void footer(Html html) {
    footer(html, "Equal seeds give equal runs: the same command makes this page again.");
  }

  /** The end of a page: closes its body. */
  static void footer(Html html, String how) {
    html.open("footer");
    html.element("p", "Made by StarL " + Version.STARL + ". All times are simulated. " + how);
    html.close();
    html.code("script", TextFile.resource(Page.class, "report.js"));
    html.close().close();
  }

  /** The policy lets the browser use only the page's own styles, scripts and images. */
  static void head(Html html, String title) {
    String style = TextFile.resource(Page.class, "report.css");
    String script = TextFile.resource(Page.class, "report.js");
    html.open("head").empty("meta", "charset", "utf-8");
    html.empty(
        "meta",
        "http-equiv",
        "Content-Security-Policy",
        "content",
        "default-src 'none'; img-src data:; style-src %s; script-src %s"
            .formatted(hashes(style, RunPage.styles()), hashes(script, List.of(RunPage.script()))));
    html.empty("meta", "name", "viewport", "content", "width=device-width, initial-scale=1");
    html.empty("meta", "name", "color-scheme", "content", "light dark");
    html.element("title", title);
    html.code("style", style).close();
  }

  /** {@code all 200 runs went well}. */
  private String verdict() {
    return verdict(report.result().runs().size(), report.result()::count);
  }

  /**
   * How the runs went, in words.
   *
   * @param counts the number of runs that ended so
   */
  static String verdict(long runs, ToLongFunction<Verdict> counts) {
    long bad = runs - counts.applyAsLong(Verdict.GOOD);
    if (bad == 0) {
      return runs == 1 ? "its run went well" : "all " + count(runs) + " runs went well";
    }
    List<String> kinds = new ArrayList<>();
    for (Verdict verdict : List.of(Verdict.VIOLATED, Verdict.FAILED, Verdict.UNFINISHED)) {
      if (counts.applyAsLong(verdict) > 0) {
        kinds.add(count(counts.applyAsLong(verdict)) + " " + of(verdict));
      }
    }
    return "%s of %s did not go well (%s)"
        .formatted(count(bad), count(runs, "run"), String.join(", ", kinds));
  }

  /** The verdict, the campaign's description, the key figures and a picture. */
  private void header() {
    html.open("header").element("h1", report.description().app());
    html.element("p", report.description().summary(), "class", "summary");
    verdict(html, verdict(), report.bad().isEmpty());
    description();
    keyFigures();
    example();
    html.close();
  }

  static void verdict(Html html, String verdict, boolean isGood) {
    html.open("p", "class", isGood ? "verdict good" : "verdict bad");
    html.element("span", isGood ? "\u2713" : "\u2717", "aria-hidden", "true", "class", "sign");
    html.text(" " + NumberFormats.capitalized(verdict) + ".").close();
  }

  private void description() {
    CampaignDescription description = report.description();
    html.open("dl", "class", "ran");
    html.element("dt", "Command").open("dd").command(description.command()).close();
    html.element("dt", "Seeds").element("dd", description.seeds());
    html.element("dt", "Faults").open("dd");
    if (description.faults().isEmpty()) {
      html.text("none requested");
    } else {
      list(description.faults());
    }
    html.close();
    if (!description.given().isEmpty()) {
      html.element("dt", "Settings").open("dd");
      list(description.given());
      html.close();
    }
    html.element("dt", "StarL").element("dd", Version.STARL).close();
  }

  private void list(List<String> items) {
    html.open("ul");
    items.forEach(item -> html.open("li").element("code", item).close());
    html.close();
  }

  private void keyFigures() {
    html.open("ul", "class", "figures");
    int runs = report.result().runs().size();
    Totals totals = report.totals();
    String tasks = count(totals.completed()) + " of " + count(totals.came());
    // Of a violated run, completed tasks are no figure of their own: the run did not go well.
    boolean isViolated = report.result().count(Verdict.VIOLATED) > 0 && totals.came() > 0;
    figure(
        count(report.result().count(Verdict.GOOD)) + " of " + count(runs),
        "runs went well"
            + (isViolated ? ", though " + tasks + " " + totals.tasks() + " finished" : ""));
    if (totals.came() > 0 && !isViolated) {
      figure(tasks, totals.tasks() + " finished");
    }
    if (totals.hasWaits()) {
      figure(measured("s", Time.seconds(totals.waitNs(50))), "waiting time, median");
      figure(measured("s", Time.seconds(totals.waitNs(95))), "waiting time, 95th percentile");
    }
    if (report.result().samples("end_s") > 0) {
      figure(
          measured("s", report.result().percentile("end_s", 50)),
          "simulated time of a run, median");
    }
    long checks = report.lemmas().values().stream().mapToLong(RunFacts.Checks::checks).sum();
    if (checks > 0) {
      figure(count(checks), "checks of " + count(report.lemmas().size(), "specification"));
    }
    html.close();
  }

  private void figure(String value, String meaning) {
    html.open("li").element("strong", value).text(" ").element("span", meaning).close();
  }

  private void example() {
    IllustratedRun example = report.example();
    if (example == null || example.shots().isEmpty()) {
      return;
    }
    html.open("figure", "class", "example");
    String alt =
        "The floor and the robots with their states, at one moment of the run with seed "
            + example.seed();
    html.empty("img", "src", example.shots().get(0).address(), "alt", alt);
    html.element("figcaption", "Seed " + example.seed() + ", at the moment that shows most.");
    html.close();
  }

  private void samples() {
    for (Report.Sampled sampled : report.samples()) {
      if (sampled.isEmpty()) {
        continue;
      }
      html.section(NumberFormats.capitalized(sampled.name()));
      switch (sampled.kind()) {
        case SIZES ->
            new SizeCharts(html, sampled.name(), sampled.unit(), Distribution.ofAll(sampled.runs()))
                .write();
        case TIMES -> new TimeChart(html, sampled.name(), sampled.runs()).write();
      }
      html.close();
    }
  }

  static String of(Verdict verdict) {
    return verdict.name().toLowerCase(Locale.ROOT);
  }

  private static String hashes(String own, List<String> ofPlayers) {
    return Stream.concat(Stream.of(own), ofPlayers.stream())
        .map(Page::hash)
        .collect(Collectors.joining(" "));
  }

  private static String hash(String code) {
    try {
      byte[] digest =
          MessageDigest.getInstance("SHA-256").digest(code.getBytes(StandardCharsets.UTF_8));
      return "'sha256-" + Base64.getEncoder().encodeToString(digest) + "'";
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }
}
