package org.starl.primitives.registration;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodSpec;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;
import org.starl.spec.Deadlines;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.InstanceSpec;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * The specification of registrations, after the package's contract: {@code Agreement}, {@code Keeps},
 * {@code Fresh}, {@code Soundness}, and, where a bound is given, {@code Registered}: of joining and of
 * leaving.
 */
public final class RegistrationSpec extends InstanceSpec<ViewHistory> {

  static final String AGREEMENT = "Agreement";
  static final String KEEPS = "Keeps";
  static final String FRESH = "Fresh";
  static final String SOUNDNESS = "Soundness";
  static final String REGISTERED = "Registered";

  private static final String REGISTERED_SAYS =
      "A robot that asks to be registered or removed is so within the bound, or told that it failed.";

  private final Deadlines progress;
  private final Deadlines removal;
  private final Map<ProcessKey, Leaver> leaving = new LinkedHashMap<>();

  /** The latest id of a robot that must go from the views. */
  private record Leaver(ProcessId id, boolean isGivenUp) {}

  /** Safety only. */
  public RegistrationSpec() {
    this(Deadlines.NO_BOUND);
  }

  /**
   * Safety, and progress within a bound. It is owed while a majority of the acceptors is up and no
   * fault but crashes is active, and again with the whole bound once that holds again.
   *
   * @param registeredWithinNs from {@code do_register} until a view lists the robot, or from the time
   *     when a listed id leaves or is given up until no view lists it; in ns. A reported failure ends
   *     this, but not for an id that is given up
   */
  public RegistrationSpec(long registeredWithinNs) {
    super(RegistrationTrace::isRegistration);
    lemma(AGREEMENT, "Lists with the same number are equal on all robots.");
    lemma(KEEPS, "A registered process stays on the list until it leaves or is confined.");
    lemma(FRESH, "An id that has left the list never comes back.");
    lemma(SOUNDNESS, "Every id on a list has asked to be registered.");
    progress =
        progress(
            REGISTERED,
            REGISTERED_SAYS,
            registeredWithinNs,
            sinceNs -> "do_register at " + sinceNs + " ns, and in no view since");
    removal =
        progress(
            REGISTERED,
            REGISTERED_SAYS,
            registeredWithinNs,
            sinceNs -> "given up, and listed since " + sinceNs + " ns");
  }

  @Override
  protected ViewHistory begin(String source) {
    return new ViewHistory(source);
  }

  @Override
  public List<String> perRobotLemmas() {
    return List.of(AGREEMENT, FRESH);
  }

  @Override
  public List<Monitor> companions() {
    return List.of(new RegistrationConformance(), new SynodSpec(RegistrationTrace.PRIMITIVE));
  }

  @Override
  protected void acted(Action action, Report report) {
    ViewHistory history = instance(action.source());
    switch (action.name()) {
      case RegistrationTrace.DO_REGISTER -> {
        history.asked(action.robot(), id(action));
        progress.start(new ProcessKey(action.source(), action.robot()), action.timeNs());
      }
      case RegistrationTrace.ACCEPTORS -> history.vote(action.args());
      case RegistrationTrace.CONFINE ->
          history.mayBeConfined(action.robot(), Confinement.parse(action.args()));
      case RegistrationTrace.UNREGISTER, RegistrationTrace.GIVE_UP -> {
        history.mayLeave(action.robot(), id(action));
        ProcessKey key = new ProcessKey(action.source(), action.robot());
        leaving.put(key, new Leaver(id(action), action.name().equals(RegistrationTrace.GIVE_UP)));
        awaitRemoval(action.source(), history.latest(), action.timeNs(), report);
      }
      default -> {}
    }
  }

  @Override
  protected void changed(Variable variable, Report report) {
    ViewHistory history = instance(variable.source());
    ProcessKey key = new ProcessKey(variable.source(), variable.robot());
    switch (variable.name()) {
      case RegistrationTrace.VIEW -> {
        View view = View.parse(variable.value());
        history.learned(variable, view, report);
        awaitRemoval(variable.source(), history.latest(), variable.timeNs(), report);
        ProcessId asked = history.latestAsked(variable.robot());
        if (view.number() == 0) {
          // The program has started: what its predecessor was owed is void.
          progress.stop(key);
        } else if (asked != null && view.contains(asked)) {
          progress.meet(key, report);
        }
      }
      case RegistrationTrace.R_LIST -> history.shown(variable, report);
      case RegistrationTrace.FAILED -> {
        if (variable.value().equals("true")) {
          progress.stop(key);
          Leaver leaver = leaving.get(key);
          if (leaver != null && !leaver.isGivenUp()) {
            removal.stop(key);
            leaving.remove(key);
          }
        }
      }
      default -> {}
    }
  }

  private void awaitRemoval(String source, View latest, long nowNs, Report report) {
    leaving.forEach((key, leaver) -> {
      if (key.source().equals(source)) {
        if (latest.mentions(leaver.id())) {
          removal.start(key, nowNs);
        } else {
          removal.meet(key, report);
        }
      }
    });
  }

  @Override
  protected void ended(RobotId robot) {
    for (String source : instances().keySet()) {
      ProcessKey key = new ProcessKey(source, robot);
      progress.stop(key);
      removal.stop(key);
      leaving.remove(key);
    }
  }

  @Override
  protected void review(long nowNs, Report report) {
    Predicate<ProcessKey> isOwed =
        key -> {
          List<RobotId> voters = instance(key.source()).acceptors();
          return faults.isFaultFree() && (voters.isEmpty() || hasMajorityUp(voters));
        };
    progress.assumeEach(isOwed, nowNs);
    removal.assumeEach(isOwed, nowNs);
  }

  private static ProcessId id(Action action) {
    return ProcessId.parse(action.args().get(0));
  }
}
