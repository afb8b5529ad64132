package org.starl.cli.report;

import static org.starl.cli.report.NumberFormats.count;
import static org.starl.cli.report.NumberFormats.number;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.function.ToLongFunction;
import java.util.stream.Collectors;
import org.starl.sim.check.CampaignResult;
import org.starl.sim.check.CampaignResult.Run;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.net.NetStatistics;

/** The sections of the page that are tables: messages, specifications, figures and runs. */
record CampaignTables(Html html, Report report) {

  /** A browser sorts this many runs without delay. */
  static final int MAX_RUNS = 5_000;

  private static final double BYTES_PER_KB = 1e3;
  private static final double[] PERCENTILES = {0, 50, 95, 100};

  /** Columns of the table of runs: a figure and its heading. */
  private static final List<List<String>> FIGURES =
      List.of(
          List.of("end_s", "simulated time, s"),
          List.of("datagrams_sent", "datagrams"),
          List.of("datagrams_lost", "copies lost"),
          List.of("robots_collided", "collisions"),
          List.of("walls_hit", "walls hit"));

  /** The messages by channel, and the dropped copies by cause. */
  void messages() {
    long sent = sum(NetStatistics::sent);
    if (sent == 0) {
      return;
    }
    int runs = report.facts().size();
    long delivered = sum(NetStatistics::delivered);
    long lost = sum(NetStatistics::lost);
    html.section("Messages");
    html.element(
        "p",
        ("%s datagrams were sent in %s (%s a run, %s each). Each recipient of a datagram has its"
                + " own copy: %s copies arrived, %s (%s) were lost.")
            .formatted(
                count(sent),
                count(runs, "run"),
                number(Math.rint((double) sent / runs)),
                number("bytes", Math.rint((double) sum(NetStatistics::sentBytes) / sent)),
                count(delivered),
                count(lost),
                NumberFormats.percent(lost, lost + delivered)));
    MessageCounts messages = report.messages();
    html.open("div", "class", "charts");
    channels(messages.channels());
    causes(messages.dropped());
    html.close().close();
  }

  private long sum(ToLongFunction<NetStatistics> part) {
    return report.facts().values().stream().map(RunFacts::network).mapToLong(part).sum();
  }

  private void channels(SortedMap<String, MessageCounts.Channel> channels) {
    if (channels.isEmpty()) {
      return;
    }
    long most = channels.values().stream().mapToLong(MessageCounts.Channel::sent).max().orElse(1);
    html.table("bars", "By channel", List.of("channel", "sent", "", "kB", "received"));
    channels.forEach((name, channel) -> {
      html.row(name).number(count(channel.sent()));
      bar(channel.sent(), most);
      html.number(number(channel.sentBytes() / BYTES_PER_KB));
      html.number(count(channel.delivered())).close();
    });
    html.endTable();
  }

  private void causes(SortedMap<String, Long> dropped) {
    if (dropped.isEmpty()) {
      return;
    }
    long most = dropped.values().stream().mapToLong(Long::longValue).max().orElse(1);
    html.table("bars", "Copies not delivered", List.of("cause", "copies", ""));
    dropped.forEach((why, copies) -> {
      html.row(why).number(count(copies));
      bar(copies, most);
      html.close();
    });
    html.endTable();
  }

  /** A bar in a cell of its own. Screen readers skip it: the number is in another cell. */
  private void bar(long value, long most) {
    html.open("td", "class", "bar", "aria-hidden", "true");
    html.open("svg", "viewBox", "0 0 100 10", "preserveAspectRatio", "none");
    String width = Plot.px(100.0 * value / Math.max(1, most));
    html.empty("rect", "class", "bar", "width", width, "height", "10").close().close();
  }

  /** The upper bounds of the probability that a run is bad. */
  void chances() {
    html.section("Error rates");
    html.element(
        "p",
        "A run of this campaign's kind is bad with a probability below the bound, at 95\u00A0%"
            + " confidence (Clopper and Pearson). Each row has the runs with one kind of fault.",
        "class",
        "note");
    html.table("", "Bad runs", List.of("runs with", "bad", "all", "share", "below"));
    report
        .chances()
        .counts()
        .forEach((kind, count) -> {
          if (kind.isEmpty()) {
            html.open("tr").element("th", "all", "scope", "row");
          } else {
            html.row(kind);
          }
          html.number(count(count.bad())).number(count(count.runs()));
          html.number(NumberFormats.percent(count.bad(), count.runs()));
          html.number(count.belowText()).close();
        });
    html.endTable().close();
  }

  /** The specifications: meaning, number of checks and violations. */
  void lemmas() {
    if (report.lemmas().isEmpty()) {
      return;
    }
    html.section("Specifications");
    SortedSet<String> never = report.result().neverChecked();
    if (!never.isEmpty()) {
      String text = "Never checked, so unknown: " + String.join(", ", never) + ".";
      String verdict = " In a campaign of so many runs that is a failure.";
      html.element(
          "p", text + (report.result().leavesUnchecked() ? verdict : ""), "class", "verdict bad");
    }
    html.wide().open("table", "class", "lemmas").open("thead").open("tr");
    html.element("th", "specification", "scope", "col");
    html.element("th", "meaning", "scope", "col");
    for (String head : List.of("checks", "violations", "runs with violations")) {
      html.element("th", head, "scope", "col", "class", "n");
    }
    html.close().close().open("tbody");
    report.lemmas().forEach(this::lemma);
    html.endTable().close();
  }

