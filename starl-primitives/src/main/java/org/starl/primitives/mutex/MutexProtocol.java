// Longer than 500 lines because all its rules depend on one state: sets and sequences have one
// order.
package org.starl.primitives.mutex;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.starl.comms.LamportClock;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexMessage.Fence;
import org.starl.primitives.mutex.MutexMessage.FenceQ;
import org.starl.primitives.mutex.MutexMessage.Fenced;
import org.starl.primitives.mutex.MutexMessage.Noted;
import org.starl.primitives.mutex.MutexMessage.Ok;
import org.starl.primitives.mutex.MutexMessage.Rem;
import org.starl.primitives.mutex.MutexMessage.Req;
import org.starl.random.Rng;

/**
 * One participant of the mutex: Ricart and Agrawala ("An optimal algorithm for mutual exclusion in
 * computer networks", CACM 1981) on sets of sections, with dynamic membership. Pure and
 * clock-driven: messages, timers and calls give messages and outcomes. The actions of the theory
 * {@code MutexProtocol_decls} have the names of its methods.
 *
 * <p>The main rule concerns membership. A participant requests only after it has learned a view
 * that lists it. It needs the answers of all participants in its latest view, and of all
 * participants that were admitted by a later view and sent it a request. It stops needing an answer
 * only after it has learned a view that lists itself and not the other. So of two participants the
 * younger has a view that lists the elder, and asks it; the elder learns of the younger by its
 * request, and asks back.
 *
 * <p>A request is for a set, granted all at once, or for a sequence, granted section by section in
 * its order. Consent is given for each section: to a sequence, also for a part of it. So a holder
 * hands over each section as it leaves it, and all sections have one order, that of the requests'
 * logical times. Two rules keep circles out of it, since a sequence holds while it waits:
 *
 * <ul>
 *   <li>A request is <em>late</em> if another request holds one of its sections, still waits, and has
 *       a later time. That holder consents to nothing of the late request, and tells it so ({@code
 *       ahead}). So the late request holds nothing, and it ends.
 *   <li>A new process of a robot whose earlier one may hold sections <em>resumes</em>: it claims the
 *       sections ahead of it. It comes before all that wait and hold none of these, which would wait
 *       for its body, and after those that hold one and tell it that they are ahead. It consents to no
 *       other request for what it claims. While one is ahead, it cannot go on; it asks anew, with a
 *       later time, if another resuming process waits only for its turn: the one that is ahead may wait
 *       for that one's body.
 * </ul>
 */
class MutexProtocol {

  /** The phase of the latest request. */
  enum Phase {
    IDLE,
    TRYING,
    CRITICAL
  }

  /**
   * A participant's identity and resources.
   *
   * @param resume what the robot's earlier processes had of a sequence
   */
  record Self(
      ProcessId me,
      LamportClock clock,
      MutexTimes times,
      Rng rng,
      boolean canConfine,
      Resume resume) {

    /** Of a robot without earlier processes. */
    Self(ProcessId me, LamportClock clock, MutexTimes times, Rng rng, boolean canConfine) {
      this(me, clock, times, rng, canConfine, Resume.NOTHING);
    }
  }

  /**
   * What a new process of a robot takes over from the robot's earlier ones.
   *
   * @param stands the sections in which the body may be
   * @param claims these and the sections ahead of them
   */
  record Resume(SortedSet<String> stands, SortedSet<String> claims) {

    static final Resume NOTHING = new Resume(Sections.NONE, Sections.NONE);

    boolean isOver() {
      return claims.isEmpty();
    }

    private Resume without(SortedSet<String> sections) {
      return new Resume(Sections.without(stands, sections), Sections.without(claims, sections));
    }
  }

  private final ProcessId me;
  private final LamportClock clock;
  private final boolean canConfine;
  private final MutexEffects effects;

  private View view = View.NONE;
  // The number of the view that admitted me; 0 if not learned yet.
  private long admittedBy;
  private boolean over;

