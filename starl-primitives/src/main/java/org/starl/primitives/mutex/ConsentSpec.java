package org.starl.primitives.mutex;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.AgreementFact;
import org.starl.primitives.membership.Liveness;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.spec.InstanceMonitor;
import org.starl.spec.Within;
import org.starl.time.Time;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Sent;

/**
 * The rules of consent, on the messages of every mutex: a broken rule is seen long before two robots
 * hold one section.
 *
 * <ul>
 *   <li>{@code Consent}: a participant enters only with the consent of all whose consent it needs:
 *       those in its latest view, and those that were admitted later and have asked it. It enters no
 *       section of another robot's ghost. Of a section with a capacity, some may have told that they
 *       take a place themselves; with the ghosts, they are fewer than its places. It enters no part of a
 *       sequence while the ghost of a robot that is not listed is in a section that it waits for.
 *   <li>{@code Fenced}: a participant that has fenced another consents to nothing more of it, also
 *       after it has retired. It asks for fences only of those that its latest view lists.
 *   <li>{@code Answered}, {@code Tells} and {@code Late}, with {@link #answering}: see {@link AnswerCheck}.
 * </ul>
 *
 * <p>With bounds it also reports, under {@code Served}, requests that wait too long for one cause: for
 * a ghost only, or for a dead participant that is not confined. Consent is not checked of runs in real
 * time, since the end of a killed process's trace may be missing, nor of traces without messages.
 */
final class ConsentSpec extends InstanceMonitor<ConsentSpec.Group> {

  static final String CONSENT = "mutex.Consent";
  static final String FENCED = "mutex.Fenced";
  static final String LATE = "mutex.Late";
  static final String ANSWERED = "mutex.Answered";
  static final String TELLS = "mutex.Tells";

  private final Within<Asker> behindGhosts;
  private final Within<List<ProcessId>> behindDead;
  private final Liveness liveness = new Liveness();
  // By the name that a mutex shares with its registration: those that decide its views.
  private final Map<String, Collection<RobotId>> voters = new TreeMap<>();
  private boolean isRealTime;
  private @Nullable AnswerCheck answers;

  /**
   * @param ghostNs within which a request ends that only a ghost blocks
   * @param deadNs within which a dead participant is confined that a request waits for
   */
  ConsentSpec(long ghostNs, long deadNs) {
    super(MutexFact.PRIMITIVE);
    behindGhosts = new Within<>(ghostNs);
    behindDead = new Within<>(deadNs);
    lemma(CONSENT, "A process enters only with the consent of all processes that it needs.");
    lemma(
        FENCED, "A process grants nothing more to one that it has fenced, and fences listed ones.");
  }

  /** Also requires that requests are answered at once. Not of runs in real time: their steps take time. */
  ConsentSpec answering() {
    lemma(
        ANSWERED,
        "A process that wants no section consents at once; a repeated request is answered at once, an ended one not.");
    lemma(
        TELLS,
        "A process asks all that it knows at once, and tells them what it gives back, or that it ends.");
    lemma(LATE, "A request ends as late only when it hears of one that goes first.");
    answers = new AnswerCheck();
    return this;
  }

  /** One mutex. */
  static final class Group {
    private final Map<ProcessId, Asker> askers = new TreeMap<>();
    private final Set<RobotId> robots = new TreeSet<>();
    private final String xid;
    private boolean hasMessages;

    private Group(String xid) {
      this.xid = xid;
    }

    private Asker of(ProcessId who) {
      return askers.computeIfAbsent(who, Asker::new);
    }
  }

