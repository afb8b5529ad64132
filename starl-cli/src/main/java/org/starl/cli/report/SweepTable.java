package org.starl.cli.report;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.starl.sim.check.RunOutcome.Verdict;
import org.starl.sim.export.CsvTable;

/**
 * The result of a sweep: for each point the number of runs of each verdict, and of each measure of
 * {@link SeedColumns} that is a number the percentiles over the point's runs.
 */
public final class SweepTable {

  /** The percentiles of a measure, over the runs of a point. */
  private static final List<Integer> PERCENTS = List.of(50, 10, 90);

  private static final Pattern AMOUNT =
      Pattern.compile("(-?\\d+(?:\\.\\d+)?(?:[eE]-?\\d+)?)([A-Za-z/%]*)");

  private static final List<String> NO_MEASURES = List.of("seed", "failure_at_s");
  private static final MathContext SHORT = new MathContext(4);

  /**
   * A setting or parameter that the sweep varies.
   *
   * @param unit of all values; empty without, or if a value is no number with that unit
   */
  record Varied(String key, String unit, boolean isNumber) {

    static Varied of(String key, Collection<String> values) {
      SortedSet<String> units = new TreeSet<>();
      boolean isNumber = true;
      for (String value : values) {
        Matcher amount = AMOUNT.matcher(value);
        isNumber &= amount.matches();
        if (isNumber && Double.parseDouble(amount.group(1)) != 0) {
          units.add(amount.group(2)); // a zero needs no unit
        }
      }
      boolean isComparable = isNumber && units.size() <= 1;
      return new Varied(key, isComparable && !units.isEmpty() ? units.first() : "", isComparable);
    }

    /** The key with its unit: {@code arrivals [/min]}. */
    String heading() {
      return unit.isEmpty() ? key : key + " [" + unit + "]";
    }

    /** The value without the unit of all. */
    String cell(String value) {
      Matcher amount = AMOUNT.matcher(value);
      return isNumber && amount.matches() ? amount.group(1) : value;
    }
  }

  /** One point of the sweep. */
  public static final class Point {

    private final List<String> values;
    private final Map<Verdict, Integer> verdicts = new EnumMap<>(Verdict.class);
    private final SortedMap<String, List<Double>> measures = new TreeMap<>();
    private @Nullable SeedRow shown;

    private Point(List<String> values) {
      this.values = List.copyOf(values);
    }

    private void add(SeedRow row) {
      if (shown == null || (shown.outcome().isGood() && !row.outcome().isGood())) {
        shown = row;
      }
      verdicts.merge(row.outcome().verdict(), 1, Integer::sum);
      measuresOf(row)
          .forEach(
              (name, value) -> measures.computeIfAbsent(name, any -> new ArrayList<>()).add(value));
    }

    /** The values of the varied keys, as the user wrote them. */
    List<String> values() {
      return values;
    }

    int count(Verdict verdict) {
      return verdicts.getOrDefault(verdict, 0);
    }

    /** The run to look at: the first bad one, else the first; null before any. */
    @Nullable SeedRow shown() {
      return shown;
    }

    public int runs() {
      return verdicts.values().stream().mapToInt(Integer::intValue).sum();
    }

    /** The measure's values of this point's runs; null if no run has it. */
    @Nullable Distribution measure(String name) {
      List<Double> all = measures.get(name);
      return all == null ? null : Distribution.of(all);
    }
  }

  private final List<Varied> varied;
  private final List<Point> points;

  /**
   * @param keys that vary
   * @param points the values of the keys at each point
   */
  public SweepTable(List<String> keys, List<List<String>> points) {
    List<Varied> found = new ArrayList<>();
    for (int i = 0; i < keys.size(); i++) {
      int index = i;
      found.add(Varied.of(keys.get(i), points.stream().map(point -> point.get(index)).toList()));
    }
    varied = List.copyOf(found);
    this.points = points.stream().map(Point::new).toList();
  }

  List<Varied> varied() {
    return varied;
  }

  /** Adds a run of its point. */
  public void add(SeedRow row) {
    points.get(row.point()).add(row);
  }

