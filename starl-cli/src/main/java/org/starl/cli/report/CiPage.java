package org.starl.cli.report;

import java.util.List;

/** The page of several campaigns: one row for each, with links to its report and its bad runs. */
public final class CiPage {

  /**
   * One campaign.
   *
   * @param earlier how many of its runs an earlier command made
   * @param isGood whether every run went well and every lemma was checked
   * @param report its page, beside this one
   * @param bad the pages of bad runs, in the order of {@code problems}
   * @param problems one line each
   */
  public record Row(
      String app,
      long runs,
      long earlier,
      boolean isGood,
      String report,
      List<String> bad,
      List<String> problems) {}

  private CiPage() {}

  /** The HTML of the page. */
  public static String of(List<Row> rows) {
    Html html = new Html();
    html.open("html", "lang", "en");
    Page.head(html, "StarL: continuous integration");
    html.open("body").open("header").element("h1", "Continuous integration");
    long bad = rows.stream().filter(row -> !row.isGood()).count();
    String verdict =
        bad == 0 ? "every campaign went well" : bad + " of " + rows.size() + " did not";
    Page.verdict(html, verdict, bad == 0);
    html.close().open("main").section("Campaigns");
    html.open("table").open("thead").open("tr");
    for (String head : List.of("Campaign", "Seeds", "Of an earlier run", "Result")) {
      html.element("th", head, "scope", "col");
    }
    html.close().close().open("tbody");
    for (Row row : rows) {
      html.open("tr").open("th", "scope", "row").element("a", row.app(), "href", row.report());
      html.close();
      html.element("td", NumberFormats.count(row.runs()), "class", "number");
      html.element("td", NumberFormats.count(row.earlier()), "class", "number");
      html.open("td");
      result(html, row);
      html.close().close();
    }
    html.close().close().close().close();
    Page.footer(
        html, "How many seeds ran depends on the machine; what each of them does, does not.");
    return html.page();
  }

  private static void result(Html html, Row row) {
    if (row.isGood()) {
      html.text("good");
    }
    for (int i = 0; i < row.problems().size(); i++) {
      html.open("p");
      if (i < row.bad().size()) {
        html.element("a", row.problems().get(i), "href", row.bad().get(i));
      } else {
        html.text(row.problems().get(i));
      }
      html.close();
    }
  }
}
