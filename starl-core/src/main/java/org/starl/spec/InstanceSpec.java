package org.starl.spec;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.function.LongFunction;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.Var;

/**
 * The specification of a primitive: safety of each instance at every event, and progress within
 * bounds, where bounds are given.
 *
 * @param <R> the state kept for one instance
 */
public abstract class InstanceSpec<R> extends InstanceMonitor<R> {

  protected final FaultState faults = new FaultState();
  private final List<Deadlines> progress = new ArrayList<>();
  private final List<FlagCheck<?>> flags = new ArrayList<>();

  /**
   * @param kinds of its instances, as {@link InstanceMonitor} has them
   */
  protected InstanceSpec(String... kinds) {
    super(kinds);
  }

  /**
   * Adds a lemma of progress. Without a bound it is not among the {@link #lemmas}. For constructors.
   *
   * @param boundNs as {@link Deadlines} has it, or {@link Deadlines#NO_BOUND}
   * @param complaint the violation's text, for a deadline that runs since so many ns
   */
  protected final Deadlines progress(
      String lemma, String sentence, long boundNs, LongFunction<String> complaint) {
    Deadlines deadlines = new Deadlines(lemma, boundNs, complaint);
    if (deadlines.isBounded()) {
      progress(lemma, sentence);
    }
    progress.add(deadlines);
    return deadlines;
  }

  /** Adds a check of a variable that apps read. For constructors. */
  protected final <T> FlagCheck<T> flag(Var<T> variable, String lemma) {
    FlagCheck<T> flag = new FlagCheck<>(variable, lemma);
    flags.add(flag);
    return flag;
  }

  @Override
  public final void observe(TraceEvent event, Report report) {
    finish(event.timeNs(), report);
    flags.forEach(flag -> flag.observe(event, report));
    boolean isReviewed = faults.observe(event);
    if (event instanceof Left || (event instanceof Fault f && f.name().equals(Fault.CRASH))) {
      ended(event.robot());
    }
    if (dispatch(event, report)) {
      isReviewed = true;
    } else {
      happened(event, report);
    }
    if (isReviewed) {
      review(event.timeNs(), report);
    }
  }

  @Override
  public final void finish(long endNs, Report report) {
    progress.forEach(deadlines -> deadlines.expire(endNs, report));
  }

  /** The robot's program has ended: it crashed, or the robot left. */
  protected abstract void ended(RobotId robot);

  /**
   * Updates what is owed, and whether the assumptions of progress hold. Called after each event of an
   * instance, and after each change of the {@link #faults}.
   */
  protected abstract void review(long nowNs, Report report);

  /** Whether more than half of {@code voters} are up. */
  protected final boolean hasMajorityUp(Collection<RobotId> voters) {
    return 2 * voters.stream().filter(faults::isUp).count() > voters.size();
  }
}