  /** One participant: its latest request, its view, and what it has granted. Compared by identity. */
  static final class Asker {
    private final ProcessId who;
    private boolean isTrying;
    private long num;
    private boolean inOrder;
    private boolean resumes;
    private SortedSet<String> held = Sections.NONE;
    private SortedSet<String> waiting = Sections.NONE;
    private Collection<ProcessId> known = List.of();
    private View view = View.NONE;
    private final Map<ProcessId, Long> heard = new TreeMap<>();
    private final Map<ProcessId, SortedSet<String>> answered = new TreeMap<>();
    private final Map<ProcessId, SortedSet<String>> sharers = new TreeMap<>();
    private final Map<ProcessId, Long> granted = new TreeMap<>();
    private final Set<ProcessId> fenced = new TreeSet<>();
    private final Set<ProcessId> awaited = new TreeSet<>();

    private Asker(ProcessId who) {
      this.who = who;
    }

    /** Those whose consent to one of {@code sections} is missing. */
    private Set<ProcessId> missing(SortedSet<String> sections) {
      Set<ProcessId> missing = new TreeSet<>(known);
      missing.addAll(view.admitted().keySet());
      heard.forEach((id, admittedBy) -> {
        if (admittedBy > view.number()) {
          missing.add(id);
        }
      });
      missing.remove(who);
      missing.removeIf(id -> answered.getOrDefault(id, Sections.NONE).containsAll(sections));
      return missing;
    }

    /** Those of {@link #missing} that have not even told that they take a place of each of these. */
    private Set<ProcessId> silent(SortedSet<String> sections) {
      Set<ProcessId> silent = missing(sections);
      silent.removeIf(id ->
          Sections.union(
                  answered.getOrDefault(id, Sections.NONE), sharers.getOrDefault(id, Sections.NONE))
              .containsAll(sections));
      return silent;
    }

    /** Whether one of {@code sections} has no place beside its ghosts and the robots that told so. */
    private boolean isFull(SortedSet<String> sections) {
      return sections.stream()
          .anyMatch(section -> {
            Set<RobotId> sharing = ghostsIn(section);
            missing(new TreeSet<>(Set.of(section))).stream()
                .filter(id -> sharers.getOrDefault(id, Sections.NONE).contains(section))
                .forEach(id -> sharing.add(id.robot()));
            return !hasPlace(section, sharing);
          });
    }

    private Set<RobotId> ghostsIn(String section) {
      Set<RobotId> robots = new TreeSet<>();
      ghosts()
          .filter(ghost -> ghost.getValue().sections().contains(section))
          .forEach(ghost -> robots.add(ghost.getKey().robot()));
      return robots;
    }

    /** A resumed request may be for where its body is: that is a place already. */
    private boolean hasPlace(String section, Set<RobotId> others) {
      others.remove(who.robot());
      return others.size() < Sections.capacity(section) || (resumes && Sections.isLimited(section));
    }

    /** Whether ghosts alone keep it from one of {@code sections}. */
    private boolean hasGhostIn(SortedSet<String> sections) {
      return ghosts().anyMatch(ghost -> Sections.exclude(ghost.getValue().sections(), sections))
          || sections.stream().anyMatch(each -> !hasPlace(each, ghostsIn(each)));
    }

    /** Whether a robot that may come towards it, since it is not listed, has a ghost on its way. */
    private boolean isBehindGhost() {
      return ghosts()
          .filter(ghost -> !view.participants().contains(ghost.getKey().robot()))
          .anyMatch(ghost -> Sections.exclude(ghost.getValue().sections(), waiting));
    }

    private Stream<Map.Entry<ProcessId, View.Ghost>> ghosts() {
      return view.ghosts().entrySet().stream()
          .filter(ghost -> !ghost.getKey().robot().equals(who.robot()));
    }

    @Override
    public String toString() {
      return who + "'s request " + num + " for " + Sections.union(held, waiting);
    }
  }

  @Override
  protected Group begin(Instance source) {
    return new Group(source.xid());
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    finish(event.timeNs(), report);
    if (liveness.observe(event)) {
      behindGhosts.assumeAll(liveness.isFair(), event.timeNs());
      behindDead.assumeAll(liveness.isFair(), event.timeNs());
      instances().values().forEach(mutex -> livenessChanged(mutex, event.timeNs()));
    }
    if (answers != null) {
      answers.observe(event, report);
    }
    super.observe(event, report);
  }

