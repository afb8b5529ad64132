package org.starl.cli.report;

import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.sim.check.CampaignResult;

/** Each figure's distribution over the runs, totals, and all settings. */
final class FiguresPart {

  private static final double[] PERCENTILES = {0, 50, 95, 100};

  private final Html html;
  private final Report report;

  FiguresPart(Html html, Report report) {
    this.html = html;
    this.report = report;
  }

  void write() {
    CampaignResult result = report.result();
    html.open("section").element("h2", "Figures per run");
    html.open("div", "class", "charts");
    if (!result.figures().isEmpty()) {
      html.table(
          "", "Over all runs", List.of("figure", "minimum", "median", "95\u00A0%", "maximum"));
      for (String figure : result.figures()) {
        html.open("tr").open("th", "scope", "row").element("code", figure).close();
        for (double percent : PERCENTILES) {
          html.element(
              "td", NumberFormats.number(result.percentile(figure, percent)), "class", "n");
        }
        html.close();
      }
      html.endTable();
    }
    counts();
    html.close();
    settings();
    html.close();
  }

  private void counts() {
    SortedMap<String, Long> sums = new TreeMap<>();
    report
        .facts()
        .values()
        .forEach(
            run -> run.measures().counts().forEach((what, n) -> sums.merge(what, n, Long::sum)));
    if (sums.isEmpty()) {
      return;
    }
    html.table("", "Totals over all runs", List.of("name", "total"));
    sums.forEach((what, count) -> {
      html.open("tr").element("th", what, "scope", "row");
      html.element("td", NumberFormats.count(count), "class", "n").close();
    });
    html.endTable();
  }

  private void settings() {
    html.open("details").element("summary", "All settings");
    html.open("div", "class", "wide").open("table").open("tbody");
    for (Map.Entry<String, String> setting : report.description().settings().entrySet()) {
      html.open("tr").open("th", "scope", "row").element("code", setting.getKey()).close();
      html.element("td", setting.getValue()).close();
    }
    html.close().close().close().close();
  }
}
