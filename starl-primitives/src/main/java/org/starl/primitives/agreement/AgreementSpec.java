package org.starl.primitives.agreement;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.starl.id.RobotId;
import org.starl.spec.Circumstances;
import org.starl.spec.Dues;
import org.starl.spec.Dues.Seat;
import org.starl.spec.Monitor;
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

  private final Dues progress;
  private final Circumstances circumstances = new Circumstances();
  private final Map<String, Set<String>> proposals = new TreeMap<>();
  private final Map<String, First> decisions = new TreeMap<>();
  private final Map<String, List<RobotId>> acceptors = new TreeMap<>();
  private final Set<Seat> owed = new LinkedHashSet<>();
  private final Set<Seat> knowing = new LinkedHashSet<>();

  /** Safety only. */
  public AgreementSpec() {
    this(Dues.NO_BOUND);
  }

  /**
   * Safety, and progress within a bound.
   *
   * @param decidedWithinNs from a proposal until its robot knows a decision or is told that it failed,
   *     while a majority of the acceptors is up and no fault but crashes is under way; owed anew, with
   *     the whole bound, once that is so again; in ns
   */
  public AgreementSpec(long decidedWithinNs) {
    progress =
        new Dues(
            DECIDED,
            decidedWithinNs,
            sinceNs -> "knows no decision of what it proposed by " + sinceNs + " ns");
  }

  /** Who first knew a decision, and which. */
  private record First(RobotId robot, String value) {}

  @Override
  public List<String> lemmas() {
    return progress.isBounded()
        ? List.of(AGREEMENT, VALIDITY, DECIDED)
        : List.of(AGREEMENT, VALIDITY);
  }

  @Override
  public String says(String lemma) {
    return switch (lemma) {
      case AGREEMENT -> "No two robots decide on different values.";
      case VALIDITY -> "Only a value that somebody has proposed is decided on.";
      case DECIDED -> "Who proposes learns of a decision within the bound.";
      default -> "";
    };
  }

  @Override
  public List<String> ownLemmas() {
    return List.of(AGREEMENT);
  }

  @Override
  public List<Monitor> companions() {
    return List.of(new AgreementConformance());
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    progress.expire(event.timeNs(), report);
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
    progress.expire(endNs, report);
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
        Seat debt = new Seat(action.source(), action.robot());
        if (!knowing.contains(debt)) {
          owed.add(debt);
          progress.owe(debt, action.timeNs());
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
    Seat debt = new Seat(variable.source(), variable.robot());
    if (isDecision) {
      decided(variable, report);
      knowing.add(debt);
    }
    if ((isDecision || isFailure) && settle(debt)) {
      report.checked(DECIDED);
    }
  }

  private boolean settle(Seat debt) {
    owed.remove(debt);
    return progress.settle(debt);
  }

  private void assume(Seat debt, long nowNs) {
    if (!circumstances.isUp(debt.robot())) {
      settle(debt);
    } else {
      List<RobotId> voters = acceptors.getOrDefault(debt.source(), List.of());
      long up = voters.stream().filter(circumstances::isUp).count();
      boolean majority = 2 * up > voters.size();
      progress.assume(debt, majority && circumstances.isFair(), nowNs);
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
