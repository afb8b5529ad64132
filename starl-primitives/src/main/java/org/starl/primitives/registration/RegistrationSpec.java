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
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.SynodMessage.Query;
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
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/**
 * The specification of registrations, after the package's contract: {@code Agreement}, {@code Keeps},
 * {@code Fresh}, {@code Soundness}, {@code rList}, {@code failed}, and, where a bound is given, {@code Registered}: of
 * joining and of leaving; and with {@link #patient} {@code Informed}, {@code Rumour}, {@code Asks}, {@code
 * Shown} and {@code Completes}.
 */
public final class RegistrationSpec extends InstanceSpec<ViewHistory> {

  static final String AGREEMENT = "registration.Agreement";
  static final String KEEPS = "registration.Keeps";
  static final String FRESH = "registration.Fresh";
  static final String SOUNDNESS = "registration.Soundness";
  static final String REGISTERED = "registration.Registered";
  static final String INFORMED = "registration.Informed";
  static final String RUMOUR = "registration.Rumour";
  static final String STAYS = "registration.Stays";
  static final String ASKS = "registration.Asks";
  static final String SHOWN = "registration.Shown";
  static final String COMPLETES = "registration.Completes";
  static final String R_LIST = "registration.rList";
  static final String FAILED = "registration.failed";

  private static final String REGISTERED_SAYS =
      "A robot that asks to be registered or removed is so within the bound, or told that it failed.";

  private final Deadlines progress;
  private final Deadlines removal;
  private final Deadlines disposal;
  private Deadlines hidden = new Deadlines(SHOWN, Deadlines.NO_BOUND, sinceNs -> "");
  private Deadlines late = new Deadlines(COMPLETES, Deadlines.NO_BOUND, sinceNs -> "");
  private Deadlines silent = new Deadlines(ASKS, Deadlines.NO_BOUND, sinceNs -> "");
  private final TellCheck tells = new TellCheck(INFORMED);
  private final TellCheck asks = new TellCheck(ASKS);
  private final RumourCheck rumours = new RumourCheck();
  private final Map<ProcessKey, Telling> tellings = new LinkedHashMap<>();
  private final Map<ProcessKey, ProcessId> leaving = new LinkedHashMap<>();
  private final Map<ProcessKey, ProcessId> halfway = new LinkedHashMap<>();
  private final Map<ProcessKey, Set<ProcessId>> disposed = new LinkedHashMap<>();
  private boolean isStoodInFor;
  private long nowNs;
  private final LastVote lastVote = new LastVote();
  private final FlagCheck<RList> list = flag(RegistrationFact.R_LIST, R_LIST);
  private final FlagCheck<Boolean> failed = flag(RegistrationFact.FAILED, FAILED);
  private final Map<ProcessKey, Program> programs = new LinkedHashMap<>();

  // The last number that may admit an id which its robot gives up as it joins.
  private final Map<ProcessKey, Long> givenUpAfter = new LinkedHashMap<>();

  /** One start of a robot's program: the id that asked and has not left, and its latest view. */
  private record Program(@Nullable ProcessId id, View view) {
    RList list() {
      return id != null && view.contains(id)
          ? new RList.Agreed(view.participants(), view.number())
          : RList.UNKNOWN;
    }
  }

