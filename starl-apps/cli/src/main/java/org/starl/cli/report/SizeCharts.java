package org.starl.cli.report;

import java.util.ArrayList;
import java.util.List;

/** How values are spread: a histogram, the share below each value, and percentiles. */
final class SizeCharts {

  private static final int FEWEST_BINS = 8;
  private static final int MOST_BINS = 30;
  private static final int X_STEPS = 6;
  private static final int Y_STEPS = 4;
  private static final int CURVE_POINTS = 200;
  private static final double[] PERCENTILES = {5, 25, 50, 75, 90, 95, 99};

  private final Html html;
  private final String name;
  private final String unit;
  private final Spread spread;
  private final double shown;

  /**
   * @param name what the values are
   * @param spread not empty
   */
  SizeCharts(Html html, String name, String unit, Spread spread) {
    this.html = html;
    this.name = name;
    this.unit = unit;
    this.spread = spread;
    shown = spread.shownUpTo();
  }

  void write() {
    html.open("div", "class", "charts");
    histogram();
    shares();
    html.close();
    table();
  }

  private record Bin(double from, double to, int count) {}

  private void histogram() {
    List<Bin> bins = bins();
    int most = bins.stream().mapToInt(Bin::count).max().orElse(0);
    double end = bins.get(bins.size() - 1).to();
    Axis across = Axis.upTo(axisLabel(), end, X_STEPS, false);
    Plot plot =
        new Plot(
            html,
            "How they are spread",
            "Each bar is " + Say.with(unit, bins.get(0).to()) + " wide." + stragglers(),
            across,
            Axis.upTo("how many", most, Y_STEPS, true));
    for (Bin bin : bins) {
      if (bin.count() > 0) {
        plot.bar(bin.from(), bin.to(), bin.count());
      }
    }
    for (Bin bin : bins) {
      plot.tip(
          bin.from(),
          bin.to(),
          Say.number(bin.from())
              + " to "
              + Say.with(unit, bin.to())
              + ": "
              + Say.count(bin.count())
              + " ("
              + Say.percent(bin.count(), spread.count())
              + ")");
    }
    plot.end();
  }

  /** Of equal, round widths, by half the rule of Freedman and Diaconis, within reason. */
  private List<Bin> bins() {
    double quartiles = spread.percentile(75) - spread.percentile(25);
    double width = quartiles / StrictMath.cbrt(spread.count());
    double least = Axis.nice(Math.max(shown, Double.MIN_NORMAL) / MOST_BINS);
    double greatest = Axis.nice(Math.max(shown, Double.MIN_NORMAL) / FEWEST_BINS);
    width = shown == 0 ? 1 : Math.min(greatest, Math.max(least, width > 0 ? Axis.nice(width) : 0));
    List<Bin> bins = new ArrayList<>();
    for (int i = 0; i == 0 || i * width <= shown; i++) {
      double to = (i + 1) * width;
      bins.add(new Bin(i * width, to, spread.below(to) - spread.below(i * width)));
    }
    return bins;
  }

  private void shares() {
    Plot plot =
        new Plot(
            html,
            "Share at or below each value",
            "Of " + Say.count(spread.count()) + " in all." + stragglers(),
            Axis.upTo(axisLabel(), shown, X_STEPS, false),
            Axis.upTo("% of all", 100, 5, true));
    plot.path(curve(plot), "curve");
    for (int percent : new int[] {50, 95}) {
      double value = spread.percentile(percent);
      if (value <= shown) {
        String what = percent == 50 ? "half up to " : percent + " % up to ";
        plot.mark(value, percent, what + Say.measured(unit, value));
      }
    }
    for (int i = 0; i < 50; i++) {
      double from = shown * i / 50;
      double to = shown * (i + 1) / 50;
      String share = Say.percent(spread.upTo(to), spread.count());
      plot.tip(from, to, share + " up to " + Say.measured(unit, to));
    }
    plot.end();
  }

  private String curve(Plot plot) {
    StringBuilder path = new StringBuilder("M" + plot.at(0, 0));
    int drawn = spread.upTo(shown);
    int step = Math.max(1, drawn / CURVE_POINTS);
    double share = 0;
    for (int i = step; i <= drawn + step - 1; i += step) {
      int rank = Math.min(i, drawn);
      double value = spread.percentile(100.0 * (rank - 0.5) / spread.count());
      path.append('L').append(plot.at(value, share));
      share = 100.0 * rank / spread.count();
      path.append('L').append(plot.at(value, share));
    }
    return path.append('L').append(plot.at(shown, share)).toString();
  }

  private String axisLabel() {
    return unit.equals("s") ? "seconds" : unit.isEmpty() ? name : unit;
  }

  private String stragglers() {
    int left = spread.count() - spread.upTo(shown);
    return left == 0
        ? ""
        : " Left out: "
            + Say.count(left)
            + " of "
            + Say.count(spread.count())
            + ", above "
            + Say.measured(unit, shown)
            + ".";
  }

  private void table() {
    html.open("div", "class", "wide").open("table", "class", "numbers");
    html.element("caption", Say.upper(name) + (unit.isEmpty() ? "" : ", in " + unit));
    html.open("thead").open("tr");
    html.element("th", "how many", "scope", "col").element("th", "least", "scope", "col");
    for (double percent : PERCENTILES) {
      String head = percent == 50 ? "median" : Say.number(percent) + "\u00A0%";
      html.element("th", head, "scope", "col");
    }
    html.element("th", "most", "scope", "col").element("th", "mean", "scope", "col");
    html.close().close().open("tbody").open("tr");
    html.element("td", Say.count(spread.count())).element("td", Say.measured(spread.least()));
    for (double percent : PERCENTILES) {
      html.element("td", Say.measured(spread.percentile(percent)));
    }
    html.element("td", Say.measured(spread.most())).element("td", Say.measured(spread.mean()));
    html.close().close().close().close();
  }
}
