package org.starl.spec;

import java.util.List;
import java.util.function.LongFunction;
import org.starl.id.RobotId;

/**
 * Progress deadlines per robot and instance of a primitive, under one lemma: a {@link Within} that
 * reports missed deadlines as violations. Without a bound, there are no deadlines.
 */
public final class Dues {

  /** No bound: only safety is checked. */
  public static final long NO_BOUND = Long.MAX_VALUE;

  private final String lemma;
  private final LongFunction<String> complaint;
  private final Within<Seat> within;

  /**
   * @param boundNs as in {@link Within}, or {@link #NO_BOUND}
   * @param complaint text of a violation, given the start of the deadline in ns
   */
  public Dues(String lemma, long boundNs, LongFunction<String> complaint) {
    this.lemma = lemma;
    this.complaint = complaint;
    this.within = new Within<>(boundNs);
  }

  /**
   * The key of a deadline: one robot in one instance.
   *
   * @param source the instance, as in the trace
   */
  public record Seat(String source, RobotId robot) {}

  public boolean isBounded() {
    return within.boundNs() != NO_BOUND;
  }

  /** As {@link Within#owe}. */
  public void owe(Seat seat, long nowNs) {
    if (isBounded()) {
      within.owe(seat, nowNs);
    }
  }

  /** As {@link Within#settle}. */
  public boolean settle(Seat seat) {
    return within.settle(seat);
  }

  /** Ends a deadline, if there is one, as met: the lemma has held once more. */
  public void meet(Seat seat, Monitor.Report report) {
    if (within.settle(seat)) {
      report.checked(lemma);
    }
  }

  /** As {@link Within#assume}. */
  public void assume(Seat seat, boolean holds, long nowNs) {
    within.assume(seat, holds, nowNs);
  }

  /**
   * Reports every deadline that passed before {@code nowNs} as a violation; see {@link
   * Within#expire} for when to call it.
   */
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
