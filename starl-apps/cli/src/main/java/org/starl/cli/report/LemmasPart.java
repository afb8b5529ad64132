package org.starl.cli.report;

import java.util.List;
import org.starl.cli.report.Claims.Claim;

/** What was checked, how often, and what it says. */
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
    html.element("th", "what it says", "scope", "col");
    for (String head : List.of("checks", "violations", "in runs")) {
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
    for (Claim claim : report.claims().of(lemma)) {
      html.open("div");
      html.text(claim.text());
      if (!claim.monitor().isEmpty()) {
        html.text(claim.text().isEmpty() ? "" : " ");
        html.element("span", claim.monitor(), "class", "note");
      }
      html.close();
    }
    html.close();
    String count = checks.checks() == 0 ? "never" : Say.count(checks.checks());
    html.element("td", count, "class", "n");
    html.element("td", Say.count(checks.violations()), "class", "n");
    html.element("td", Say.count(inRuns), "class", "n").close();
  }
}
