package org.starl.cli.report;

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
      plot.path(
          steps(plot, across, counts, 90, false) + steps(plot, across, counts, 10, true) + "Z",
          "band");
    }
    plot.path(steps(plot, across, counts, 50, false), "curve");
    for (int i = 0; i < STEPS; i += 4) {
      double atS = across.max() * (i + 2) / STEPS;
      plot.tip(
          across.max() * i / STEPS, across.max() * (i + 4) / STEPS, tip(atS, counts.get(i + 2)));
    }
    plot.end();
  }

  private String note() {
    String note =
        runs.size() == 1
            ? "One run."
            : "Line: the median of "
                + NumberFormats.count(runs.size(), "run")
                + ". Band: the middle 80 % of the runs.";
    int left = all.count() - all.upTo(shown);
    return left == 0
        ? note
        : note
            + " Beyond the chart: "
            + NumberFormats.count(left)
            + " of "
            + NumberFormats.count(all.count())
            + ", up to "
            + NumberFormats.measured("s", all.maximum())
            + ".";
  }

  private String tip(double atS, int[] counts) {
    return "at "
        + NumberFormats.measured("s", atS)
        + ": "
        + rank(counts, 50)
        + " in the median run"
        + (runs.size() == 1
            ? ""
            : ", " + rank(counts, 10) + " to " + rank(counts, 90) + " in 80 % of the runs");
  }

  private static String steps(
      Plot plot, Axis across, List<int[]> counts, int percent, boolean isBack) {
    StringBuilder path = new StringBuilder();
    double before = 0;
    for (int i = 0; i <= STEPS; i++) {
      int at = isBack ? STEPS - i : i;
      double x = across.max() * at / STEPS;
      double y = rank(counts.get(at), percent);
      if (i == 0) {
        path.append(isBack ? 'L' : 'M').append(plot.at(x, y));
      } else if (y != before || i == STEPS) {
        double cornerX = isBack ? across.max() * (at + 1) / STEPS : x;
        path.append('L').append(plot.at(cornerX, before)).append('L').append(plot.at(cornerX, y));
        if (i == STEPS) {
          path.append('L').append(plot.at(x, y));
        }
      }
      before = y;
    }
    return path.toString();
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
          html.element("td", NumberFormats.count(rank(counts, percent)));
        }
        html.element("td", NumberFormats.count(all.upTo(tick))).close();
      }
    }
    html.endTable();
  }
}
