package org.starl.primitives.agreement;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage.Accept;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.spec.Deadlines;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.FlagCheck;
import org.starl.spec.InstanceSpec;
import org.starl.spec.Monitor;
import org.starl.spec.TellCheck;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/**
 * The specification of {@link SetAgreement}: {@code Agreement}, one value for each instance; {@code
 * Validity}, only a proposed value; {@code failed}: the variable is false after a proposal, and does not
 * become true once the robot knows the decision. Where a bound is given, also {@code Decided}: a robot that
 * proposes is served in time, and once it has given up, asks no more; and {@code Informed}: a robot that
 * decides tells all acceptors at once.
 */
public final class AgreementSpec extends InstanceSpec<AgreementSpec.Run> {

  static final String AGREEMENT = "agreement.Agreement";
  static final String VALIDITY = "agreement.Validity";
  static final String DECIDED = "agreement.Decided";
  static final String INFORMED = "agreement.Informed";
  static final String FAILED = "agreement.failed";

  private final Deadlines progress;
  private final FlagCheck<Boolean> failed = flag(AgreementFact.FAILED, FAILED);
  private final TellCheck tells = new TellCheck(INFORMED);
  private final LastVote lastVote = new LastVote();
  private long nowNs;

  /** Safety only. */
  public AgreementSpec() {
    this(Deadlines.NO_BOUND);
  }

  /**
   * Safety, and progress within a bound.
   *
   * @param decidedWithinNs from a proposal until its robot knows a decision or reports a failure, in
   *     ns; while a majority of the acceptors is up and no fault but crashes is active, and owed again
   *     with the whole bound once that holds again
   */
  public AgreementSpec(long decidedWithinNs) {
    super(AgreementFact.PRIMITIVE);
    lemma(AGREEMENT, "No two robots decide on different values.");
    lemma(VALIDITY, "Only a proposed value is decided on.");
    progress =
        progress(
            DECIDED,
            "A robot that proposes learns of a decision within the bound; one that gives up asks no more.",
            decidedWithinNs,
            sinceNs -> "knows no decision of what it proposed by " + sinceNs + " ns");
    lemma(FAILED, "The variable failed says whether the latest proposal was given up.");
    if (progress.isBounded()) {
      lemma(INFORMED, "A robot that decides sends the decision at once to all acceptors.");
      tells.begin();
    }
  }

  /** One agreement. */
  static final class Run {
    private List<RobotId> acceptors = List.of();
    private final Set<String> proposals = new TreeSet<>();
    private final Set<RobotId> knowing = new TreeSet<>();
    private final Set<RobotId> givenUp = new TreeSet<>();
    private @Nullable First decision;
  }

  /** The first robot to know the decision, and its value. */
  private record First(RobotId robot, String value) {}

  @Override
  protected Run begin(Instance source) {
    return new Run();
  }

  @Override
  public List<String> perRobotLemmas() {
    return List.of(AGREEMENT);
  }

  @Override
  public List<Monitor> companions() {
    return List.of(new AgreementConformance(), new SynodSpec());
  }

  @Override
  protected void acted(Action action, Report report) {
    nowNs = action.timeNs();
    Run run = instance(action.source());
    switch (action.fact()) {
      case AgreementFact.Acceptors acceptors -> {
        if (run.acceptors.isEmpty()) {
          run.acceptors = acceptors.robots();
        }
      }
      case AgreementAction.propose proposal -> {
        run.proposals.add(proposal.v());
        run.givenUp.remove(action.robot());
        ProcessKey key = new ProcessKey(action.source(), action.robot());
        boolean isOpen = !run.knowing.contains(action.robot());
        if (isOpen) {
          progress.start(key, action.timeNs());
        }
        failed.says(key, action, is -> !is || (isOpen && nowNs > action.timeNs()), report);
      }
      default -> {}
    }
  }

  @Override
  protected void changed(Variable variable, Report report) {
    nowNs = variable.timeNs();
    failed.shows(variable, report);
    boolean isOver = Boolean.TRUE.equals(variable.of(AgreementFact.FAILED));
    if (isOver) {
      instance(variable.source()).givenUp.add(variable.robot());
    }
    if (variable.of(AgreementFact.DECIDED) instanceof Decision.Decided<?> decision) {
      Run run = instance(variable.source());
      decided(run, decision.toString(), variable, report); // as in the proposal
      run.knowing.add(variable.robot());
      isOver = true;
      boolean hasGivenUp = run.givenUp.contains(variable.robot());
      ProcessKey key = new ProcessKey(variable.source(), variable.robot());
      failed.says(key, variable, is -> !is || hasGivenUp, report);
      if (lastVote.decides(variable, 1)) {
        mustInform(run, variable);
      }
    }
    if (isOver) {
      progress.meet(new ProcessKey(variable.source(), variable.robot()), report);
    }
  }

  private void mustInform(Run run, Variable variable) {
    for (RobotId acceptor : run.acceptors) {
      if (!acceptor.equals(variable.robot())) {
        tells.owes(
            variable,
            acceptor.name(),
            "the decision",
            told -> told instanceof SynodMessage.Decided);
      }
    }
  }

  private static void decided(Run run, String value, Variable event, Report report) {
    report.checked(AGREEMENT);
    First first = run.decision;
    if (first == null) {
      first = new First(event.robot(), value);
      run.decision = first;
    }
    if (!first.value().equals(value)) {
      report.violated(
          AGREEMENT,
          event.timeNs(),
          List.of(first.robot(), event.robot()),
          event.source() + ": " + first.value() + " and " + value);
    }
    report.checked(VALIDITY);
    if (!run.proposals.contains(value)) {
      report.violated(
          VALIDITY,
          event.timeNs(),
          List.of(event.robot()),
          event.source() + ": " + value + " was never proposed");
    }
  }

  @Override
  protected void happened(TraceEvent event, Report report) {
    tells.observe(event, report);
    lastVote.observe(event);
    if (progress.isBounded()
        && event instanceof Sent sent
        && (sent.message() instanceof Prepare || sent.message() instanceof Accept)
        && sent.channel().kind().equals(AgreementFact.PRIMITIVE)
        && instance(sent.channel()).givenUp.contains(sent.robot())) {
      String detail = sent.channel() + ": " + sent.message() + " after it has given up";
      report.violated(DECIDED, sent.timeNs(), List.of(sent.robot()), detail);
    }
  }

  @Override
  protected void ended(RobotId robot) {
    instances()
        .forEach((source, run) -> {
          run.knowing.remove(robot);
          run.givenUp.remove(robot);
          progress.stop(new ProcessKey(source, robot));
        });
  }

  @Override
  protected void review(long nowNs, Report report) {
    progress.assumeEach(
        key -> faults.isFaultFree() && hasMajorityUp(instance(key.source()).acceptors), nowNs);
  }
}
