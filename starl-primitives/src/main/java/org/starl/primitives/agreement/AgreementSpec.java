package org.starl.primitives.agreement;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.spec.Deadlines;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.InstanceSpec;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * The specification of {@link SetAgreement}: {@code Agreement}, one value for each instance; {@code
 * Validity}, only a proposed value; and, where a bound is given, {@code Decided}.
 */
public final class AgreementSpec extends InstanceSpec<AgreementSpec.Instance> {

  static final String AGREEMENT = "Agreement";
  static final String VALIDITY = "Validity";
  static final String DECIDED = "Decided";

  private final Deadlines progress;

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
    super(SetAgreement::isAgreement);
    lemma(AGREEMENT, "No two robots decide on different values.");
    lemma(VALIDITY, "Only a proposed value is decided on.");
    progress =
        progress(
            DECIDED,
            "A robot that proposes learns of a decision within the bound.",
            decidedWithinNs,
            sinceNs -> "knows no decision of what it proposed by " + sinceNs + " ns");
  }

  /** One agreement. */
  static final class Instance {
    private List<RobotId> acceptors = List.of();
    private final Set<String> proposals = new TreeSet<>();
    private final Set<RobotId> knowing = new TreeSet<>();
    private @Nullable First decision;
  }

  /** The first robot to know the decision, and its value. */
  private record First(RobotId robot, String value) {}

  @Override
  protected Instance begin(String source) {
    return new Instance();
  }

  @Override
  public List<String> perRobotLemmas() {
    return List.of(AGREEMENT);
  }

  @Override
  public List<Monitor> companions() {
    return List.of(new AgreementConformance(), new SynodSpec(SetAgreement.PRIMITIVE));
  }

  @Override
  protected void acted(Action action, Report report) {
    Instance instance = instance(action.source());
    switch (action.name()) {
      case SetAgreement.ACCEPTORS -> {
        if (instance.acceptors.isEmpty()) {
          instance.acceptors =
              action.args().stream().map(RobotId::new).collect(Collectors.toList());
        }
      }
      case SetAgreement.PROPOSE -> {
        instance.proposals.add(action.args().get(0));
        if (!instance.knowing.contains(action.robot())) {
          progress.start(new ProcessKey(action.source(), action.robot()), action.timeNs());
        }
      }
      default -> {}
    }
  }

  @Override
  protected void changed(Variable variable, Report report) {
    boolean isDecision =
        variable.name().equals(SetAgreement.DECIDED) && !variable.value().equals(Decision.NONE_YET);
    boolean isFailure =
        variable.name().equals(SetAgreement.FAILED)
            && variable.value().equals(Boolean.TRUE.toString());
    if (isDecision) {
      Instance instance = instance(variable.source());
      decided(instance, variable, report);
      instance.knowing.add(variable.robot());
    }
    if (isDecision || isFailure) {
      progress.meet(new ProcessKey(variable.source(), variable.robot()), report);
    }
  }

  private static void decided(Instance instance, Variable event, Report report) {
    report.checked(AGREEMENT);
    First first = instance.decision;
    if (first == null) {
      first = new First(event.robot(), event.value());
      instance.decision = first;
    }
    if (!first.value().equals(event.value())) {
      report.violated(
          AGREEMENT,
          event.timeNs(),
          List.of(first.robot(), event.robot()),
          event.source() + ": " + first.value() + " and " + event.value());
    }
    report.checked(VALIDITY);
    if (!instance.proposals.contains(event.value())) {
      report.violated(
          VALIDITY,
          event.timeNs(),
          List.of(event.robot()),
          event.source() + ": " + event.value() + " was never proposed");
    }
  }

  @Override
  protected void ended(RobotId robot) {
    instances()
        .forEach((source, instance) -> {
          instance.knowing.remove(robot);
          progress.stop(new ProcessKey(source, robot));
        });
  }

  @Override
  protected void review(long nowNs, Report report) {
    progress.assumeEach(
        key -> faults.isFaultFree() && hasMajorityUp(instance(key.source()).acceptors), nowNs);
  }
}
