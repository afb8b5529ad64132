package org.starl.sim.check;

import java.util.Collections;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.input.BadInput;
import org.starl.sim.SimResult;
import org.starl.sim.SimulationFailed;
import org.starl.sim.kernel.RobotError;
import org.starl.spec.SpecReport;
import org.starl.time.Time;

/**
 * The outcome of one run of a campaign.
 *
 * @param what identifies the failure: the first violated lemma or the type of the exception; empty
 *     if there is neither
 * @param atNs time of the failure, in ns of virtual time; -1 if unknown
 * @param isOwed whether the failure is missing progress at the end of the run
 * @param detail one line: the first violation, the unfinished robots or the exception; empty if
 *     good
 * @param figures finite numbers for statistics, by name
 * @param checks how often each lemma was checked that its monitor does not declare inapplicable
 */
public record RunOutcome(
    Verdict verdict,
    String what,
    long atNs,
    boolean isOwed,
    String detail,
    SortedMap<String, Double> figures,
    SortedMap<String, Long> checks) {

  private static final long UNKNOWN = -1;

  /** The verdict of a run, from good to bad. */
  public enum Verdict {
    /** Every specification held, and every app ended. */
    GOOD,
    /** Every specification held, but some app did not end. */
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
    checks = Collections.unmodifiableSortedMap(new TreeMap<>(checks));
  }

  /** An outcome of a run without specifications. */
  public RunOutcome(
      Verdict verdict, String what, long atNs, String detail, SortedMap<String, Double> figures) {
    this(verdict, what, atNs, verdict == Verdict.UNFINISHED, detail, figures, new TreeMap<>());
  }

  public static RunOutcome good(SortedMap<String, Double> figures) {
    return new RunOutcome(Verdict.GOOD, "", UNKNOWN, "", figures);
  }

  /** A run that violated a specification. */
  public static RunOutcome violated(SpecReport.Violation first, SortedMap<String, Double> figures) {
    return new RunOutcome(
        Verdict.VIOLATED, first.lemma(), first.timeNs(), first.toString(), figures);
  }

  /**
   * The outcome of a run that ended without an exception. Its figures are {@code
   * end_s}, {@code kernel_events}, {@code datagrams_sent}, {@code datagrams_lost}, {@code
   * robots_collided} and {@code walls_hit}.
   */
  public static RunOutcome of(SimResult result) {
    SortedMap<String, Double> figures = new TreeMap<>();
    figures.put("end_s", Time.seconds(result.endNs()));
    figures.put("kernel_events", (double) result.events());
    figures.put("datagrams_sent", (double) result.network().sent());
    figures.put("datagrams_lost", (double) result.network().lost());
    figures.put("robots_collided", (double) result.collisions().ofRobots());
    figures.put("walls_hit", (double) result.collisions().withWalls());
    SortedMap<String, Long> checks = new TreeMap<>();
    for (String lemma : result.spec().lemmas()) {
      if (result.spec().inapplicable(lemma).isEmpty()) {
        checks.put(lemma, result.spec().checks(lemma));
      }
    }
    RunOutcome outcome = of(result, figures);
    // A monitor judges at the end what should have happened before.
    boolean isOwed = outcome.isOwed || outcome.atNs == result.endNs();
    return new RunOutcome(
        outcome.verdict, outcome.what, outcome.atNs, isOwed, outcome.detail, figures, checks);
  }

  private static RunOutcome of(SimResult result, SortedMap<String, Double> figures) {
    if (!result.spec().holds()) {
      return violated(result.spec().violations().get(0), figures);
    }
    if (!result.isFinished()) {
      String cause = result.diagnosis().cause();
      String detail =
          "not finished: " + result.unfinished() + (cause.isEmpty() ? "" : "; " + cause);
      return new RunOutcome(Verdict.UNFINISHED, "", UNKNOWN, detail, figures);
    }
    return good(figures);
  }

  /** A run that an exception ended. */
  public static RunOutcome failed(RuntimeException error) {
    Throwable cause =
        error instanceof SimulationFailed && error.getCause() != null ? error.getCause() : error;
    long atNs = UNKNOWN;
    if (cause instanceof RobotError robotError) {
      atNs = robotError.timeNs();
      cause = robotError.getCause() == null ? robotError : robotError.getCause();
    }
    String message = error.getMessage();
    String detail = message == null ? error.getClass().getSimpleName() : firstLine(message);
    return new RunOutcome(
        Verdict.FAILED, cause.getClass().getName(), atNs, detail, new TreeMap<>());
  }

  /** A copy with other figures. */
  public RunOutcome withFigures(SortedMap<String, Double> newFigures) {
    return new RunOutcome(verdict, what, atNs, isOwed, detail, newFigures, checks);
  }

  public boolean isGood() {
    return verdict == Verdict.GOOD;
  }

  /** Whether the request of the run was wrong, as with a fault of a robot that is not there. */
  public boolean isBadInput() {
    return what.equals(BadInput.class.getName());
  }

  /**
   * Whether the other run failed in the same way: same violated lemma, or same type of exception.
   */
  public boolean isLike(RunOutcome other) {
    return verdict == other.verdict && what.equals(other.what);
  }

  private static String firstLine(String text) {
    int end = text.indexOf('\n');
    return end < 0 ? text : text.substring(0, end);
  }
}
