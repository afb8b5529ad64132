package org.starl.sim.check;

import java.util.Collections;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.sim.SimResult;

/**
 * What came of one run of a campaign.
 *
 * @param detail one line: the first violation, who did not finish, what was thrown; empty if good
 * @param figures finite numbers to make statistics of, by name
 */
public record RunOutcome(Verdict verdict, String detail, SortedMap<String, Double> figures) {

  private static final double NS_PER_S = 1e9;

  /** How a run went, from good to bad. */
  public enum Verdict {
    /** Every specification held, and every app came to its end. */
    GOOD,
    /** Every specification held, but some app did not come to its end. */
    UNFINISHED,
    /** A specification was violated. */
    VIOLATED,
    /** An exception ended the run. */
    FAILED
  }

  public RunOutcome {
    for (Map.Entry<String, Double> figure : figures.entrySet()) {
      if (!Double.isFinite(figure.getValue())) {
        throw new IllegalArgumentException(
            "figure " + figure.getKey() + " of a run: " + figure.getValue());
      }
    }
    figures = Collections.unmodifiableSortedMap(new TreeMap<>(figures));
  }

  public static RunOutcome good(SortedMap<String, Double> figures) {
    return new RunOutcome(Verdict.GOOD, "", figures);
  }

  /**
   * What a run says of itself: the first violation, or who did not finish. Its figures are {@code
   * end_s}, {@code kernel_events}, {@code datagrams_sent} and {@code datagrams_lost}.
   */
  public static RunOutcome of(SimResult result) {
    SortedMap<String, Double> figures = new TreeMap<>();
    figures.put("end_s", result.endNs() / NS_PER_S);
    figures.put("kernel_events", (double) result.events());
    figures.put("datagrams_sent", (double) result.network().sent());
    figures.put("datagrams_lost", (double) result.network().lost());
    if (!result.spec().holds()) {
      String first = result.spec().violations().get(0).toString();
      return new RunOutcome(Verdict.VIOLATED, first, figures);
    }
    if (!result.isFinished()) {
      String who = "not finished: " + result.unfinished();
      return new RunOutcome(Verdict.UNFINISHED, who, figures);
    }
    return good(figures);
  }

  /** A run that an exception ended. */
  public static RunOutcome failed(RuntimeException error) {
    String message = error.getMessage();
    String detail = message == null ? error.getClass().getSimpleName() : firstLine(message);
    return new RunOutcome(Verdict.FAILED, detail, new TreeMap<>());
  }

  public boolean isGood() {
    return verdict == Verdict.GOOD;
  }

  private static String firstLine(String text) {
    int end = text.indexOf('\n');
    return end < 0 ? text : text.substring(0, end);
  }
}