  @Override
  public void finish(long endNs, Report report) {
    behindGhosts.expire(
        endNs,
        (asker, sinceNs, dueNs) -> {
          String detail = asker + " waits only for a ghost since " + Time.text(sinceNs, 3);
          report.overdue(MutexProgress.SERVED, dueNs, List.of(asker.who.robot()), detail);
        });
    behindDead.expire(
        endNs,
        (pair, sinceNs, dueNs) -> {
          String detail =
              String.format(
                  "%s waits for the dead %s since %s",
                  pair.get(0), pair.get(1), Time.text(sinceNs, 3));
          report.overdue(MutexProgress.SERVED, dueNs, List.of(pair.get(0).robot()), detail);
        });
  }

  @Override
  protected void acted(TraceEvent.Action action, Report report) {
    Group mutex = instance(action.source());
    if (action.fact() instanceof MutexFact fact) {
      acted(mutex, fact, action.timeNs(), report);
    }
  }

  private void acted(Group mutex, MutexFact event, long nowNs, Report report) {
    mutex.robots.add(event.who().robot());
    Asker asker = mutex.of(event.who());
    switch (event) {
      case MutexFact.DoMutex e -> {
        asker.num = e.num();
        asker.inOrder = !e.sequence().isEmpty();
        asker.resumes = e.resumes();
        asker.held = Sections.common(asker.held, e.want()); // when it asks anew for the rest
        asker.waiting = Sections.without(e.want(), asker.held);
        asker.known = e.known();
        asker.answered.clear();
        asker.sharers.clear();
        asker.isTrying = true;
      }
      case MutexFact.Known e -> asker.known = e.known();
      case MutexFact.Learned e -> asker.view = e.view();
      case MutexFact.Fence e -> asker.fenced.add(e.suspect());
      case MutexFact.Grant e -> granted(asker, e.to(), e.num(), nowNs, report);
      case MutexFact.OdMutex e -> {
        SortedSet<String> isNew = Sections.without(e.held(), asker.held);
        entered(mutex, asker, isNew, nowNs, report);
        asker.held = e.held();
        asker.waiting = asker.inOrder ? Sections.without(asker.waiting, e.held()) : Sections.NONE;
        asker.isTrying = !asker.waiting.isEmpty();
      }
      case MutexFact.Release e -> asker.held = e.left();
      case MutexFact.Withdraw e -> asker.isTrying &= e.num() != asker.num;
      default -> {}
    }
    await(mutex, asker, nowNs);
  }

  @Override
  protected void happened(TraceEvent event, Report report) {
    switch (event) {
      case Sent sent when sent.message() instanceof MutexMessage message ->
          sent(sent, message, report);
      case Delivered delivered when delivered.message() instanceof MutexMessage.Req req -> {
        Group mutex = instance(delivered.channel());
        Asker asker = mutex.of(req.to());
        asker.heard.put(req.from(), req.admittedBy());
        await(mutex, asker, delivered.timeNs());
      }
      case Fault fault -> isRealTime |= fault.isRealTime();
      case TraceEvent.Action action
          when action.fact() instanceof AgreementFact.Acceptors acceptors ->
          voters.put(action.source().xid(), acceptors.robots());
      default -> {}
    }
  }

