package org.starl.spec;

import java.util.List;
import java.util.function.LongFunction;
import java.util.function.Predicate;
import org.starl.id.RobotId;

/**
 * What each robot owes in each instance of a primitive under one lemma: a {@link Within} that
 * reports what was not met. Without a bound, nothing is ever owed.
 */
public final class Deadlines {

  /** No bound: for a specification of safety only. */
  public static final long NO_BOUND = Long.MAX_VALUE;

  private final String lemma;
  private final LongFunction<String> complaint;
  private final Within<ProcessKey> within;

  /**
   * @param boundNs as {@link Within} has it, or {@link #NO_BOUND}
   * @param complaint what is wrong, of a debt since so many ns
   */
  public Deadlines(String lemma, long boundNs, LongFunction<String> complaint) {
    this.lemma = lemma;
    this.complaint = complaint;
    this.within = new Within<>(boundNs);
  }

  /**
   * One robot's part in one instance.
   *
   * @param source the instance, as in the trace
   */
  public record ProcessKey(String source, RobotId robot) {}

  public boolean isBounded() {
    return within.boundNs() != NO_BOUND;
  }

  /** As {@link Within#start}. */
  public void start(ProcessKey seat, long nowNs) {
    if (isBounded()) {
      within.start(seat, nowNs);
    }
  }

  /** As {@link Within#stop}. */
  public boolean stop(ProcessKey seat) {
    return within.stop(seat);
  }

  /** What was owed, if it was, has come: the lemma holds once more. */
  public void meet(ProcessKey seat, Monitor.Report report) {
    if (within.stop(seat)) {
      report.checked(lemma);
    }
  }

  /** As {@link Within#assume}. */
  public void assume(ProcessKey seat, boolean holds, long nowNs) {
    within.assume(seat, holds, nowNs);
  }

  /** As {@link Within#assumeEach}. */
  public void assumeEach(Predicate<ProcessKey> holds, long nowNs) {
    within.assumeEach(holds, nowNs);
  }

  /** Reports every debt whose bound has passed before {@code nowNs}; call as {@link Within#expire}. */
  public void expire(long nowNs, Monitor.Report report) {
    within.expire(
        nowNs,
        (seat, sinceNs, deadlineNs) -> {
          report.checked(lemma);
          report.violated(
              lemma,
              deadlineNs,
              List.of(seat.robot()),
              seat.source() + ": " + complaint.apply(sinceNs));
        });
  }
}
