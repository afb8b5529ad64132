package org.starl.primitives.barrier;

import static org.starl.time.Time.NS_PER_MS;

import java.util.List;
import java.util.Set;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.SynodSpec;
import org.starl.primitives.suspicion.SuspicionCheck;
import org.starl.spec.Deadlines;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.FaultState;
import org.starl.spec.InstanceSpec;
import org.starl.spec.Monitor;
import org.starl.spec.TellCheck;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/**
 * The specification of barriers, after the package's contract: {@code NoEarly}, {@code Uniform}, and,
 * where bounds are given, {@code NotHung}, and with {@link #patient} {@code Suspected} and {@code Behind}.
 */
public final class BarrierSpec extends InstanceSpec<BarrierRecord> {

  static final String NO_EARLY = "barrier.NoEarly";
  static final String UNIFORM = "barrier.Uniform";
  static final String NOT_HUNG = "barrier.NotHung";

  static final String SUSPECTED = "barrier.Suspected";
  static final String BEHIND = "barrier.Behind";

  private static final String NOT_HUNG_SAYS =
      "A robot that waits at a barrier is told an outcome within the bound.";

  private final Deadlines released;
  private final Deadlines prompt;
  private final Deadlines told;
  private final SuspicionCheck silence = new SuspicionCheck(SUSPECTED, faults);
  private final TellCheck tells = new TellCheck(BEHIND);
  private long deadlineNs;

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
    super(BarrierFact.PRIMITIVE);
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

  /**
   * Also requires that no robot gives a member up, or its wait, before these times; and that a robot
   * which is behind is told, and one that is ahead is asked.
   */
  public BarrierSpec patient(BarrierSettings settings) {
    lemma(
        SUSPECTED,
        "No robot gives up a member that it has heard within the silence, or the deadline.");
    lemma(
        BEHIND,
        "Who hears a member tells it at once if it has arrived, or what is decided, and asks one that is ahead.");
    tells.begin();
    silence.setSilence(settings.silenceMs() * NS_PER_MS);
    deadlineNs = settings.deadlineMs() * NS_PER_MS;
    told.setLeast(2 * deadlineNs);
    return this;
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
      if (outcome instanceof BarrierOutcome.Unknown) {
        ProcessKey key = new ProcessKey(variable.source(), variable.robot());
        told.giveUp(key, variable.timeNs(), faults, report);
      }
      instance(variable.source()).told(variable, outcome, report);
    }
  }

  @Override
  protected void happened(TraceEvent event, Report report) {
    tells.observe(event, report);
    if (event instanceof Delivered got && got.message() instanceof BarrierMessage message) {
      silence.heard(got.channel(), got, message.from());
      BarrierRecord generations = instance(got.channel());
      if (generations.mustAnswer(got.robot(), message)) {
        Set<Long> arrivals = generations.arrivals(got.robot());
        tells.owes(
            got,
            got.from().name(),
            "an answer to " + message,
            told ->
                told instanceof SynodMessage.Decided
                    || (told instanceof BarrierMessage.Here here
                        && here.hasArrived() == arrivals.contains(here.generation())));
      }
    } else if (event instanceof Sent sent
        && sent.message() instanceof BarrierMessage.Here here
        && here.noted() > here.generation()) {
      tells.owes(sent, sent.to(), "a query", told -> told instanceof SynodMessage.Query);
    } else if (event instanceof Sent sent
        && sent.channel().kind().equals(BarrierFact.SYNOD)
        && sent.message() instanceof SynodMessage.Accept accept) {
      Instance source = sent.channel().owner();
      if (told.isBounded() && !instance(source).isWaiting(sent.robot())) {
        String detail = source + ": " + accept + ", although it does not wait";
        report.violated(NOT_HUNG, sent.timeNs(), List.of(sent.robot()), detail);
      }
      long sinceNs = told.beganNs(new ProcessKey(source, sent.robot()));
      boolean isEarly =
          sent.timeNs() < sinceNs + deadlineNs && faults.isClockRight(sent.robot(), sinceNs);
      Set<ProcessId> missing = instance(source).givenUp(accept);
      if (missing.isEmpty()) {
        silence.suspectsNobody(report); // it could have named members
      }
      if (isEarly) {
        missing.forEach(id -> silence.suspects(source, sent, id, sinceNs, report));
      }
    }
  }

  @Override
  protected void ended(RobotId robot) {
    instances().values().forEach(generations -> generations.ended(robot));
    silence.ended(robot);
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
