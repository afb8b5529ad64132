package org.starl.primitives.registration;

import static org.starl.time.Time.NS_PER_MS;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.AgreementFact;
import org.starl.primitives.agreement.LastVote;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.SynodSpec;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;
import org.starl.spec.Deadlines;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.FlagCheck;
import org.starl.spec.InstanceSpec;
import org.starl.spec.Monitor;
import org.starl.spec.TellCheck;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * The specification of registrations, after the package's contract: {@code Agreement}, {@code Keeps},
 * {@code Fresh}, {@code Soundness}, {@code rList}, and, where a bound is given, {@code Registered}: of
 * joining and of leaving; and with {@link #patient} {@code Informed}.
 */
public final class RegistrationSpec extends InstanceSpec<ViewHistory> {

  static final String AGREEMENT = "registration.Agreement";
  static final String KEEPS = "registration.Keeps";
  static final String FRESH = "registration.Fresh";
  static final String SOUNDNESS = "registration.Soundness";
  static final String REGISTERED = "registration.Registered";
  static final String INFORMED = "registration.Informed";
  static final String RUMOUR = "registration.Rumour";
  static final String R_LIST = "registration.rList";

  private static final String REGISTERED_SAYS =
      "A robot that asks to be registered or removed is so within the bound, or told that it failed.";

  private final Deadlines progress;
  private final Deadlines removal;
  private final TellCheck tells = new TellCheck(INFORMED);
  private final RumourCheck rumours = new RumourCheck();
  private final Map<ProcessKey, Leaver> leaving = new LinkedHashMap<>();
  private final LastVote lastVote = new LastVote();
  private final FlagCheck<RList> list = flag(RegistrationFact.R_LIST, R_LIST);
  private final Map<ProcessKey, Program> programs = new LinkedHashMap<>();

  /** One start of a robot's program: the id that asked and has not left, and its latest view. */
  private record Program(@Nullable ProcessId id, View view) {
    RList list() {
      return id != null && view.contains(id)
          ? new RList.Agreed(view.participants(), view.number())
          : RList.UNKNOWN;
    }
  }

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
    super(RegistrationFact::isRegistration);
    lemma(AGREEMENT, "Lists with the same number are equal on all robots.");
    lemma(KEEPS, "A registered process stays on the list until it leaves or is confined.");
    lemma(FRESH, "An id that has left the list never comes back.");
    lemma(SOUNDNESS, "Every id on a list has asked to be registered.");
    lemma(
        R_LIST,
        "The variable rList is null, or the list of the robot's latest view, and the robot is on it.");
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

  /**
   * Also requires, as part of {@code Registered}, that no call fails before the deadline; of
   * registrations with these times. A call also fails, at once, if its robot has no room in the list.
   * Also requires that a robot which decides a view tells all robots that need to know it, and that one which
   * hears of a newer view hides its list.
   */
  public RegistrationSpec patient(RegistrationSettings settings) {
    lemma(
        INFORMED,
        "A robot that decides a view sends it at once to all acceptors, and to all robots that it lists or removes.");
    lemma(RUMOUR, "A robot that hears of a newer view hides its list at once.");
    tells.begin();
    rumours.begin();
    progress.setLeast(settings.deadlineMs() * NS_PER_MS);
    removal.setLeast(settings.deadlineMs() * NS_PER_MS);
    return this;
  }

  @Override
  protected ViewHistory begin(Instance source) {
    return new ViewHistory(source);
  }

  @Override
  public List<String> perRobotLemmas() {
    return List.of(AGREEMENT, FRESH, R_LIST);
  }

  @Override
  public List<Monitor> companions() {
    return List.of(new RegistrationConformance(), new SynodSpec());
  }

  @Override
  protected void acted(Action action, Report report) {
    ViewHistory history = instance(action.source());
    ProcessKey key = new ProcessKey(action.source(), action.robot());
    switch (action.fact()) {
      case RegistrationAction.do_register asked -> {
        history.asked(action.robot(), asked.i());
        progress.start(key, action.timeNs());
        has(key, new Program(asked.i(), program(key).view), action, report);
      }
      case AgreementFact.Acceptors acceptors -> history.vote(acceptors.robots());
      case Confinement confinement -> history.mayBeConfined(action.robot(), confinement);
      case RegistrationAction.unregister left ->
          leaves(history, action, new Leaver(left.i(), false), report);
      case RegistrationAction.give_up gone ->
          leaves(history, action, new Leaver(gone.i(), true), report);
      default -> {}
    }
  }

  private void leaves(ViewHistory history, Action action, Leaver leaver, Report report) {
    history.mayLeave(action.robot(), leaver.id());
    ProcessKey key = new ProcessKey(action.source(), action.robot());
    leaving.put(key, leaver);
    if (leaver.id().equals(program(key).id)) {
      has(key, new Program(null, program(key).view), action, report);
    }
    awaitRemoval(action.source(), history.latest(), action.timeNs(), report);
  }

  private Program program(ProcessKey key) {
    return programs.getOrDefault(key, new Program(null, View.NONE));
  }

  private void has(ProcessKey key, Program program, TraceEvent event, Report report) {
    programs.put(key, program);
    RList agreed = program.list();
    list.says(key, event, shown -> !shown.isAgreed() || shown.equals(agreed), report);
  }

  @Override
  protected void changed(Variable variable, Report report) {
    ViewHistory history = instance(variable.source());
    ProcessKey key = new ProcessKey(variable.source(), variable.robot());
    list.shows(variable, report);
    RList shown = variable.of(RegistrationFact.R_LIST);
    rumours.observe(variable, report); // ends the step before
    if (shown != null) {
      rumours.shows(key, shown);
    }
    View view = variable.of(RegistrationFact.VIEW);
    if (view != null) {
      rumours.learns(key, view.number());
      if (lastVote.decides(variable, view.number())) {
        mustInform(history, variable, view);
      }
      history.learned(variable, view, report);
      has(key, new Program(program(key).id, view), variable, report);
      awaitRemoval(variable.source(), history.latest(), variable.timeNs(), report);
      ProcessId asked = history.latestAsked(variable.robot());
      if (view.number() == 0) {
        // The program has started: what its predecessor was owed is void.
        progress.stop(key);
      } else if (asked != null && view.contains(asked)) {
        progress.meet(key, report);
      }
    } else if (Boolean.TRUE.equals(variable.of(RegistrationFact.FAILED))) {
      ProcessId asked = history.latestAsked(variable.robot());
      if (asked != null && ViewFormat.fitsWithRoom(program(key).view.next().with(asked))) {
        progress.giveUp(key, variable.timeNs(), faults, report);
      }
      progress.stop(key);
      Leaver leaver = leaving.get(key);
      if (leaver != null && !leaver.isGivenUp()) {
        removal.giveUp(key, variable.timeNs(), faults, report);
        leaving.remove(key);
      }
    }
  }

  private void mustInform(ViewHistory history, Variable variable, View view) {
    Set<RobotId> concerned = new TreeSet<>(history.acceptors());
    View before = program(new ProcessKey(variable.source(), variable.robot())).view();
    Stream.of(before, view)
        .forEach(each -> each.mentioned().forEach(id -> concerned.add(id.robot())));
    concerned.remove(variable.robot());
    for (RobotId robot : concerned) {
      tells.owes(
          variable,
          robot.name(),
          "view " + view,
          told -> told instanceof Decided it && it.number() == view.number());
    }
  }

  @Override
  protected void happened(TraceEvent event, Report report) {
    tells.observe(event, report);
    rumours.observe(event, report);
    lastVote.observe(event);
  }

  private void awaitRemoval(Instance source, View latest, long nowNs, Report report) {
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
    rumours.ended(robot);
    for (Instance source : instances().keySet()) {
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
}
