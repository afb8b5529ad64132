package org.starl.spec;

import java.util.List;
import java.util.function.LongFunction;
import java.util.function.Predicate;
import org.starl.id.RobotId;

/**
 * What each robot owes in each instance of a primitive under one lemma: a {@link Within} that
 * reports missed deadlines. Without a bound, nothing is owed.
 */
public final class Deadlines {

  /** No bound: for a specification of safety only. */
  public static final long NO_BOUND = Long.MAX_VALUE;

  private final String lemma;
  private final LongFunction<String> complaint;
  private final Within<ProcessKey> within;

  /**
   * @param boundNs as {@link Within} has it, or {@link #NO_BOUND}
   * @param complaint what is wrong with a deadline that runs since so many ns
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
  public void start(ProcessKey key, long nowNs) {
    if (isBounded()) {
      within.start(key, nowNs);
    }
  }

  /** As {@link Within#stop}. */
  public boolean stop(ProcessKey key) {
    return within.stop(key);
  }

  /** The deadline, if there is one, is met: the lemma holds once more. */
  public void meet(ProcessKey key, Monitor.Report report) {
    if (within.stop(key)) {
      report.checked(lemma);
    }
  }

  /** As {@link Within#assume}. */
  public void assume(ProcessKey key, boolean holds, long nowNs) {
    within.assume(key, holds, nowNs);
  }

  /** As {@link Within#assumeEach}. */
  public void assumeEach(Predicate<ProcessKey> holds, long nowNs) {
    within.assumeEach(holds, nowNs);
  }

  /** Reports every deadline whose bound has passed before {@code nowNs}; call as {@link Within#expire}. */
  public void expire(long nowNs, Monitor.Report report) {
    within.expire(
        nowNs,
        (key, sinceNs, deadlineNs) -> {
          report.checked(lemma);
          report.violated(
              lemma,
              deadlineNs,
              List.of(key.robot()),
              key.source() + ": " + complaint.apply(sinceNs));
        });
  }
}
