package org.starl.cli.report;

import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.sim.check.CampaignResult;

/** Every number that runs have, and how it is spread over them. */
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
    html.open("section").element("h2", "Figures of a run");
    html.open("div", "class", "charts");
    if (!result.figures().isEmpty()) {
      html.open("div", "class", "wide").open("table");
      html.element("caption", "Each over all runs").open("thead").open("tr");
      html.element("th", "figure", "scope", "col");
      for (String head : List.of("least", "median", "95\u00A0%", "most")) {
        html.element("th", head, "scope", "col", "class", "n");
      }
      html.close().close().open("tbody");
      for (String figure : result.figures()) {
        html.open("tr").open("th", "scope", "row").element("code", figure).close();
        for (double percent : PERCENTILES) {
          html.element("td", Say.number(result.percentile(figure, percent)), "class", "n");
        }
        html.close();
      }
      html.close().close().close();
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
    html.open("div", "class", "wide").open("table").element("caption", "Counted in all runs");
    html.open("tbody");
    sums.forEach((what, count) -> {
      html.open("tr").element("th", what, "scope", "row");
      html.element("td", Say.count(count), "class", "n").close();
    });
    html.close().close().close();
  }

  private void settings() {
    html.open("details").element("summary", "All settings");
    html.open("div", "class", "wide").open("table").open("tbody");
    for (Map.Entry<String, String> setting : report.subject().settings().entrySet()) {
      html.open("tr").open("th", "scope", "row").element("code", setting.getKey()).close();
      html.element("td", setting.getValue()).close();
    }
    html.close().close().close().close();
  }
}