  private Phase phase = Phase.IDLE;
  private long num;
  private long ts;
  // What it holds, and what it waits for, in order; want is both.
  private SortedSet<String> held = Sections.NONE;
  private List<String> waiting = List.of();
  private SortedSet<String> want = Sections.NONE;
  private boolean inOrder;
  // The receivers of the current request, and for each the sections without its needed consent.
  private final TreeMap<ProcessId, SortedSet<String>> asked = new TreeMap<>();
  // For each receiver that told so, the sections of which it takes a place before this request.
  private final TreeMap<ProcessId, SortedSet<String>> sharers = new TreeMap<>();
  private final RequestTimers timers;

  // What it takes over. Requests of others that come before its own, as these told; and requests
  // that its own one comes before, as it told. Each for one request of both.
  private Resume resume;
  private final TreeMap<ProcessId, Long> ahead = new TreeMap<>();
  private final TreeMap<ProcessId, Long> behind = new TreeMap<>();

  // Participants that sent a request and were admitted by a view later than mine, and its number.
  private final TreeMap<ProcessId, Long> heard = new TreeMap<>();
  private final Peers peers = new Peers();
  private final Fences fences;

  MutexProtocol(Self self, MutexEffects effects) {
    this.me = self.me();
    this.clock = self.clock();
    this.canConfine = self.canConfine();
    this.resume = self.resume();
    this.effects = effects;
    this.fences = new Fences(this, effects, self.rng());
    this.timers = new RequestTimers(self.times());
  }

  ProcessId me() {
    return me;
  }

  Phase phase() {
    return phase;
  }

  View view() {
    return view;
  }

  /** The logical time of the newest request. */
  long ts() {
    return ts;
  }

  /** The sections that it has access to. */
  SortedSet<String> held() {
    return held;
  }

  /** The sections that it waits for, in order. */
  List<String> waiting() {
    return waiting;
  }

  /** The sections of the latest request that it has not released. */
  SortedSet<String> wanted() {
    return want;
  }

  /** When {@link #timer} is due; {@code Long.MAX_VALUE} for never. */
  long nextTimerNs() {
    long requestNs = phase == Phase.TRYING ? timers.wakeAtNs() : Long.MAX_VALUE;
    return Math.min(requestNs, fences.wakeAtNs());
  }

  /** Whether the latest learned view lists it, and it has not ended. */
  boolean mayRequest() {
    return !over && view.contains(me);
  }

  /**
   * Whether {@code robot} can hold a section only through these views: true of every robot where
   * participants register, and of the members of a closed group.
   */
  boolean excludes(RobotId robot) {
    return canConfine || view.participants().contains(robot);
  }

  /** The participants to which it must never grant anything, even after it has retired. */
  Set<ProcessId> fenced() {
    return fences.all();
  }

  /** The participants whose consent to a section that it waits for is missing. */
  SortedSet<ProcessId> missing() {
    TreeSet<ProcessId> missing = new TreeSet<>();
    if (phase == Phase.TRYING) {
      asked.forEach((id, lacking) -> {
        if (!lacking.isEmpty()) {
          missing.add(id);
        }
      });
    }
    return missing;
  }

  /** Number of other participants that are known to hold or to wait for all of {@code sections}. */
  int contenders(List<String> sections) {
    return peers.wanting(sections);
  }

  /** It takes this over from earlier processes; before it is in a view. */
  void takeOver(Resume earlier) {
    resume = earlier;
  }

  /** What it still takes over from earlier processes. */
  Resume resume() {
    return resume;
  }

  /** What earlier processes may still hold: where the body stands, and no consent of this process. */
  SortedSet<String> kept() {
    TreeSet<String> rest = new TreeSet<>(resume.claims);
    rest.removeIf(peers::isGiven);
    return Sections.union(resume.stands, rest);
  }

  /** What a later process of this robot takes over from this one. */
  Resume rest() {
    return inOrder && !held.isEmpty()
        ? new Resume(Sections.union(resume.stands, held), Sections.union(resume.claims, want))
        : resume;
  }