  /** A robot that has decided a view, and those that do not know it yet. */
  private record Telling(long number, long sinceNs, Set<RobotId> lacking) {}

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
    super(RegistrationFact.PRIMITIVE);
    lemma(AGREEMENT, "Lists with the same number are equal on all robots.");
    lemma(KEEPS, "A registered process stays on the list until it leaves or is confined.");
    lemma(
        FRESH,
        "An id that has left the list never comes back; one that may have left unseen, and no other, asks no more.");
    lemma(SOUNDNESS, "Every id on a list has asked to be registered.");
    lemma(
        R_LIST,
        "The variable rList is null, or the list of the robot's latest view, and the robot is on it.");
    lemma(
        FAILED,
        "The variable failed says whether the latest call was given up, or the robot removed.");
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
            sinceNs -> "unregister at " + sinceNs + " ns, and listed since");
    disposal =
        progress(
            REGISTERED,
            REGISTERED_SAYS,
            registeredWithinNs,
            sinceNs -> "given up, and listed since " + sinceNs + " ns");
  }

  /**
   * Also requires, as part of {@code Registered}, that no call fails before the deadline; of
   * registrations with these times. Also requires that a robot which decides a view tells all robots that need to know it, and that one which
   * hears of a newer view hides its list, for a bounded time, and then asks for that view.
   */
  public RegistrationSpec patient(RegistrationSettings settings) {
    lemma(
        INFORMED,
        "A robot that decides a view sends it at once to all acceptors, and to all robots that it lists or removes.");
    lemma(
        STAYS,
        "A robot that has left ends when all know the latest view that it decided, or after 5 s.");
    lemma(RUMOUR, "A robot that hears of a newer view hides its list at once.");
    silent =
        progress(
            ASKS,
            "A registered robot asks an acceptor every few seconds, and all of them if a newer view does not come.",
            2 * settings.queryMs() * NS_PER_MS,
            sinceNs -> "asks no acceptor for a newer view since " + sinceNs + " ns");
    hidden =
        progress(
            SHOWN,
            "A registered robot hides its list for no longer than a newer view may take.",
            2 * settings.nullMs() * NS_PER_MS,
            sinceNs -> "hides its list since " + sinceNs + " ns");
    late =
        progress(
            COMPLETES,
            "A registered robot that does not get the newer view that it has asked for proposes that view itself.",
            3 * settings.nullMs() * NS_PER_MS,
            sinceNs -> "lacks the newer view, and proposes none since " + sinceNs + " ns");
    tells.begin();
    rumours.begin();
    asks.begin();
    progress.setLeast(settings.deadlineMs() * NS_PER_MS);
    removal.setLeast(settings.deadlineMs() * NS_PER_MS);
    return this;
  }

  /**
   * Also requires, as part of {@code Registered}, that the ids of a robot's earlier starts go from the views:
   * of programs that declare at their start that they are in no section.
   */
  public RegistrationSpec standingIn() {
    isStoodInFor = true;
    return this;
  }

  /** Of runs without faults on a network without loss: there nothing asks for {@code Completes}. */
  public RegistrationSpec undisturbed() {
    never(COMPLETES, "no message is lost and no robot crashes: each newer view comes in time");
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
    nowNs = action.timeNs();
    ViewHistory history = instance(action.source());
    ProcessKey key = new ProcessKey(action.source(), action.robot());
    switch (action.fact()) {
      case RegistrationAction.do_register asked -> {
        ProcessId earlier = halfway.remove(key);
        if (earlier != null) {
          disposes(key, earlier, action.timeNs(), report);
        }
        history.asked(action.robot(), asked.i());
        rumours.joins(key, true);
        progress.start(key, action.timeNs());
        failed.says(key, action, is -> !is || nowNs > action.timeNs(), report);
        has(key, new Program(asked.i(), program(key).view), action, report);
      }
      case AgreementFact.Acceptors acceptors -> history.vote(acceptors.robots());
      case Confinement confinement -> {
        history.mayBeConfined(action.robot(), confinement);
        report.checked(KEEPS);
        if (confinement.who().equals(program(key).id)) {
          String detail = key.source() + ": confines itself, " + confinement.who();
          report.violated(KEEPS, action.timeNs(), List.of(action.robot()), detail);
        }
      }
      case RegistrationAction.unregister left -> {
        leaving.put(key, left.i());
        leaves(history, action, left.i(), report);
        awaitRemoval(action.source(), history.latest(), action.timeNs(), report);
      }
      case RegistrationAction.give_up gone -> {
        if (gone.i().equals(program(key).id) && !program(key).view.contains(gone.i())) {
          givenUpAfter.put(key, rumours.askedIn(key));
        }
        leaves(history, action, gone.i(), report);
        disposes(key, gone.i(), action.timeNs(), report);
      }
      default -> {}
    }
  }

  private void leaves(ViewHistory history, Action action, ProcessId id, Report report) {
    history.mayLeave(action.robot(), id);
    ProcessKey key = new ProcessKey(action.source(), action.robot());
    if (id.equals(program(key).id)) {
      has(key, new Program(null, program(key).view), action, report);
    }
  }

  /** The id must go from the views, whatever is reported. The bound begins anew for all such ids of the robot. */
  private void disposes(ProcessKey key, ProcessId id, long nowNs, Report report) {
    disposed.computeIfAbsent(key, any -> new TreeSet<>()).add(id);
    disposal.stop(key);
    awaitRemoval(key.source(), instance(key.source()).latest(), nowNs, report);
  }

  private Program program(ProcessKey key) {
    return programs.getOrDefault(key, new Program(null, View.NONE));
  }

  private void has(ProcessKey key, Program program, TraceEvent event, Report report) {
    programs.put(key, program);
    RList agreed = program.list();
    list.says(
        key,
        event,
        shown -> shown.equals(agreed) || (!shown.isAgreed() && rumours.mayHide(key)),
        report);
    awaitList(key, event.timeNs(), report);
  }

  /** What a registered robot owes: to ask, to show its list, and to propose the view that it lacks. */
  private void awaitList(ProcessKey key, long nowNs, Report report) {
    boolean isListed = program(key).list().isAgreed();
    boolean isShown = rumours.isListShown(key);
    await(silent, key, isListed, nowNs, report);
    await(hidden, key, isListed && !isShown, nowNs, report);
    await(late, key, isListed && isShown && rumours.isBehind(key), nowNs, report);
  }

  private static void await(
      Deadlines deadlines, ProcessKey key, boolean isDue, long nowNs, Report report) {
    if (isDue) {
      deadlines.start(key, nowNs);
    } else {
      deadlines.meet(key, report);
    }
  }

  @Override
  protected void changed(Variable variable, Report report) {
    nowNs = variable.timeNs();
    ViewHistory history = instance(variable.source());
    ProcessKey key = new ProcessKey(variable.source(), variable.robot());
    list.shows(variable, report);
    failed.shows(variable, report);
    RList shown = variable.of(RegistrationFact.R_LIST);
    rumours.observe(variable, report); // ends the step before
    if (shown != null) {
      rumours.shows(key, shown);
      awaitList(key, variable.timeNs(), report);
      if (shown.isAgreed() && rumours.mayHide(key)) { // the newer view did not come in time
        for (RobotId acceptor : history.acceptors()) {
          asks.owes(variable, acceptor.name(), "a question", told -> told instanceof Query);
        }
      }
    }
    Boolean mayEnd = variable.of(RegistrationFact.UNREGISTERED);
    if (mayEnd != null) {
      report.checked(STAYS);
      if (mayEnd) {
        checkStays(key, variable.timeNs(), report);
      }
    }
    View view = variable.of(RegistrationFact.VIEW);
    if (view != null) {
      mayMiss(key, view, variable, report);
      rumours.learns(key, view.number());
      if (lastVote.decides(variable, view.number())) {
        mustInform(history, variable, view);
      }
      history.learned(variable, view, report);
      boolean isStart = view.number() == 0;
      has(key, new Program(isStart ? null : program(key).id, view), variable, report);
      if (isStart && isStoodInFor) {
        history
            .askedBy(variable.robot())
            .forEach(id -> disposes(key, id, variable.timeNs(), report));
      }
      awaitRemoval(variable.source(), history.latest(), variable.timeNs(), report);
      ProcessId asked = history.latestAsked(variable.robot());
      if (isStart) {
        // The program has started: what its predecessor was owed is void.
        progress.stop(key);
      } else if (asked != null && view.contains(asked)) {
        progress.meet(key, report);
      }
    } else if (Boolean.TRUE.equals(variable.of(RegistrationFact.FAILED))) {
      givenUpAfter.remove(key);
      progress.giveUp(key, variable.timeNs(), faults, report);
      progress.stop(key);
      ProcessId left = leaving.remove(key);
      if (left != null) {
        removal.giveUp(key, variable.timeNs(), faults, report);
        halfway.put(key, left);
      }
    } else if (Boolean.FALSE.equals(variable.of(RegistrationFact.FAILED))) {
      ProcessId left = halfway.remove(key);
      if (left != null) { // unregister again, which is no action
        leaving.put(key, left);
        awaitRemoval(variable.source(), history.latest(), variable.timeNs(), report);
      }
    }
  }

  private void mayMiss(ProcessKey key, View view, Variable variable, Report report) {
    ProcessId id = program(key).id;
    long askedIn = rumours.askedIn(key);
    Long gaveUpAfter = givenUpAfter.remove(key);
    if (id != null && view.contains(id)) {
      rumours.joins(key, false);
    } else if (id != null && askedIn > 0 && view.number() > askedIn) {
      String detail = key.source() + ": still asks as " + id + ", which a view before may have had";
      report.violated(FRESH, variable.timeNs(), List.of(variable.robot()), detail);
    } else if (gaveUpAfter != null && view.number() <= gaveUpAfter) {
      String detail = key.source() + ": gives up an id that no view before can have had";
      report.violated(FRESH, variable.timeNs(), List.of(variable.robot()), detail);
    }
    if (id != null && program(key).view.contains(id) && !view.contains(id) && view.number() > 0) {
      failed.says(key, variable, is -> is || nowNs > variable.timeNs(), report);
    }
  }

  private void mustInform(ViewHistory history, Variable variable, View view) {
    Set<RobotId> concerned = new TreeSet<>(history.acceptors());
    ProcessKey key = new ProcessKey(variable.source(), variable.robot());
    View before = program(key).view();
    Stream.of(before, view)
        .forEach(each -> each.mentioned().forEach(id -> concerned.add(id.robot())));
    concerned.remove(variable.robot());
    tellings.put(key, new Telling(view.number(), variable.timeNs(), concerned));
    for (RobotId robot : concerned) {
      tells.owes(
          variable,
          robot.name(),
          "view " + view,
          told -> told instanceof Decided it && it.number() == view.number());
    }
  }

  private void checkStays(ProcessKey key, long nowNs, Report report) {
    Telling telling = tellings.get(key);
    if (telling != null
        && !telling.lacking.isEmpty()
        && nowNs - telling.sinceNs < RegistrationProtocol.BROADCAST_MS * NS_PER_MS
        && faults.isClockRight(key.robot(), telling.sinceNs)) {
      String detail = key.source() + ": ends, and view " + telling.number + " has not reached ";
      report.violated(STAYS, nowNs, List.of(key.robot()), detail + telling.lacking);
    }
  }

  @Override
  protected void happened(TraceEvent event, Report report) {
    tells.observe(event, report);
    asks.observe(event, report);
    rumours.observe(event, report);
    if (event instanceof Delivered got && got.message() instanceof Decided decided) {
      tellings.forEach((key, telling) -> {
        if (key.source().equals(got.channel().owner()) && telling.number <= decided.number()) {
          telling.lacking.remove(got.robot());
        }
      });
    }
    if (event instanceof Sent sent && sent.message() instanceof SynodMessage) {
      ProcessKey key = new ProcessKey(sent.channel(), sent.robot());
      if (sent.message() instanceof Query) {
        silent.meet(key, report);
      }
      awaitList(key, sent.timeNs(), report);
    }
    lastVote.observe(event);
  }

  private void awaitRemoval(Instance source, View latest, long nowNs, Report report) {
    leaving.forEach((key, id) -> {
      if (key.source().equals(source)) {
        await(removal, key, latest.mentions(id), nowNs, report);
      }
    });
    disposed.forEach((key, ids) -> {
      if (key.source().equals(source)) {
        await(disposal, key, ids.stream().anyMatch(latest::mentions), nowNs, report);
      }
    });
  }

  @Override
  protected void ended(RobotId robot) {
    rumours.ended(robot);
    for (Instance source : instances().keySet()) {
      ProcessKey key = new ProcessKey(source, robot);
      for (Deadlines each : List.of(progress, removal, disposal, hidden, late, silent)) {
        each.stop(key);
      }
      List.of(leaving, halfway, disposed, tellings, givenUpAfter).forEach(ids -> ids.remove(key));
    }
  }

  @Override
  protected void review(long nowNs, Report report) {
    Predicate<ProcessKey> isOwed =
        key -> {
          List<RobotId> voters = instance(key.source()).acceptors();
          return faults.isFaultFree() && (voters.isEmpty() || hasMajorityUp(voters));
        };
    List.of(progress, removal, disposal).forEach(each -> each.assumeEach(isOwed, nowNs));
    List.of(hidden, late, silent).forEach(each -> each.assumeAll(faults.isFaultFree(), nowNs));
  }
}
