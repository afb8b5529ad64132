package org.starl.cli.report;

import static org.starl.cli.report.NumberFormats.count;
import static org.starl.cli.report.NumberFormats.measured;
import static org.starl.cli.report.NumberFormats.number;
import static org.starl.cli.report.NumberFormats.percent;

import java.util.ArrayList;
import java.util.List;

/** The distribution of values: a histogram, the cumulative share and percentiles. */
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
  private final Distribution values;
  private final double shown;

  /**
   * @param name of the values, in the plural
   * @param values not empty
   */
  SizeCharts(Html html, String name, String unit, Distribution values) {
    this.html = html;
    this.name = name;
    this.unit = unit;
    this.values = values;
    shown = values.chartLimit();
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
            "Distribution",
            "Each bar is " + number(unit, bins.get(0).to()) + " wide." + leftOut(),
            across,
            Axis.upTo("count", most, Y_STEPS, true));
    for (Bin bin : bins) {
      if (bin.count() > 0) {
        plot.bar(bin.from(), bin.to(), bin.count());
      }
    }
    for (Bin bin : bins) {
      String share = count(bin.count()) + " (" + percent(bin.count(), values.count()) + ")";
      String range = number(bin.from()) + " to " + number(unit, bin.to());
      plot.tip(bin.from(), bin.to(), range + ": " + share);
    }
    plot.end();
  }

  /** Bins of one round width: half the Freedman-Diaconis rule, with 8 to 30 bins. */
  private List<Bin> bins() {
    double quartiles = values.percentile(75) - values.percentile(25);
    double width = quartiles / StrictMath.cbrt(values.count());
    double least = Axis.nice(Math.max(shown, Double.MIN_NORMAL) / MOST_BINS);
    double greatest = Axis.nice(Math.max(shown, Double.MIN_NORMAL) / FEWEST_BINS);
    width = shown == 0 ? 1 : Math.min(greatest, Math.max(least, width > 0 ? Axis.nice(width) : 0));
    List<Bin> bins = new ArrayList<>();
    for (int i = 0; i == 0 || i * width <= shown; i++) {
      double to = (i + 1) * width;
      bins.add(new Bin(i * width, to, values.below(to) - values.below(i * width)));
    }
    return bins;
  }

  private void shares() {
    Plot plot =
        new Plot(
            html,
            "Cumulative share",
            count(values.count(), "value") + "." + leftOut(),
            Axis.upTo(axisLabel(), shown, X_STEPS, false),
            Axis.upTo("% of all", 100, 5, true));
    plot.path(curve(plot), "curve");
    for (int percent : new int[] {50, 95}) {
      double value = values.percentile(percent);
      if (value <= shown) {
        String text = percent == 50 ? "median " : percent + " % up to ";
        plot.mark(value, percent, text + measured(unit, value));
      }
    }
    for (int i = 0; i < 50; i++) {
      double from = shown * i / 50;
      double to = shown * (i + 1) / 50;
      String share = percent(values.upTo(to), values.count());
      plot.tip(from, to, share + " up to " + measured(unit, to));
    }
    plot.end();
  }

  private String curve(Plot plot) {
    StringBuilder path = new StringBuilder("M" + plot.at(0, 0));
    int drawn = values.upTo(shown);
    int step = Math.max(1, drawn / CURVE_POINTS);
    double share = 0;
    for (int i = step; i <= drawn + step - 1; i += step) {
      int rank = Math.min(i, drawn);
      double value = values.percentile(100.0 * (rank - 0.5) / values.count());
      path.append('L').append(plot.at(value, share));
      share = 100.0 * rank / values.count();
      path.append('L').append(plot.at(value, share));
    }
    return path.append('L').append(plot.at(shown, share)).toString();
  }

  private String axisLabel() {
    return unit.equals("s") ? "seconds" : unit.isEmpty() ? name : unit;
  }

  private String leftOut() {
    int left = values.count() - values.upTo(shown);
    return left == 0
        ? ""
        : " Left out: %s of %s, above %s."
            .formatted(count(left), count(values.count()), measured(unit, shown));
  }

  private void table() {
    List<String> headings = new ArrayList<>(List.of("count", "minimum"));
    for (double percent : PERCENTILES) {
      headings.add(percent == 50 ? "median" : number(percent) + "\u00A0%");
    }
    headings.addAll(List.of("maximum", "mean"));
    String caption = NumberFormats.capitalized(name) + (unit.isEmpty() ? "" : ", in " + unit);
    html.table("numbers", caption, headings).open("tr");
    html.element("td", count(values.count()));
    html.element("td", measured(values.minimum()));
    for (double percent : PERCENTILES) {
      html.element("td", measured(values.percentile(percent)));
    }
    html.element("td", measured(values.maximum()));
    html.element("td", measured(values.mean())).close().endTable();
  }
}