  /**
   * The part of {@code peer}'s newest request that this process granted and that {@code peer} may
   * still hold.
   */
  SortedSet<String> open(ProcessId peer) {
    return peers.open(peer);
  }

  /** The participants whose answers a request needs now. */
  SortedSet<ProcessId> known() {
    TreeSet<ProcessId> all = new TreeSet<>(view.admitted().keySet());
    all.addAll(heard.keySet());
    all.remove(me);
    return all;
  }

  // ------------------------------------------------------------------ calls

  /** {@code do_mutex}: requests {@code sections} from all known participants, or fails at once. */
  void request(SortedSet<String> sections, long nowNs) {
    request(List.copyOf(sections), false, nowNs);
  }

  /**
   * The same for a set or a sequence.
   *
   * @param sections no two equal
   * @param oneByOne whether they are granted one by one, in this order
   */
  void request(List<String> sections, boolean oneByOne, long nowNs) {
    boolean mustRegister = oneByOne && over; // the caller cannot know before it is told
    if (phase != Phase.IDLE && !mustRegister) {
      throw new IllegalStateException(
          "do_mutex of " + sections + " while " + phase + " for " + want);
    }
    if (sections.isEmpty()) {
      throw new IllegalArgumentException("do_mutex of no section");
    }
    if (!mayRequest()) {
      effects.failed(0, MutexFailure.NOT_REGISTERED);
      return;
    }
    waiting = sections;
    want = Sections.copyOf(sections);
    inOrder = oneByOne;
    phase = Phase.TRYING;
    asked.clear();
    timers.begin(nowNs);
    askForTheRest();
    enter();
  }

  /** Asks all known participants for what it waits for, at a new logical time. */
  private void askForTheRest() {
    num++;
    ts = clock.tick();
    ahead.clear();
    behind.clear();
    sharers.clear();
    asked.replaceAll((other, lacking) -> Sections.NONE);
    known().forEach(other -> asked.put(other, Sections.copyOf(waiting)));
    effects.requested(num, ts, want, inOrder ? waiting : List.of(), resumes(), known());
    sendRequests();
    answerPending();
  }

  /** Releases {@code sections}, which it must hold. */
  void release(SortedSet<String> sections) {
    if (sections.isEmpty() || !held().containsAll(sections)) {
      throw new IllegalArgumentException("release of " + sections + " while holding " + held());
    }
    want = Sections.without(want, sections);
    held = Sections.without(held, sections);
    resume = resume.without(sections);
    if (want.isEmpty()) {
      phase = Phase.IDLE;
    }
    effects.released(num, sections, held);
    tellRest();
    answerPending();
    if (over && phase == Phase.IDLE) {
      effects.markIdle();
    }
  }

  /** The sections in which the body is since before a restart, and that it does not request. */
  SortedSet<String> stands() {
    return Sections.without(resume.stands, want);
  }

  /** The body has left these of {@link #stands}. */
  void leave(SortedSet<String> sections) {
    resume = resume.without(sections);
    answerPending();
  }

  /** Ends waiting; what is held stays held. No effect without a waiting request. */
  void withdraw(MutexFailure why) {
    if (phase != Phase.TRYING) {
      return;
    }
    if (why.mustRegister()) {
      resume = rest();
    }
    phase = held.isEmpty() ? Phase.IDLE : Phase.CRITICAL;
    want = held;
    waiting = List.of();
    asked.replaceAll((other, lacking) -> Sections.NONE);
    timers.needsOnly(missing());
    effects.failed(num, why);
    tellRest();
    answerPending();
  }

  /** Ends requests, not answers. Must be idle, since others may forget it from now on. */
  void beginLeave() {
    if (phase != Phase.IDLE) {
      throw new IllegalStateException("leave while " + phase + " for " + want);
    }
    over = true;
    fences.end();
  }