  /** The measures of one run, by name. */
  public static SortedMap<String, Double> measuresOf(SeedRow row) {
    SortedMap<String, Double> measures = new TreeMap<>();
    SeedColumns.of(row)
        .forEach((name, value) -> {
          if (value instanceof Number number
              && !NO_MEASURES.contains(name)
              && !name.startsWith("checks_")) {
            measures.put(name, number.doubleValue());
          }
        });
    return measures;
  }

  List<Point> points() {
    return Collections.unmodifiableList(points);
  }

  /** The names of all measures of all runs, in order. */
  public SortedSet<String> measures() {
    SortedSet<String> names = new TreeSet<>();
    points.forEach(point -> names.addAll(point.measures.keySet()));
    return names;
  }

  /** Runs of all points. */
  public int runs() {
    return points.stream().mapToInt(Point::runs).sum();
  }

  /** Bad runs of all points. */
  public int bad() {
    return points.stream().mapToInt(point -> point.runs() - point.count(Verdict.GOOD)).sum();
  }

  /** As text: the median of each of these measures, and the middle 80 % of the runs. */
  public List<String> lines(List<String> shown) {
    List<List<String>> rows = new ArrayList<>();
    List<String> head = new ArrayList<>(varied.stream().map(Varied::heading).toList());
    head.addAll(List.of("runs", "good"));
    head.addAll(shown);
    rows.add(head);
    for (Point point : points) {
      List<String> row = cells(point);
      row.add("" + point.runs());
      row.add("" + point.count(Verdict.GOOD));
      shown.forEach(name -> row.add(spread(point.measure(name))));
      rows.add(row);
    }
    List<String> lines = new ArrayList<>();
    for (List<String> row : rows) {
      StringBuilder line = new StringBuilder();
      for (int i = 0; i < row.size(); i++) {
        int column = i;
        int width = rows.stream().mapToInt(other -> other.get(column).length()).max().orElse(0);
        line.append(i == 0 ? "" : "  ").append(" ".repeat(width - row.get(i).length()));
        line.append(row.get(i));
      }
      lines.add(line.toString());
    }
    return lines;
  }

  List<String> cells(Point point) {
    List<String> cells = new ArrayList<>();
    for (int i = 0; i < varied.size(); i++) {
      cells.add(varied.get(i).cell(point.values.get(i)));
    }
    return cells;
  }

  /** {@code 7.4 (6.1 to 9)}; a hyphen if there is no value. */
  static String spread(@Nullable Distribution values) {
    return values == null
        ? "-"
        : "%s (%s to %s)"
            .formatted(
                number(values.percentile(50)),
                number(values.percentile(10)),
                number(values.percentile(90)));
  }

  private static String number(double value) {
    return exact(BigDecimal.valueOf(value).round(SHORT));
  }

  private static String exact(BigDecimal value) {
    return value.signum() == 0 ? "0" : value.stripTrailingZeros().toPlainString();
  }

  /**
   * As CSV (RFC 4180): a row for each point, with all measures. A cell is empty if no run of the
   * point has the measure.
   */
  public String csv() {
    List<String> names = List.copyOf(measures());
    List<String> head = new ArrayList<>(varied.stream().map(Varied::heading).toList());
    head.add("runs");
    for (Verdict verdict : Verdict.values()) {
      head.add(verdict.name().toLowerCase(Locale.ROOT));
    }
    for (String name : names) {
      PERCENTS.forEach(percent -> head.add(name + " p" + percent));
    }
    StringBuilder text = new StringBuilder(line(head));
    for (Point point : points) {
      List<String> row = cells(point);
      row.add("" + point.runs());
      for (Verdict verdict : Verdict.values()) {
        row.add("" + point.count(verdict));
      }
      for (String name : names) {
        Distribution values = point.measure(name);
        for (int percent : PERCENTS) {
          row.add(values == null ? "" : exact(BigDecimal.valueOf(values.percentile(percent))));
        }
      }
      text.append(line(row));
    }
    return text.toString();
  }

  private static String line(List<String> cells) {
    return String.join(",", cells.stream().map(CsvTable::quoted).toList()) + "\r\n";
  }
}
