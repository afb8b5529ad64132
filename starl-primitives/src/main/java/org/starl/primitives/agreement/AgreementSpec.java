package org.starl.primitives.agreement;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.RobotId;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * What every {@link SetAgreement} of a run owes: {@code Agreement}, one value an instance, and {@code
 * Validity}, only a value that was proposed. Instances are told apart by their names.
 */
public final class AgreementSpec implements Monitor {

  static final String AGREEMENT = "Agreement";
  static final String VALIDITY = "Validity";

  private final Map<String, Set<String>> proposals = new TreeMap<>();
  private final Map<String, First> decisions = new TreeMap<>();

  /** Who first knew a decision, and which. */
  private record First(RobotId robot, String value) {}

  @Override
  public List<String> lemmas() {
    return List.of(AGREEMENT, VALIDITY);
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    if (event instanceof Action action
        && SetAgreement.isAgreement(action.source())
        && action.name().equals(SetAgreement.PROPOSE)) {
      proposals
          .computeIfAbsent(action.source(), source -> new TreeSet<>())
          .add(action.args().get(0));
    } else if (event instanceof Variable variable
        && SetAgreement.isAgreement(variable.source())
        && variable.name().equals(SetAgreement.DECIDED)
        && !variable.value().equals(Decision.NONE_YET.toString())) {
      decided(variable, report);
    }
  }

  private void decided(Variable event, Report report) {
    report.checked(AGREEMENT);
    First first =
        decisions.computeIfAbsent(
            event.source(), source -> new First(event.robot(), event.value()));
    if (!first.value().equals(event.value())) {
      report.violated(
          AGREEMENT,
          event.timeNs(),
          List.of(first.robot(), event.robot()),
          event.source() + ": " + first.value() + " and " + event.value());
    }
    report.checked(VALIDITY);
    if (!proposals.getOrDefault(event.source(), Set.of()).contains(event.value())) {
      report.violated(
          VALIDITY,
          event.timeNs(),
          List.of(event.robot()),
          event.source() + ": " + event.value() + " was never proposed");
    }
  }
}