  /** Learns a view if it is later than the known one; numbers may be skipped. */
  void learn(View later) {
    if (later.number() <= view.number()) {
      return;
    }
    view = later;
    effects.learned(view);
    heard.values().removeIf(by -> by <= view.number());
    // A participant that has left is permanently idle or dead: no request of it is open, and an
    // answer to a late message has no effect. A ghost may still shrink, so its record stays.
    peers.forget(id -> !view.mentions(id) && !heard.containsKey(id));
    if (view.contains(me)) {
      admittedBy = view.admittedBy(me);
    } else if (admittedBy > 0) {
      removed();
    }
    fences.look();
    if (phase != Phase.IDLE) {
      knownChanged();
    }
  }

  /** Repeats or ends the request, and continues fencing, if it is time. */
  void timer(long nowNs) {
    if (phase == Phase.TRYING && timers.isOver(nowNs)) {
      withdraw(missing().isEmpty() ? MutexFailure.OCCUPIED : MutexFailure.DEADLINE);
    } else if (phase == Phase.TRYING && timers.resends(nowNs)) {
      goOnWaiting(nowNs);
    }
    fences.timer(nowNs);
  }

  /** Suspects {@code peer}, whose answer it needs, of a crash; it may be wrong. */
  final void suspect(ProcessId peer, long nowNs) {
    if (canConfine && missing().contains(peer) && mayRequest()) {
      Long by = heard.get(peer);
      fences.suspect(peer, by == null ? view.admittedBy(peer) : by, nowNs);
    }
  }

  private void goOnWaiting(long nowNs) {
    SortedSet<ProcessId> missing = missing();
    // Who holds sections goes on waiting: its turn for the others is lost otherwise.
    if (held.isEmpty() && missing.isEmpty() && isOccupied() && timers.isGhostTimeOver(nowNs)) {
      withdraw(MutexFailure.OCCUPIED);
      return;
    }
    sendRequests();
    if (canConfine && !missing.isEmpty()) {
      timers.silent(missing, nowNs).forEach(peer -> suspect(peer, nowNs));
      if (timers.isQueryDue()) {
        effects.refresh();
      }
    }
  }

  // --------------------------------------------------------------- messages

  /** Handles a message to this participant. */
  final void receive(MutexMessage message, long nowNs) {
    if (!message.to().equals(me) || message.from().equals(me)) {
      throw new IllegalArgumentException(message + " is not for " + me);
    }
    timers.heard(message.from(), nowNs);
    fences.heardFrom(message.from());
    switch (message) {
      case Req req -> hear(req);
      case Ok ok -> hearOk(ok);
      case Rem rem -> hearRem(rem);
      case Noted noted -> hearNoted(noted);
      case FenceQ question -> fences.asked(question, nowNs);
      case Fence fence -> fences.answered(fence);
      case Fenced fenced -> hearFenced();
    }
  }

  private void hear(Req req) {
    witness(req.ts());
    noteHeard(req.from(), req.admittedBy());
    Peers.Peer peer = peers.hear(req);
    if (peer == null) {
      return;
    }
    if (peer.hasAll(req)) {
      effects.send(new Ok(me, req.from(), req.num()));
    } else if (refuses(req.from())) {
      effects.send(new Fenced(me, req.from()));
    } else {
      giveWay(req);
      answer(req, peer);
    }
    lookAtGhost(req.from());
  }

  /** Consents to what it does not defer, and tells that it is alive if something is left. */
  private void answer(Req req, Peers.Peer peer) {
    SortedSet<String> free = free(req);
    boolean isNew = isNew(req, peer, free);
    if (isNew) {
      grant(req, peer, free);
    }
    if (!peer.hasAll(req)) {
      boolean isRepeated = peers.defer(req);
      boolean isAhead = isAheadOf(req);
      if (isAhead && req.resumes()) {
        behind.put(req.from(), req.num());
      }
      if (isAhead || (isRepeated && !isNew && peer.granted().isEmpty())) {
        effects.send(new Noted(me, req.from(), req.num(), isAhead ? num : 0));
      } else if (isRepeated && !isNew) {
        send(req, peer);
      }
    }
  }

