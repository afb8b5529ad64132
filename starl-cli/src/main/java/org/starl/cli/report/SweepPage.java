package org.starl.cli.report;

import static org.starl.cli.report.NumberFormats.count;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.starl.cli.report.SweepTable.Point;
import org.starl.cli.report.SweepTable.Varied;
import org.starl.sim.check.RunOutcome.Verdict;

/** The page of a sweep: for each measure a chart against each varied key, and a table of all points. */
public final class SweepPage {

  private static final int X_STEPS = 6;
  private static final int Y_STEPS = 5;

  /** More lines than this cannot be told apart by their colours: the chart then has one line. */
  private static final int MOST_LINES = 6;

  private final Html html = new Html();
  private final String app;
  private final Map<String, String> description;
  private final SweepTable table;
  private final List<String> shown;
  private final Function<SeedRow, String> replay;

  /**
   * @param description what was run, for the head of the page, by headings
   * @param shown the measures to show
   * @param replay the command that repeats a run
   */
  public SweepPage(
      String app,
      Map<String, String> description,
      SweepTable table,
      List<String> shown,
      Function<SeedRow, String> replay) {
    this.replay = replay;
    this.app = app;
    this.description = new LinkedHashMap<>(description);
    this.table = table;
    this.shown = List.copyOf(shown);
  }

  /** The HTML of the page. Call it once. */
  public String write() {
    html.open("html", "lang", "en");
    Page.head(html, app + ": sweep");
    html.open("body").open("header").element("h1", app + ": sweep");
    Page.verdict(html, Page.verdict(table.runs(), this::runsThatEnded), table.bad() == 0);
    html.open("dl", "class", "ran");
    description.forEach((name, text) -> {
      html.element("dt", name);
      if (name.equals("Command")) {
        html.open("dd").command(text).close();
      } else {
        html.element("dd", text);
      }
    });
    html.close().close().contents().open("main");
    for (String measure : shown) {
      html.section(measure).open("div", "class", "charts");
      for (int i = 0; i < table.varied().size(); i++) {
        chart(measure, i);
      }
      html.close().close();
    }
    points();
    html.close();
    Page.footer(html);
    return html.page();
  }

  private long runsThatEnded(Verdict verdict) {
    return table.points().stream().mapToInt(point -> point.count(verdict)).sum();
  }

  /** The points of one line: those whose other keys have the same values. */
  private record Line(String name, List<Point> points) {}

  private void chart(String measure, int key) {
    Varied across = table.varied().get(key);
    List<Line> lines = lines(key);
    List<String> labels = labels(key);
    double farthest = 0;
    double highest = 0;
    for (Line line : lines) {
      for (Spread spread : spreads(line, measure, key, labels)) {
        farthest = Math.max(farthest, spread.x);
        highest = Math.max(highest, spread.high);
      }
    }
    Plot plot =
        new Plot(
            html,
            measure + " against " + across.key(),
            note(across, labels, lines.size()),
            Axis.upTo(across.heading(), farthest, X_STEPS, !across.isNumber()),
            Axis.upTo(unit(measure), highest, Y_STEPS, false));
    for (int i = 0; i < lines.size(); i++) {
      draw(plot, spreads(lines.get(i), measure, key, labels), "line" + i);
    }
    plot.endSvg();
    if (lines.size() > 1) {
      html.open("p", "class", "note");
      for (int i = 0; i < lines.size(); i++) {
        html.element("span", "\u25A0", "class", "line" + i, "aria-hidden", "true");
        html.text(" " + lines.get(i).name + "  ");
      }
      html.close();
    }
    html.close();
  }

  /** The middle 80 % of the runs at one place of the horizontal axis. */
  private record Spread(double x, double low, double median, double high) {}

