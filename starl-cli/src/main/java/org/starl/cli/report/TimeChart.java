package org.starl.cli.report;

import static org.starl.cli.report.NumberFormats.count;
import static org.starl.cli.report.NumberFormats.measured;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.starl.sim.check.Percentile;

/** The number of events so far over time: the median run, and the middle 80 % of the runs. */
final class TimeChart {

  private static final int STEPS = 160;
  private static final int X_STEPS = 6;
  private static final int Y_STEPS = 5;

  private final Html html;
  private final String name;
  private final List<Distribution> runs;
  private final Distribution all;
  private final double shown;

  /**
   * @param name of the events, in the plural
   * @param times of each run; at least one run has one
   */
  TimeChart(Html html, String name, List<List<Double>> times) {
    this.html = html;
    this.name = name;
    runs = times.stream().map(Distribution::of).toList();
    all = Distribution.ofAll(times);
    shown = all.chartLimit();
  }

  /** The number of events until {@code atS} in each run, ascending. */
  private int[] counts(double atS) {
    int[] counts = runs.stream().mapToInt(run -> run.upTo(atS)).toArray();
    Arrays.sort(counts);
    return counts;
  }

  private static int rank(int[] sorted, int percent) {
    return sorted[Percentile.index(sorted.length, percent)];
  }

  void write() {
    html.open("div", "class", "charts");
    chart();
    table();
    html.close();
  }

  private void chart() {
    Axis across = Axis.upTo("simulated seconds", shown, X_STEPS, false);
    List<int[]> counts = new ArrayList<>();
    for (int i = 0; i <= STEPS; i++) {
      counts.add(counts(across.max() * i / STEPS));
    }
    double most = rank(counts.get(STEPS), 90);
    Plot plot =
        new Plot(
            html,
            "Count over time",
            note(),
            across,
            Axis.upTo("count in a run", Math.max(1, most), Y_STEPS, true));
    if (runs.size() > 1) {
      List<String> band = steps(plot, across, counts, 90);
      band.addAll(steps(plot, across, counts, 10).reversed());
      plot.path(path(band) + "Z", "band");
    }
    plot.path(path(steps(plot, across, counts, 50)), "curve");
    for (int i = 0; i < STEPS; i += 4) {
      double atS = across.max() * (i + 2) / STEPS;
      plot.tip(
          across.max() * i / STEPS, across.max() * (i + 4) / STEPS, tip(atS, counts.get(i + 2)));
    }
    plot.end();
  }

  private String note() {
    if (runs.size() == 1) {
      return "One run." + leftOut();
    }
    return "Line: the median of %s. Band: the middle 80 %% of the runs."
            .formatted(count(runs.size(), "run"))
        + leftOut();
  }

  private String leftOut() {
    int left = all.count() - all.upTo(shown);
    return left == 0
        ? ""
        : " Beyond the chart: %s of %s, up to %s."
            .formatted(count(left), count(all.count()), measured("s", all.maximum()));
  }

  private String tip(double atS, int[] counts) {
    String median = "at %s: %s in the median run".formatted(measured("s", atS), rank(counts, 50));
    String most = ", %s to %s in 80 %% of the runs".formatted(rank(counts, 10), rank(counts, 90));
    return runs.size() == 1 ? median : median + most;
  }

  /** The corners of the curve of a percentile. */
  private static List<String> steps(Plot plot, Axis across, List<int[]> counts, int percent) {
    List<String> corners = new ArrayList<>();
    int before = rank(counts.get(0), percent);
    corners.add(plot.at(0, before));
    for (int i = 1; i <= STEPS; i++) {
      double x = across.max() * i / STEPS;
      int now = rank(counts.get(i), percent);
      if (now != before) {
        corners.add(plot.at(x, before));
        corners.add(plot.at(x, now));
        before = now;
      }
    }
    corners.add(plot.at(across.max(), before));
    return corners;
  }

  private static String path(List<String> corners) {
    return "M" + String.join("L", corners);
  }

  private void table() {
    Axis across = Axis.upTo("", shown, X_STEPS, false);
    html.table(
        "numbers",
        NumberFormats.capitalized(name) + " so far in a run",
        List.of("until", "10 % of runs", "median", "90 % of runs", "all runs"));
    for (double tick : across.ticks()) {
      if (tick > 0) {
        int[] counts = counts(tick);
        html.open("tr").element("td", across.text(tick) + "\u00A0s");
        for (int percent : new int[] {10, 50, 90}) {
          html.element("td", count(rank(counts, percent)));
        }
        html.element("td", count(all.upTo(tick))).close();
      }
    }
    html.endTable();
  }
}
