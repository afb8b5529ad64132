package org.starl.spec;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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
  // When each wait began, whether its deadline is suspended or not; only if there is a least time.
  private final Map<ProcessKey, Long> beganNs = new LinkedHashMap<>();
  private long leastNs;

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

  /** Requires that no wait is given up sooner than this after its start, by a clock that runs right. */
  public void setLeast(long ns) {
    leastNs = ns;
  }

  public boolean isBounded() {
    return boundNs() != NO_BOUND;
  }

  @Override
  public void start(ProcessKey key, long nowNs) {
    if (leastNs > 0) {
      beganNs.putIfAbsent(key, nowNs);
    }
    if (isBounded()) {
      super.start(key, nowNs);
    }
  }

  @Override
  public boolean stop(ProcessKey key) {
    if (!beganNs.isEmpty()) { // asked often
      beganNs.remove(key);
    }
    return super.stop(key);
  }

  /** When the wait began; long ago, if there is none or no least time. */
  public long beganNs(ProcessKey key) {
    return beganNs.getOrDefault(key, Long.MIN_VALUE / 2);
  }

  /** The robot has given up, as at its deadline; violates the lemma if that is too early. */
  public void giveUp(ProcessKey key, long nowNs, FaultState faults, Monitor.Report report) {
    Long since = beganNs.get(key);
    if (stop(key) || since != null) {
      report.checked(lemma);
    }
    if (since != null && nowNs - since < leastNs && faults.isClockRight(key.robot(), since)) {
      String detail = key.source() + ": gives up after " + (nowNs - since) + " ns";
      report.violated(lemma, nowNs, List.of(key.robot()), detail);
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
