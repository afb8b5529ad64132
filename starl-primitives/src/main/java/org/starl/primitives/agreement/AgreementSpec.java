package org.starl.primitives.agreement;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.RobotId;
import org.starl.spec.Circumstances;
import org.starl.spec.Monitor;
import org.starl.spec.Within;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * What every {@link SetAgreement} of a run owes: {@code Agreement}, one value an instance, {@code
 * Validity}, only a value that was proposed, and, where a bound is given, {@code Decided}. Instances
 * are told apart by their names.
 */
public final class AgreementSpec implements Monitor {

  static final String AGREEMENT = "Agreement";
  static final String VALIDITY = "Validity";
  static final String DECIDED = "Decided";

  private final @Nullable Within<Debt> decidedWithin;
  private final Circumstances circumstances = new Circumstances();
  private final Map<String, Set<String>> proposals = new TreeMap<>();
  private final Map<String, First> decisions = new TreeMap<>();
  private final Map<String, List<RobotId>> acceptors = new TreeMap<>();
  private final Set<Debt> owed = new LinkedHashSet<>();
  private final Set<Debt> knowing = new LinkedHashSet<>();

  /** Safety only. */
  public AgreementSpec() {
    decidedWithin = null;
  }

  /**
   * Safety, and progress within a bound.
   *
   * @param decidedWithinNs from a proposal until its robot knows a decision or is told that it failed,
   *     while a majority of the acceptors is up and no fault but crashes is under way; owed anew, with
   *     the whole bound, once that is so again; in ns
   */
  public AgreementSpec(long decidedWithinNs) {
    decidedWithin = new Within<>(decidedWithinNs);
  }

  /** Who first knew a decision, and which. */
  private record First(RobotId robot, String value) {}

  /** What one robot is to know of one instance. */
  private record Debt(String source, RobotId robot) {}

  @Override
  public List<String> lemmas() {
    return decidedWithin == null
        ? List.of(AGREEMENT, VALIDITY)
        : List.of(AGREEMENT, VALIDITY, DECIDED);
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    expire(event.timeNs(), report);
    if (circumstances.observe(event)) {
      knowing.removeIf(debt -> !circumstances.isUp(debt.robot()));
      List.copyOf(owed).forEach(debt -> assume(debt, event.timeNs()));
    }
    if (event instanceof Action action && SetAgreement.isAgreement(action.source())) {
      acted(action);
    } else if (event instanceof Variable variable && SetAgreement.isAgreement(variable.source())) {
      changed(variable, report);
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    expire(endNs, report);
  }

  private void acted(Action action) {
    switch (action.name()) {
      case SetAgreement.ACCEPTORS ->
          acceptors.putIfAbsent(
              action.source(),
              action.args().stream().map(RobotId::new).collect(Collectors.toList()));
      case SetAgreement.PROPOSE -> {
        proposals
            .computeIfAbsent(action.source(), source -> new TreeSet<>())
            .add(action.args().get(0));
        Debt debt = new Debt(action.source(), action.robot());
        if (decidedWithin != null && !knowing.contains(debt)) {
          owed.add(debt);
          decidedWithin.owe(debt, action.timeNs());
          assume(debt, action.timeNs());
        }
      }
      default -> {
        // Of no concern here.
      }
    }
  }

  private void changed(Variable variable, Report report) {
    boolean isDecision =
        variable.name().equals(SetAgreement.DECIDED)
            && !variable.value().equals(Decision.NONE_YET.toString());
    boolean isFailure =
        variable.name().equals(SetAgreement.FAILED)
            && variable.value().equals(Boolean.TRUE.toString());
    Debt debt = new Debt(variable.source(), variable.robot());
    if (isDecision) {
      decided(variable, report);
      knowing.add(debt);
    }
    if ((isDecision || isFailure) && settle(debt)) {
      report.checked(DECIDED);
    }
  }

  private boolean settle(Debt debt) {
    owed.remove(debt);
    return decidedWithin != null && decidedWithin.settle(debt);
  }

  private void assume(Debt debt, long nowNs) {
    if (!circumstances.isUp(debt.robot())) {
      settle(debt);
    } else if (decidedWithin != null) {
      List<RobotId> voters = acceptors.getOrDefault(debt.source(), List.of());
      long up = voters.stream().filter(circumstances::isUp).count();
      boolean majority = 2 * up > voters.size();
      decidedWithin.assume(debt, majority && circumstances.isFair(), nowNs);
    }
  }

  private void expire(long nowNs, Report report) {
    if (decidedWithin != null) {
      decidedWithin.expire(
          nowNs,
          (debt, sinceNs, deadlineNs) -> {
            report.checked(DECIDED);
            report.violated(
                DECIDED,
                deadlineNs,
                List.of(debt.robot()),
                debt.source() + ": knows no decision of what it proposed by " + sinceNs + " ns");
          });
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