  private void sent(Sent sent, MutexMessage message, Report report) {
    Group mutex = instance(sent.channel());
    mutex.hasMessages = true;
    if (message instanceof MutexMessage.Ok ok) {
      Asker from = mutex.of(ok.from());
      granted(from, ok.to(), ok.num(), sent.timeNs(), report);
      Asker asker = mutex.of(ok.to());
      if (asker.num == ok.num()) {
        SortedSet<String> all = Sections.union(asker.held, asker.waiting);
        asker.sharers.merge(from.who, ok.counted(), Sections::union);
        asker.answered.merge(
            from.who, Sections.without(ok.granted(all), ok.counted()), Sections::union);
        await(mutex, asker, sent.timeNs());
      }
    } else if (message instanceof MutexMessage.FenceQ question) {
      View view = mutex.of(question.from()).view;
      report.checked(FENCED);
      if (view.number() >= question.admittedBy() && !view.contains(question.suspect())) {
        String detail = question + ": a fence of a process that is not listed";
        report.violated(FENCED, sent.timeNs(), List.of(sent.robot()), detail);
      }
    }
  }

  private static void granted(Asker by, ProcessId to, long num, long nowNs, Report report) {
    report.checked(FENCED);
    boolean isNew = num > Objects.requireNonNullElse(by.granted.put(to, num), 0L);
    if (isNew && by.fenced.contains(to)) {
      String detail =
          by.who + " consents to request " + num + " of " + to + ", which it has fenced";
      report.violated(FENCED, nowNs, List.of(by.who.robot()), detail);
    }
  }

  private void entered(
      Group mutex, Asker asker, SortedSet<String> sections, long nowNs, Report report) {
    if (isRealTime || !mutex.hasMessages) {
      return;
    }
    report.checked(CONSENT);
    Set<ProcessId> missing = asker.silent(sections);
    boolean hasGhost = asker.hasGhostIn(sections) || asker.isBehindGhost();
    if (!missing.isEmpty() || hasGhost || asker.isFull(sections)) {
      String what = hasGhost ? "a ghost's section" : "a section that is full";
      String detail = asker + " enters " + (missing.isEmpty() ? what : "without " + missing);
      report.violated(CONSENT, nowNs, List.of(asker.who.robot()), detail);
    }
  }

  /** Updates what a request waits for. */
  private void await(Group mutex, Asker asker, long nowNs) {
    Set<ProcessId> missing = asker.isTrying ? asker.missing(asker.waiting) : Set.of();
    boolean holds = !asker.held.isEmpty();
    if (asker.isTrying && !holds && missing.isEmpty() && asker.hasGhostIn(asker.waiting)) {
      behindGhosts.start(asker, nowNs);
    } else {
      behindGhosts.stop(asker);
    }
    Set<ProcessId> dead = new TreeSet<>(missing);
    dead.removeIf(id -> !isToBeConfined(mutex, asker.view, id));
    for (ProcessId id : List.copyOf(asker.awaited)) {
      if (!dead.contains(id)) {
        asker.awaited.remove(id);
        behindDead.stop(List.of(asker.who, id));
      }
    }
    for (ProcessId id : dead) {
      if (asker.awaited.add(id)) {
        behindDead.start(List.of(asker.who, id), nowNs);
      }
    }
  }

  /** Whether a live participant that the dead one had to ask is listed, and views can be decided. */
  private boolean isToBeConfined(Group mutex, View view, ProcessId id) {
    if (!liveness.isDead(id) || !view.contains(id)) {
      return false;
    }
    Collection<RobotId> deciding = voters.getOrDefault(mutex.xid, mutex.robots);
    long up = deciding.stream().filter(liveness::isUp).count();
    boolean hasFencer =
        view.admitted().entrySet().stream()
            .anyMatch(other ->
                !liveness.isDead(other.getKey()) && other.getValue() <= view.admittedBy(id));
    return hasFencer && 2 * up > deciding.size();
  }

  /** Ends the requests of dead participants, and looks at what others wait for. */
  private void livenessChanged(Group mutex, long nowNs) {
    for (Asker asker : List.copyOf(mutex.askers.values())) {
      boolean isDead = liveness.isDead(asker.who);
      asker.isTrying &= !isDead;
      await(mutex, asker, nowNs);
      if (isDead) {
        mutex.askers.remove(asker.who);
      }
    }
  }
}
