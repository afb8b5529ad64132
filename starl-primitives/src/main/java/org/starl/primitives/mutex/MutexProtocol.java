package org.starl.primitives.mutex;

import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
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
 * {@code RicartAgrawala_decls} have the names of its methods.
 *
 * <p>The main rule concerns membership. A participant requests only after it has learned a view
 * that lists it. It needs the answers of all participants in its latest view, and of all
 * participants that were admitted by a later view and sent it a request. It stops needing an answer
 * only after it has learned a view that lists itself and not the other. So of two participants the
 * younger has a view that lists the elder, and asks it; the elder learns of the younger by its
 * request, and asks back.
 */
class MutexProtocol {

  /** The phase of the latest request. */
  enum Phase {
    IDLE,
    TRYING,
    CRITICAL
  }

  /** A participant's identity and resources. */
  record Self(ProcessId me, LamportClock clock, MutexTimes times, Rng rng, boolean canConfine) {}

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
  private SortedSet<String> want = Sections.NONE;
  // The receivers of the current request, and those of them whose needed answer is missing.
  private final TreeSet<ProcessId> asked = new TreeSet<>();
  private final TreeSet<ProcessId> missing = new TreeSet<>();
  private final RequestTimers timers;

  // Participants that sent a request and were admitted by a view later than mine, and its number.
  private final TreeMap<ProcessId, Long> heard = new TreeMap<>();
  private final Peers peers = new Peers();
  private final Fences fences;

  MutexProtocol(Self self, MutexEffects effects) {
    this.me = self.me();
    this.clock = self.clock();
    this.canConfine = self.canConfine();
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
    return phase == Phase.CRITICAL ? want : Sections.NONE;
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

  /** The participants whose needed answers are missing. */
  SortedSet<ProcessId> missing() {
    return new TreeSet<>(missing);
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
    if (phase != Phase.IDLE) {
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
    num++;
    ts = clock.tick();
    want = sections;
    phase = Phase.TRYING;
    asked.clear();
    asked.addAll(known());
    missing.addAll(asked);
    timers.begin(nowNs);
    effects.requested(num, ts, want, asked);
    sendRequests();
    enter();
  }

  /** Releases {@code sections}, which it must hold. */
  void release(SortedSet<String> sections) {
    if (sections.isEmpty() || !held().containsAll(sections)) {
      throw new IllegalArgumentException("release of " + sections + " while holding " + held());
    }
    want = Sections.without(want, sections);
    if (want.isEmpty()) {
      phase = Phase.IDLE;
    }
    effects.released(num, sections, want);
    tellRest();
    answerPending();
    if (over && phase == Phase.IDLE) {
      effects.markIdle();
    }
  }

  /** Cancels a waiting request; no effect without one. */
  void withdraw(MutexFailure why) {
    if (phase != Phase.TRYING) {
      return;
    }
    phase = Phase.IDLE;
    want = Sections.NONE;
    missing.clear();
    timers.needsOnly(missing);
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
      withdraw(missing.isEmpty() ? MutexFailure.OCCUPIED : MutexFailure.DEADLINE);
    } else if (phase == Phase.TRYING && timers.resends(nowNs)) {
      goOnWaiting(nowNs);
    }
    fences.timer(nowNs);
  }

  /** Suspects {@code peer}, whose answer it needs, of a crash; it may be wrong. */
  final void suspect(ProcessId peer, long nowNs) {
    if (canConfine && missing.contains(peer) && mayRequest()) {
      Long by = heard.get(peer);
      fences.suspect(peer, by == null ? view.admittedBy(peer) : by, nowNs);
    }
  }

  private void goOnWaiting(long nowNs) {
    if (missing.isEmpty() && isOccupied() && timers.isGhostTimeOver(nowNs)) {
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
      case Noted noted -> {
        // It only shows that its sender is alive.
      }
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
    if (peer.isGranted()) {
      effects.send(new Ok(me, req.from(), req.num()));
    } else if (refuses(req.from())) {
      effects.send(new Fenced(me, req.from()));
    } else if (defers(req)) {
      if (peers.defer(req)) {
        effects.send(new Noted(me, req.from(), req.num()));
      }
    } else {
      grant(req, peer);
    }
    lookAtGhost(req.from());
  }

  private void hearOk(Ok ok) {
    if (phase == Phase.TRYING && answersMyRequest(ok) && missing.remove(ok.from())) {
      timers.needsOnly(missing);
      enter();
    }
  }

  private void hearRem(Rem rem) {
    peers.hearRem(rem);
    lookAtGhost(rem.from());
  }

  /** Another participant has fenced this one, so it never gets all needed answers. */
  private void hearFenced() {
    if (mayRequest()) {
      over = true;
      fences.end();
      withdraw(MutexFailure.FENCED);
      if (phase == Phase.IDLE) {
        effects.markIdle();
      }
    }
  }

  // ------------------------------------------------------------------ rules

  /** Whether it defers its answer to {@code req}. */
  boolean defers(Req req) {
    return phase != Phase.IDLE
        && Sections.meet(want, req.want())
        // A holder defers every request: a new participant's clock may be low.
        && (phase == Phase.CRITICAL || isBefore(ts, me, req.ts(), req.from()));
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

  /** Whether all needed answers have arrived. */
  boolean hasAllAnswers() {
    return missing.isEmpty();
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

  /** Whether a ghost of another robot may be in a wanted section. */
  boolean isOccupied() {
    return view.ghosts().entrySet().stream()
        .anyMatch(ghost ->
            !ghost.getKey().robot().equals(me.robot())
                && Sections.meet(ghost.getValue().sections(), want));
  }

  static boolean isBefore(long ts, ProcessId id, long otherTs, ProcessId other) {
    return ts < otherTs || (ts == otherTs && id.compareTo(other) < 0);
  }

  // ------------------------------------------------------------------ steps

  /** Enters if possible; called after every change that may allow it. */
  final void enter() {
    if (phase == Phase.TRYING && hasAllAnswers() && !isOccupied()) {
      phase = Phase.CRITICAL;
      effects.entered(num, want);
    }
  }

  private void grant(Req req, Peers.Peer peer) {
    peers.grant(req, peer);
    effects.granted(req.from(), req.num());
    effects.send(new Ok(me, req.from(), req.num()));
  }

  private void answerPending() {
    for (Req req : peers.takePending(each -> !defers(each))) {
      Peers.Peer peer = peers.find(req.from());
      if (peer != null && !refuses(req.from())) {
        grant(req, peer);
      }
    }
  }

  /** Reacts to a change of the needed answers during a request. */
  private void knownChanged() {
    SortedSet<ProcessId> now = known();
    effects.known(num, now);
    if (phase == Phase.TRYING) {
      missing.retainAll(now);
      timers.needsOnly(missing);
      for (ProcessId other : now) {
        if (asked.add(other)) {
          missing.add(other);
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
    for (ProcessId other : missing) {
      sendRequest(other);
    }
  }

  private void sendRequest(ProcessId other) {
    effects.send(new Req(me, other, num, admittedBy, ts, want));
  }

  private void tellRest() {
    for (ProcessId other : asked) {
      effects.send(new Rem(me, other, num, want));
    }
  }

  /** The state without times: participants with equal texts behave alike. */
  String state() {
    StringBuilder text = new StringBuilder();
    text.append(clock.now()).append(' ').append(this);
    text.append(over ? " over " : " ").append(num).append(' ').append(ts);
    text.append(' ').append(asked).append(missing).append(heard);
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