  private void hearOk(Ok ok) {
    SortedSet<String> lacking = asked.get(ok.from());
    if (phase == Phase.TRYING && answersMyRequest(ok) && lacking != null) {
      if (!ok.counted().isEmpty()) {
        sharers.merge(ok.from(), ok.counted(), Sections::union);
      }
      asked.put(
          ok.from(), Sections.without(lacking, Sections.without(ok.granted(want), ok.counted())));
      timers.needsOnly(missing());
      enter();
    }
  }

  private void hearNoted(Noted noted) {
    if (phase != Phase.TRYING || noted.num() != num || noted.ahead() == 0) {
      return;
    }
    Long theirs = noted.ahead();
    if (!resumes() && held.isEmpty()) {
      withdraw(MutexFailure.LATE);
    } else if (resumes() && keepsOneWaiting()) {
      askForTheRest();
    } else if (resumes()
        && !theirs.equals(behind.get(noted.from())) // each is in the way of the other
        && theirs > ahead.getOrDefault(noted.from(), 0L)) {
      ahead.put(noted.from(), theirs);
      answerPending();
    }
  }

  private void hearRem(Rem rem) {
    peers.hearRem(rem);
    lookAtGhost(rem.from());
  }

  /** Another participant has fenced this one, so it never gets all needed answers. */
  private void hearFenced() {
    // Who holds sections waits for the view that removes it.
    if (mayRequest() && held.isEmpty()) {
      over = true;
      fences.end();
      withdraw(MutexFailure.FENCED);
      effects.markIdle();
    }
  }

  // ------------------------------------------------------------------ rules

  /** The sections of {@code req} to which it consents now: of a set all or none. */
  private SortedSet<String> free(Req req) {
    if (isAheadOf(req) && !req.resumes()) {
      return Sections.NONE;
    }
    TreeSet<String> free = new TreeSet<>(req.waits());
    free.removeIf(section -> defers(req, section));
    return free.size() == req.waits().size() || req.inOrder()
        ? Sections.copyOf(free)
        : Sections.NONE;
  }

  /** Whether it defers its consent to {@code section} of {@code req}. */
  boolean defers(Req req, String section) {
    if (bars(held, req, section)) {
      return true; // a holder defers every request: a new participant's clock may be low
    }
    boolean isClaimed = bars(resume.claims, req, section) && !isBehind(req);
    if (isClaimed && !(req.resumes() && phase == Phase.TRYING)) {
      return true;
    }
    return (isClaimed || bars(want, req, section)) && comesBefore(req);
  }

  /** Whether a participant with one of {@code mine} keeps {@code req} from {@code section}. */
  private boolean bars(SortedSet<String> mine, Req req, String section) {
    return mine.stream()
        .anyMatch(own ->
            Sections.exclude(own, section)
                || (Sections.compete(own, section) && !counts(req, section)));
  }

  /**
   * Whether of this request and {@code req} the later one counts the earlier one in {@code section}. If
   * it does not, the two exclude each other there: {@code req} is of a new participant that this
   * holder did not ask, or one of the two resumes, and so has another place in the order. A resumed
   * one whose body is inside was counted when it entered.
   */
  boolean counts(Req req, String section) {
    if (isInside(section)) {
      boolean isFirst = want.contains(section) && isEarlierThan(req);
      return req.isInside(section) || isCounted(req.from(), section) || isFirst;
    }
    return req.isInside(section) || (want.contains(section) && !req.resumes() && !resumes());
  }

  /** Whether it holds {@code section}, or its body is there since before a restart. */
  private boolean isInside(String section) {
    return held.contains(section) || resume.stands.contains(section);
  }

  /** The sections of {@code part} of which this process takes a place before {@code req}. */
  private SortedSet<String> counted(Req req, SortedSet<String> part) {
    TreeSet<String> counted = new TreeSet<>(part);
    counted.removeIf(section ->
        !Sections.isLimited(section) || req.isInside(section) || !isFirstIn(section, req));
    return Sections.copyOf(counted);
  }

