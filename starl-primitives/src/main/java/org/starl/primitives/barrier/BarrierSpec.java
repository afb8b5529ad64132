package org.starl.primitives.barrier;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodSpec;
import org.starl.spec.Deadlines;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.FaultState;
import org.starl.spec.InstanceSpec;
import org.starl.spec.Monitor;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * The specification of barriers, after the package's contract: {@code NoEarly}, {@code Uniform}, and,
 * where bounds are given, {@code NotHung}.
 */
public final class BarrierSpec extends InstanceSpec<BarrierRecord> {

  static final String NO_EARLY = "barrier.NoEarly";
  static final String UNIFORM = "barrier.Uniform";
  static final String NOT_HUNG = "barrier.NotHung";

  private static final String NOT_HUNG_SAYS =
      "A robot that waits at a barrier is told an outcome within the bound.";

  private final Deadlines released;
  private final Deadlines prompt;
  private final Deadlines told;

  /** Safety only. */
  public BarrierSpec() {
    this(Deadlines.NO_BOUND, Deadlines.NO_BOUND);
  }

  /** As {@link #BarrierSpec(long, long, long)}, with no other bound in a calm world. */
  public BarrierSpec(long releasedWithinNs, long toldWithinNs) {
    this(releasedWithinNs, toldWithinNs, Deadlines.NO_BOUND);
  }

  /**
   * Safety, and progress within bounds.
   *
   * @param releasedWithinNs a waiting robot is told within this time of the last arrival of a live
   *     member, or of the crash after which no live member is absent, in ns; while a majority of the
   *     members' robots is up and no fault but crashes is active
   * @param toldWithinNs a waiting robot is told an outcome within this time, whatever happens, in ns:
   *     two of the barriers' deadlines
   * @param promptNs a waiting robot is told within this time of the last member's arrival, in ns; while
   *     a majority of the members takes part, and no fault has been active, and every robot has been up,
   *     for {@link FaultState#SETTLE_NS}
   */
  public BarrierSpec(long releasedWithinNs, long toldWithinNs, long promptNs) {
    super(BarrierFact::isBarrier);
    lemma(NO_EARLY, "No robot passes the barrier before all its members have arrived.");
    lemma(UNIFORM, "All robots that wait at one barrier are told the same outcome.");
    released =
        progress(
            NOT_HUNG,
            NOT_HUNG_SAYS,
            releasedWithinNs,
            sinceNs -> "waits, though no live member is absent, since " + sinceNs + " ns");
    prompt =
        progress(
            NOT_HUNG,
            NOT_HUNG_SAYS,
            promptNs,
            sinceNs -> "waits in a calm world, though all have arrived, since " + sinceNs + " ns");
    told =
        progress(
            NOT_HUNG, NOT_HUNG_SAYS, toldWithinNs, sinceNs -> "waits since " + sinceNs + " ns");
  }

  @Override
  protected BarrierRecord begin(Instance source) {
    return new BarrierRecord(source, faults);
  }

  @Override
  public List<String> perRobotLemmas() {
    return List.of(UNIFORM);
  }

  @Override
  public List<Monitor> companions() {
    return List.of(new BarrierConformance(), new SynodSpec());
  }

  @Override
  protected void acted(Action action, Report report) {
    BarrierRecord generations = instance(action.source());
    switch (action.fact()) {
      case BarrierFact.Created created -> generations.created(created.i(), created.members());
      case BarrierAction.arrive coming -> generations.arrived(coming.g(), coming.i());
      default -> {}
    }
  }

  @Override
  protected void changed(Variable variable, Report report) {
    BarrierOutcome outcome = variable.of(BarrierFact.OUTCOME);
    if (outcome != null) {
      instance(variable.source()).told(variable, outcome, report);
    }
  }

  @Override
  protected void ended(RobotId robot) {
    instances().values().forEach(generations -> generations.ended(robot));
  }

  @Override
  protected void review(long nowNs, Report report) {
    boolean isCalm = faults.isCalm(nowNs, FaultState.SETTLE_NS);
    instances()
        .forEach((source, generations) -> {
          boolean isFair = faults.isFaultFree() && generations.hasMajorityUp();
          for (RobotId robot : generations.robots()) {
            ProcessKey key = new ProcessKey(source, robot);
            if (generations.isWaiting(robot)) {
              told.start(key, nowNs);
              released.start(key, nowNs);
              released.assume(key, isFair && generations.isNoneToCome(robot), nowNs);
              prompt.start(key, nowNs);
              prompt.assume(key, isCalm && isFair && generations.haveAllArrived(robot), nowNs);
            } else {
              released.stop(key);
              prompt.stop(key);
              if (told.stop(key) && generations.isUp(robot)) {
                report.checked(NOT_HUNG);
              }
            }
          }
        });
  }
}