  private List<Spread> spreads(Line line, String measure, int key, List<String> labels) {
    Varied across = table.varied().get(key);
    Map<Double, List<Double>> byX = new LinkedHashMap<>();
    for (Point point : line.points) {
      Distribution values = point.measure(measure);
      if (values != null) {
        String value = point.values().get(key);
        double x =
            across.isNumber()
                ? Double.parseDouble(across.cell(value))
                : labels.indexOf(value) + 1.0;
        byX.computeIfAbsent(x, any -> new ArrayList<>()).addAll(values.all());
      }
    }
    List<Spread> spreads = new ArrayList<>();
    byX.forEach((x, all) -> {
      Distribution values = Distribution.of(all);
      spreads.add(
          new Spread(x, values.percentile(10), values.percentile(50), values.percentile(90)));
    });
    spreads.sort(Comparator.comparingDouble(Spread::x));
    return spreads;
  }

  private static void draw(Plot plot, List<Spread> spreads, String cssClass) {
    List<String> top = new ArrayList<>();
    List<String> middle = new ArrayList<>();
    List<String> bottom = new ArrayList<>();
    for (Spread spread : spreads) {
      top.add(plot.at(spread.x, spread.high));
      middle.add(plot.at(spread.x, spread.median));
      bottom.add(plot.at(spread.x, spread.low));
    }
    if (spreads.size() > 1) {
      List<String> band = new ArrayList<>(top);
      band.addAll(bottom.reversed());
      plot.path("M" + String.join("L", band) + "Z", "spread " + cssClass);
      plot.path("M" + String.join("L", middle), "curve " + cssClass);
    }
    for (Spread spread : spreads) {
      plot.dot(
          spread.x,
          spread.median,
          cssClass,
          "%s: %s (%s to %s)"
              .formatted(
                  NumberFormats.number(spread.x),
                  NumberFormats.number(spread.median),
                  NumberFormats.number(spread.low),
                  NumberFormats.number(spread.high)));
    }
  }

  private List<Line> lines(int key) {
    Map<String, List<Point>> byOthers = new LinkedHashMap<>();
    for (Point point : table.points()) {
      List<String> others = new ArrayList<>();
      for (int i = 0; i < table.varied().size(); i++) {
        if (i != key) {
          others.add(table.varied().get(i).key() + " " + point.values().get(i));
        }
      }
      byOthers.computeIfAbsent(String.join(", ", others), any -> new ArrayList<>()).add(point);
    }
    if (byOthers.size() > MOST_LINES) {
      return List.of(new Line("", table.points()));
    }
    List<Line> lines = new ArrayList<>();
    byOthers.forEach((name, points) -> lines.add(new Line(name, points)));
    return lines;
  }

  private List<String> labels(int key) {
    return table.points().stream().map(point -> point.values().get(key)).distinct().toList();
  }

  private String note(Varied across, List<String> labels, int lines) {
    List<String> parts = new ArrayList<>();
    parts.add("Line: the median run. Band: the middle 80 % of the runs.");
    if (table.varied().size() > 1 && lines == 1) {
      parts.add("Over all values of the other keys.");
    }
    if (!across.isNumber()) {
      for (int i = 0; i < labels.size(); i++) {
        parts.add((i + 1) + ": " + labels.get(i) + ".");
      }
    }
    return String.join(" ", parts);
  }

  /** What the end of a measure's name tells. */
  private static String unit(String measure) {
    if (measure.endsWith("_per_min")) {
      return "1/min";
    }
    return measure.endsWith("_s") ? "seconds" : "count";
  }

  private void points() {
    List<String> headings = new ArrayList<>();
    table.varied().forEach(varied -> headings.add(varied.heading()));
    headings.addAll(List.of("runs", "good"));
    headings.addAll(shown);
    headings.add("replay: the first bad run, else the first");
    html.section("Points");
    html.table("numbers", "Median of the runs, and the middle 80 %", headings);
    for (Point point : table.points()) {
      html.open("tr");
      table.cells(point).forEach(cell -> html.element("td", cell));
      html.element("td", count(point.runs())).element("td", count(point.count(Verdict.GOOD)));
      shown.forEach(name -> html.element("td", SweepTable.spread(point.measure(name))));
      SeedRow run = point.shown();
      html.open("td", "class", "replay");
      if (run != null) {
        html.command(replay.apply(run));
      }
      html.close().close();
    }
    html.endTable().close();
  }
}