  private boolean isFirstIn(String section, Req req) {
    boolean isEarlier = want.contains(section) && isEarlierThan(req);
    return isInside(section)
        ? isEarlier || !isCounted(req.from(), section)
        : isEarlier && !req.resumes() && !resumes();
  }

  /** Whether its own request comes before {@code req}, where neither of them holds. */
  boolean comesBefore(Req req) {
    if (isBehind(req)) {
      return false;
    }
    if (req.resumes()) {
      return isInTheWayOf(req) || (resumes() && isEarlierThan(req));
    }
    return isEarlierThan(req);
  }

  /** Whether its sender has told that this request comes first. */
  private boolean isBehind(Req req) {
    return resumes() && Long.valueOf(req.num()).equals(ahead.get(req.from()));
  }

  private boolean isEarlierThan(Req req) {
    return isBefore(ts, me, req.ts(), req.from());
  }

  /** Whether its request is for what it takes over. */
  private boolean resumes() {
    return inOrder && !resume.isOver() && resume.claims.containsAll(want);
  }

  private MutexMessage.Kind kind() {
    return !inOrder
        ? MutexMessage.Kind.SET
        : resumes() ? MutexMessage.Kind.RESUMED : MutexMessage.Kind.SEQUENCE;
  }

  /** Whether it holds something of {@code req}, or its body may be there, or it has told so. */
  private boolean isInTheWayOf(Req req) {
    return req.waits().stream()
            .anyMatch(each -> bars(held, req, each) || bars(resume.stands, req, each))
        || Long.valueOf(req.num()).equals(behind.get(req.from()));
  }

  /** Whether it still waits while it is in the way of a request that would go first. */
  private boolean isAheadOf(Req req) {
    return phase == Phase.TRYING
        && !isBehind(req)
        && isInTheWayOf(req)
        && (req.resumes() || !isEarlierThan(req));
  }

  /** Whether a resuming request waits only because its logical time is later than this one's. */
  private boolean keepsOneWaiting() {
    return peers.pending().stream()
        .anyMatch(req ->
            req.resumes()
                && !isInTheWayOf(req)
                && req.waits().stream().anyMatch(each -> defers(req, each)));
  }

  /** Ends its request if it holds nothing and waits for what a resuming process claims. */
  private void giveWay(Req req) {
    if (req.resumes()
        && !resumes()
        && phase == Phase.TRYING
        && held.isEmpty()
        && Sections.compete(want, req.waits())) {
      withdraw(MutexFailure.LATE);
    }
  }

  /** Whether it never grants {@code peer} anything. */
  boolean refuses(ProcessId peer) {
    return fences.isFenced(peer) || view.ghost(peer) != null;
  }

  /**
   * Whether {@code suspect} needs my consent to enter: every view that lists it also lists me, or
   * it has sent me a request.
   */
  boolean hasSayOver(ProcessId suspect, long itsAdmittedBy) {
    return mayRequest() && (admittedBy <= itsAdmittedBy || peers.hasAsked(suspect));
  }

  /** Advances the Lamport clock, so that later requests have later times. */
  void witness(long otherTs) {
    clock.advanceTo(otherTs);
  }

  /** Whether {@code ok} counts for the current request. */
  boolean answersMyRequest(Ok ok) {
    return ok.num() == num;
  }

  /** Remembers a requester that was admitted after my latest view, so that I ask it, too. */
  void noteHeard(ProcessId other, long otherAdmittedBy) {
    if (otherAdmittedBy > view.number()
        && heard.put(other, otherAdmittedBy) == null
        && phase != Phase.IDLE) {
      knownChanged();
    }
  }

  /** Whether {@code other} has told that it takes a place of {@code section} before this request. */
  final boolean isCounted(ProcessId other, String section) {
    return sharers.getOrDefault(other, Sections.NONE).contains(section);
  }

