package org.starl.primitives.registration;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.Lives;
import org.starl.primitives.membership.View;
import org.starl.spec.Dues;
import org.starl.spec.Dues.Seat;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * What every registration of a run owes, as the package's contract has it: {@code Agreement}, {@code
 * Keeps}, {@code Fresh}, {@code Soundness}, and, where a bound is given, {@code Registered}: who asks
 * to be in is in within the bound, unless told {@code failed}. Instances are told apart by their
 * names.
 */
public final class RegistrationSpec implements Monitor {

  static final String AGREEMENT = "Agreement";
  static final String KEEPS = "Keeps";
  static final String FRESH = "Fresh";
  static final String SOUNDNESS = "Soundness";
  static final String REGISTERED = "Registered";

  private final Dues progress;
  private final Map<String, ViewHistory> histories = new TreeMap<>();
  private final Map<String, List<RobotId>> acceptors = new TreeMap<>();
  private final Set<Seat> owed = new LinkedHashSet<>();
  private final Lives lives = new Lives();

  /** Safety only. */
  public RegistrationSpec() {
    this(Dues.NO_BOUND);
  }

  /**
   * Safety, and progress within a bound, owed while a majority of the acceptors is up and no fault but
   * crashes is under way, and anew, with the whole bound, once that is so again.
   *
   * @param registeredWithinNs from {@code do_register} until a view lists the robot, in ns
   */
  public RegistrationSpec(long registeredWithinNs) {
    progress =
        new Dues(
            REGISTERED,
            registeredWithinNs,
            sinceNs -> "do_register at " + sinceNs + " ns, and in no view since");
  }

  @Override
  public List<String> lemmas() {
    return progress.isBounded()
        ? List.of(AGREEMENT, KEEPS, FRESH, SOUNDNESS, REGISTERED)
        : List.of(AGREEMENT, KEEPS, FRESH, SOUNDNESS);
  }

  @Override
  public String says(String lemma) {
    return switch (lemma) {
      case AGREEMENT -> "Lists of one number are equal, whoever has them.";
      case KEEPS -> "Who is registered stays on the list until it leaves or is confined.";
      case FRESH -> "Who has left a list never comes back under the same id.";
      case SOUNDNESS -> "Only who has asked to be registered is on a list.";
      case REGISTERED ->
          "Who asks to be registered is, within the bound, unless told that it failed.";
      default -> "";
    };
  }

  @Override
  public List<String> ownLemmas() {
    return List.of(AGREEMENT, FRESH);
  }

  @Override
  public List<Monitor> companions() {
    return List.of(new RegistrationConformance());
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    progress.expire(event.timeNs(), report);
    boolean changed = lives.observe(event);
    switch (event) {
      case Action action when RegistrationTrace.isRegistration(action.source()) -> acted(action);
      case Variable variable when RegistrationTrace.isRegistration(variable.source()) ->
          changed(variable, report);
      default -> {
        // Of no concern here.
      }
    }
    if (changed) {
      for (String source : histories.keySet()) {
        if (!lives.isUp(event.robot())) {
          settle(source, event.robot());
        }
      }
      owed.forEach(debt -> assume(debt, event.timeNs()));
    }
  }

  private void assume(Seat debt, long nowNs) {
    List<RobotId> voters = acceptors.getOrDefault(debt.source(), List.of());
    long up = voters.stream().filter(lives::isUp).count();
    boolean majority = voters.isEmpty() || 2 * up > voters.size();
    progress.assume(debt, majority && lives.isFair(), nowNs);
  }

  @Override
  public void finish(long endNs, Report report) {
    progress.expire(endNs, report);
  }

  private void acted(Action action) {
    switch (action.name()) {
      case RegistrationTrace.DO_REGISTER -> {
        history(action.source()).asked(action.robot(), id(action));
        Seat debt = new Seat(action.source(), action.robot());
        progress.owe(debt, action.timeNs());
        owed.add(debt);
        assume(debt, action.timeNs());
      }
      case RegistrationTrace.ACCEPTORS ->
          acceptors.putIfAbsent(
              action.source(),
              action.args().stream().map(RobotId::new).collect(Collectors.toList()));
      case RegistrationTrace.FIRST_VIEW ->
          history(action.source()).isGiven(View.parse(action.args().get(0)));
      case RegistrationTrace.CONFINE ->
          history(action.source()).mayBeConfined(action.robot(), Confinement.parse(action.args()));
      case RegistrationTrace.UNREGISTER, RegistrationTrace.GIVE_UP ->
          history(action.source()).mayLeave(action.robot(), id(action));
      default -> {
        // Not an action of this specification.
      }
    }
  }

  private void changed(Variable variable, Report report) {
    ViewHistory history = history(variable.source());
    switch (variable.name()) {
      case RegistrationTrace.VIEW -> {
        View view = View.parse(variable.value());
        history.learned(variable, view, report);
        // A program begins with no view: whatever the one before it was owed is void.
        if (view.number() == 0 || view.participants().contains(variable.robot())) {
          settleIfListed(variable, view, report);
        }
      }
      case RegistrationTrace.R_LIST -> history.shown(variable, report);
      case RegistrationTrace.FAILED -> {
        if (variable.value().equals("true")) {
          settle(variable.source(), variable.robot());
        }
      }
      default -> {
        // Not a variable of this specification.
      }
    }
  }

  private void settleIfListed(Variable variable, View view, Report report) {
    ProcessId asked = history(variable.source()).latestAsked(variable.robot());
    boolean isListed = asked != null && view.contains(asked);
    boolean settles = view.number() == 0 || isListed;
    if (settles && settle(variable.source(), variable.robot()) && isListed) {
      report.checked(REGISTERED);
    }
  }

  private boolean settle(String source, RobotId robot) {
    Seat debt = new Seat(source, robot);
    owed.remove(debt);
    return progress.settle(debt);
  }

  private ViewHistory history(String source) {
    return histories.computeIfAbsent(source, ViewHistory::new);
  }

  private static ProcessId id(Action action) {
    return ProcessId.parse(action.args().get(0));
  }
}
