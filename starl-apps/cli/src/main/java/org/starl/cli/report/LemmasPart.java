package org.starl.cli.report;

import java.util.List;
import org.starl.cli.report.LemmaDescriptions.Description;

/** The specifications: meaning, number of checks and violations. */
final class LemmasPart {

  private final Html html;
  private final Report report;

  LemmasPart(Html html, Report report) {
    this.html = html;
    this.report = report;
  }

  void write() {
    if (report.lemmas().isEmpty()) {
      return;
    }
    html.open("section").element("h2", "What was checked");
    html.open("div", "class", "wide").open("table", "class", "lemmas").open("thead").open("tr");
    html.element("th", "specification", "scope", "col");
    html.element("th", "meaning", "scope", "col");
    for (String head : List.of("checks", "violations", "runs with violations")) {
      html.element("th", head, "scope", "col", "class", "n");
    }
    html.close().close().open("tbody");
    report.lemmas().forEach(this::row);
    html.close().close().close().close();
  }

  private void row(String lemma, RunFacts.Checks checks) {
    long inRuns =
        report.facts().values().stream()
            .map(run -> run.lemmas().get(lemma))
            .filter(of -> of != null && of.violations() > 0)
            .count();
    html.open("tr", "class", inRuns > 0 ? "bad" : "good");
    html.open("th", "scope", "row").element("code", lemma).close();
    html.open("td");
    for (Description description : report.lemmaDescriptions().of(lemma)) {
      html.open("div");
      html.text(description.text());
      if (!description.monitor().isEmpty()) {
        html.text(description.text().isEmpty() ? "" : " ");
        html.element("span", description.monitor(), "class", "note");
      }
      html.close();
    }
    html.close();
    String count = checks.checks() == 0 ? "never" : NumberFormats.count(checks.checks());
    html.element("td", count, "class", "n");
    html.element("td", NumberFormats.count(checks.violations()), "class", "n");
    html.element("td", NumberFormats.count(inRuns), "class", "n").close();
  }
}