  /** Whether all needed consents to {@code section} have arrived, and it has a place. */
  boolean hasConsents(String section) {
    Set<RobotId> sharing = ghostsIn(section);
    for (Map.Entry<ProcessId, SortedSet<String>> each : asked.entrySet()) {
      if (each.getValue().contains(section)) {
        if (!isCounted(each.getKey(), section)) {
          return false;
        }
        sharing.add(each.getKey().robot());
      }
    }
    return hasPlace(section, sharing);
  }

  /** Whether it finds a place in {@code section} beside these robots, or has it already. */
  private boolean hasPlace(String section, Set<RobotId> others) {
    others.remove(me.robot());
    boolean isInside = resumes() && resume.stands.contains(section);
    return others.size() < Sections.capacity(section) || (isInside && Sections.isLimited(section));
  }

  /** Ends this participant after a view that lists it no longer, or only as a ghost. */
  void removed() {
    boolean isNew = !over;
    over = true;
    fences.end();
    withdraw(MutexFailure.REMOVED);
    if (isNew && phase == Phase.IDLE) {
      effects.markIdle();
    }
  }

  /** Whether a ghost of another robot may be in a section that it waits for. */
  boolean isOccupied() {
    return waiting.stream().anyMatch(this::isOccupied);
  }

  private boolean isOccupied(String section) {
    return !hasPlace(section, ghostsIn(section))
        || ghosts()
            .anyMatch(ghost -> Sections.exclude(ghost.getValue().sections(), List.of(section)));
  }

  /** The robots of which a ghost is in {@code section}, in the same mode. */
  private Set<RobotId> ghostsIn(String section) {
    Set<RobotId> robots = new TreeSet<>();
    ghosts()
        .filter(ghost -> ghost.getValue().sections().contains(section))
        .forEach(ghost -> robots.add(ghost.getKey().robot()));
    return robots;
  }

  /** The ghosts of other robots. */
  Stream<Map.Entry<ProcessId, View.Ghost>> ghosts() {
    return view.ghosts().entrySet().stream()
        .filter(ghost -> !ghost.getKey().robot().equals(me.robot()));
  }

  static boolean isBefore(long ts, ProcessId id, long otherTs, ProcessId other) {
    return ts < otherTs || (ts == otherTs && id.compareTo(other) < 0);
  }

  // ------------------------------------------------------------------ steps

  /** Enters if possible; called after every change that may allow it. */
  final void enter() {
    int free = phase == Phase.TRYING ? grantable() : 0;
    if (free > 0) {
      List<String> granted = waiting.subList(0, free);
      held = Sections.union(held, granted);
      asked.replaceAll((other, lacking) -> Sections.without(lacking, granted));
      waiting = List.copyOf(waiting.subList(free, waiting.size()));
      phase = waiting.isEmpty() ? Phase.CRITICAL : Phase.TRYING;
      timers.needsOnly(missing());
      timers.endDeadline();
      effects.entered(num, held);
      answerPending();
    }
  }

  /** How many of the sections that it waits for it may hold now, from the first. */
  private int grantable() {
    if (isBehindGhost()) {
      return 0;
    }
    int free = 0;
    while (free < waiting.size()
        && !isOccupied(waiting.get(free))
        && hasConsents(waiting.get(free))) {
      free++;
    }
    // While the view has another robot's ghost, a request that holds nothing is granted only as a
    // whole: else it could hold a section and wait for the ghost's one. The body of a resuming
    // robot is in a section anyway, and leaves it sooner part by part.
    boolean isAtOnce = !inOrder || (held.isEmpty() && !resumes() && ghosts().findAny().isPresent());
    return isAtOnce && free < waiting.size() ? 0 : free;
  }

  /**
   * Whether the robot of a ghost ahead may come towards it: it was removed, perhaps wrongly, and no
   * newer process of it is listed, which would keep what its way needs.
   */
  private boolean isBehindGhost() {
    return ghosts()
        .filter(ghost -> !view.participants().contains(ghost.getKey().robot()))
        .anyMatch(ghost -> Sections.exclude(ghost.getValue().sections(), waiting));
  }

