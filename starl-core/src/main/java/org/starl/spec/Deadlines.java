package org.starl.spec;

import java.util.List;
import java.util.function.LongFunction;
import org.starl.id.RobotId;
import org.starl.trace.Instance;

/**
 * The deadlines of one lemma, for each robot in each instance of a primitive: a {@link Within} that
 * reports missed deadlines. Without a bound, nothing is owed.
 */
public final class Deadlines extends Within<Deadlines.ProcessKey> {

  /** No bound: for a specification of safety only. */
  public static final long NO_BOUND = Long.MAX_VALUE;

  private final String lemma;
  private final LongFunction<String> complaint;

  /**
   * @param boundNs as {@link Within} has it, or {@link #NO_BOUND}
   * @param complaint what is wrong with a deadline that runs since so many ns
   */
  public Deadlines(String lemma, long boundNs, LongFunction<String> complaint) {
    super(boundNs);
    this.lemma = lemma;
    this.complaint = complaint;
  }

  /**
   * One robot's part in one instance.
   *
   * @param source the instance, as in the trace
   */
  public record ProcessKey(Instance source, RobotId robot) {}

  public boolean isBounded() {
    return boundNs() != NO_BOUND;
  }

  @Override
  public void start(ProcessKey key, long nowNs) {
    if (isBounded()) {
      super.start(key, nowNs);
    }
  }

  /** The deadline, if there is one, is met: the lemma holds once more. */
  public void meet(ProcessKey key, Monitor.Report report) {
    if (stop(key)) {
      report.checked(lemma);
    }
  }

  /** Reports every deadline whose bound has passed before {@code nowNs}; call as {@link Within#expire}. */
  public void expire(long nowNs, Monitor.Report report) {
    expire(
        nowNs,
        (key, sinceNs, deadlineNs) -> {
          report.checked(lemma);
          report.overdue(
              lemma,
              deadlineNs,
              List.of(key.robot()),
              key.source() + ": " + complaint.apply(sinceNs));
        });
  }
}