  private void lemma(String lemma, RunFacts.Checks checks) {
    long inRuns =
        report.facts().values().stream()
            .map(run -> run.lemmas().get(lemma))
            .filter(of -> of != null && of.violations() > 0)
            .count();
    html.open("tr", "class", inRuns > 0 ? "bad" : "good");
    html.open("th", "scope", "row").element("code", lemma).close();
    html.open("td");
    report.descriptions(lemma).forEach(text -> html.element("div", text));
    html.close();
    html.number(checks.checks() == 0 ? "never checked" : count(checks.checks()));
    html.number(count(checks.violations())).number(count(inRuns)).close();
  }

  /** Each figure's distribution over the runs, totals, and all settings. */
  void figures() {
    CampaignResult result = report.result();
    html.section("Figures per run");
    html.open("div", "class", "charts");
    if (!result.figures().isEmpty()) {
      html.table(
          "", "Over all runs", List.of("figure", "minimum", "median", "95\u00A0%", "maximum"));
      for (String figure : result.figures()) {
        html.row(figure);
        for (double percent : PERCENTILES) {
          html.number(number(result.percentile(figure, percent)));
        }
        html.close();
      }
      html.endTable();
    }
    SortedMap<String, Long> counts = report.totals().counts();
    if (!counts.isEmpty()) {
      html.table("", "Totals over all runs", List.of("name", "total"));
      counts.forEach((name, count) ->
          html.open("tr").element("th", name, "scope", "row").number(count(count)).close());
      html.endTable();
    }
    html.close();
    html.open("details").element("summary", "All settings");
    html.wide().open("table").open("tbody");
    report
        .description()
        .settings()
        .forEach((key, value) -> html.row(key).element("td", value).close());
    html.endTable().close().close();
  }

  /** A row for each run. */
  void runs() {
    List<Run> all = report.result().runs();
    List<Run> shown = shownRuns();
    html.section("Every run");
    html.open("p").text("To repeat one run: ");
    html.command(report.description().replay().apply(all.get(0).seed())).close();
    if (shown.size() < all.size()) {
      html.element(
          "p",
          "The table has %s of %s. Runs that did not go well have precedence."
              .formatted(count(shown.size()), count(all.size(), "run")),
          "class",
          "note");
    }
    html.open("div", "class", "wide runs");
    html.open("table", "id", "runs").open("thead").open("tr");
    sortable("seed", "");
    sortable("verdict", "");
    FIGURES.forEach(figure -> sortable(figure.get(1), "n"));
    sortable("violations", "n");
    if (!report.bad().isEmpty()) {
      html.element("th", "problem", "scope", "col");
    }
    html.element("th", "replay", "scope", "col");
    html.close().close().open("tbody");
    Set<Long> illustrated =
        report.illustrated().stream().map(IllustratedRun::seed).collect(Collectors.toSet());
    shown.forEach(run -> run(run, illustrated.contains(run.seed())));
    html.endTable().close();
  }

  private void sortable(String text, String cssClass) {
    html.element("th", text, "scope", "col", "data-sort", "", "class", cssClass);
  }

  private List<Run> shownRuns() {
    Set<Run> badFirst = new LinkedHashSet<>(report.bad());
    badFirst.addAll(report.result().runs());
    Map<Long, Run> bySeed = new TreeMap<>();
    badFirst.stream().limit(MAX_RUNS).forEach(run -> bySeed.put(run.seed(), run));
    return List.copyOf(bySeed.values());
  }

  private void run(Run run, boolean isIllustrated) {
    RunOutcome outcome = run.outcome();
    String seed = Long.toString(run.seed());
    html.open("tr", "class", outcome.isGood() ? "good" : "bad");
    html.open("th", "scope", "row", "data-v", seed);
    if (isIllustrated) {
      html.element("a", seed, "href", "#" + BadRunsPart.anchor(run.seed()));
    } else {
      html.text(seed);
    }
    html.close();
    html.open("td", "data-v", Integer.toString(outcome.verdict().ordinal()));
    html.element("span", Page.of(outcome.verdict()), "class", outcome.isGood() ? "tag" : "tag bad");
    html.close();
    for (List<String> figure : FIGURES) {
      Double value = outcome.figures().get(figure.get(0));
      sortableNumber(value == null ? "" : number(value), value == null ? -1.0 : value);
    }
    RunFacts facts = report.facts().get(run.seed());
    sortableNumber(
        facts == null ? "" : count(facts.violated()), facts == null ? -1L : facts.violated());
    if (!report.bad().isEmpty()) {
      html.element("td", outcome.detail(), "class", "detail");
    }
    html.open("td", "class", "replay");
    html.element("code", report.description().replay().apply(run.seed()), "class", "command");
    html.close().close();
  }

  private void sortableNumber(String text, Number value) {
    html.element("td", text, "class", "n", "data-v", value.toString());
  }
}