  private boolean isNew(Req req, Peers.Peer peer, SortedSet<String> free) {
    return !peer.granted().containsAll(free)
        || !peer.counted().equals(counted(req, peer.granted()));
  }

  private void grant(Req req, Peers.Peer peer, SortedSet<String> sections) {
    SortedSet<String> all = Sections.union(peer.granted(), sections);
    peer.grant(sections, counted(req, all));
    boolean isWhole = peer.hasAll(req);
    SortedSet<String> isNew = sections.isEmpty() ? all : sections;
    effects.granted(req.from(), req.num(), isWhole ? Sections.NONE : isNew);
    send(req, peer);
  }

  private void send(Req req, Peers.Peer peer) {
    effects.send(
        peer.hasAll(req)
            ? new Ok(me, req.from(), req.num())
            : new Ok(
                me,
                req.from(),
                req.num(),
                Sections.without(peer.granted(), peer.counted()),
                peer.counted()));
  }

  private void answerPending() {
    for (Req req : peers.pending()) {
      Peers.Peer peer = peers.find(req.from());
      SortedSet<String> free = free(req);
      if (peer != null && !refuses(req.from()) && isNew(req, peer, free)) {
        grant(req, peer, free);
        peers.settle(req);
      }
    }
  }

  /** Reacts to a change of the needed answers during a request. */
  private void knownChanged() {
    SortedSet<ProcessId> now = known();
    effects.known(num, now);
    if (phase == Phase.TRYING) {
      // A participant that is no longer known need not answer, but it is told of releases.
      asked.replaceAll((other, lacking) -> now.contains(other) ? lacking : Sections.NONE);
      timers.needsOnly(missing());
      for (ProcessId other : now) {
        if (asked.putIfAbsent(other, Sections.copyOf(waiting)) == null) {
          sendRequest(other);
        }
      }
      enter();
    }
  }

  private void lookAtGhost(ProcessId peer) {
    if (view.ghost(peer) != null) {
      fences.look();
    }
  }

  private void sendRequests() {
    for (ProcessId other : missing()) {
      sendRequest(other);
    }
  }

  private void sendRequest(ProcessId other) {
    effects.send(
        new Req(
            me,
            other,
            num,
            admittedBy,
            ts,
            new MutexMessage.Wish(kind(), Sections.copyOf(waiting), inside())));
  }

  /** What it holds; if it resumes, also the limited sections that it asks for and its body is in. */
  private SortedSet<String> inside() {
    TreeSet<String> inside = new TreeSet<>(held);
    for (String section : resumes() ? resume.stands : Sections.NONE) {
      boolean fits = inside.size() + waiting.size() < Sections.MAX_COUNT;
      if (fits && Sections.isLimited(section) && waiting.contains(section)) {
        inside.add(section);
      }
    }
    return inside.size() == held.size() ? held : Sections.copyOf(inside);
  }

  private void tellRest() {
    for (ProcessId other : asked.keySet()) {
      effects.send(new Rem(me, other, num, want));
    }
  }

  /** The state without times: participants with equal texts behave alike. */
  String state() {
    StringBuilder text = new StringBuilder();
    text.append(clock.now()).append(' ').append(this);
    text.append(over ? " over " : " ").append(num).append(' ').append(ts);
    text.append(' ')
        .append(inOrder)
        .append(resume)
        .append(ahead)
        .append(behind)
        .append(asked)
        .append(sharers)
        .append(held)
        .append(waiting)
        .append(heard);
    return text.append(peers).append(fences).toString();
  }

  @Override
  public String toString() {
    return me + " " + phase + " " + want + " in view " + view.number();
  }

  /** Grants nothing to {@code suspect} from now on. */
  final void fenced(ProcessId suspect) {
    effects.fenced(suspect, peers.open(suspect));
  }
}
