package org.starl.primitives.mutex;

import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.comms.LamportClock;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.Confinement;
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
 * computer networks", CACM 1981) on sets of sections, among participants that come and go. Pure and
 * clock-driven: (state, message or timer or call) to messages and outcomes. The actions of
 * the theory {@code RicartAgrawala_decls} are named for its methods.
 *
 * <p>The rule of membership is the heart of it. A process requests only when it has learned a view
 * that lists it. It needs the answers of everybody in its latest view, and of everybody that it
 * heard a request from who was admitted by a view later than that; it stops needing an answer only
 * through a learned view that lists itself and not the other. So of two participants the younger
 * one has a view with the elder in it, and asks; the elder learns of it by being asked, and asks
 * back.
 */
class MutexProtocol implements Fences.Owner {

  /** What a process does with the sections that it named last. */
  enum Phase {
    IDLE,
    TRYING,
    CRITICAL
  }

  /** Who a participant is, and what it works with. */
  record Self(ProcessId me, LamportClock clock, MutexTimes times, Rng rng, boolean canConfine) {}

  private final ProcessId me;
  private final LamportClock clock;
  private final boolean canConfine;
  private final MutexEffects effects;

  private View view = View.NONE;
  // The view that admitted me; 0: none that I have learned.
  private long admittedBy;
  private boolean over;

  private Phase phase = Phase.IDLE;
  private long num;
  private long ts;
  private SortedSet<String> want = Sections.NONE;
  // Whom the current request was sent to, and those of them whose answer is needed and not there.
  private final TreeSet<ProcessId> asked = new TreeSet<>();
  private final TreeSet<ProcessId> missing = new TreeSet<>();
  private final Patience patience;

  // Those heard from that were admitted after the latest view, with the number of that view.
  private final TreeMap<ProcessId, Long> heard = new TreeMap<>();
  private final Peers peers = new Peers();
  private final Fences fences;

  MutexProtocol(Self self, MutexEffects effects) {
    this.me = self.me();
    this.clock = self.clock();
    this.canConfine = self.canConfine();
    this.effects = effects;
    this.fences = new Fences(this, self.rng());
    this.patience = new Patience(self.times());
  }

  @Override
  public ProcessId me() {
    return me;
  }

  Phase phase() {
    return phase;
  }

  @Override
  public View view() {
    return view;
  }

  /** The logical time of its newest request. */
  long ts() {
    return ts;
  }

  /** What it has access to. */
  SortedSet<String> held() {
    return phase == Phase.CRITICAL ? want : Sections.NONE;
  }

  /** When {@link #timer} has something to do; {@code Long.MAX_VALUE}: never. */
  long nextTimerNs() {
    long requestNs = phase == Phase.TRYING ? patience.wakeAtNs() : Long.MAX_VALUE;
    return Math.min(requestNs, fences.wakeAtNs());
  }

  /** Whether it stands in the latest view that it learned, and may go on requesting. */
  boolean mayRequest() {
    return !over && view.contains(me);
  }

  /** Those to whom it must never grant anything, also when all else of it is forgotten. */
  Set<ProcessId> fenced() {
    return fences.all();
  }

  /** Those whose answers are needed and not there. */
  SortedSet<ProcessId> missing() {
    return new TreeSet<>(missing);
  }

  /**
   * The part of {@code peer}'s newest request that this process granted and that {@code peer} may
   * still hold.
   */
  @Override
  public SortedSet<String> open(ProcessId peer) {
    return peers.open(peer);
  }

  /** Everybody whose answer a request needs now. */
  @Override
  public SortedSet<ProcessId> known() {
    TreeSet<ProcessId> all = new TreeSet<>(view.admitted().keySet());
    all.addAll(heard.keySet());
    all.remove(me);
    return all;
  }

  // ------------------------------------------------------------------ calls

  /** {@code do_mutex}: asks everybody known for {@code sections}, or fails at once. */
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
    missing.clear();
    missing.addAll(asked);
    patience.begin(nowNs);
    effects.requested(num, ts, want, asked);
    sendRequests();
    enter();
  }

  /** Gives back {@code sections}, all of which it holds. */
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

  /** Gives up what it waits for; if it does not wait, nothing. */
  void withdraw(MutexFailure why) {
    if (phase != Phase.TRYING) {
      return;
    }
    phase = Phase.IDLE;
    want = Sections.NONE;
    missing.clear();
    patience.needsOnly(missing);
    effects.failed(num, why);
    tellRest();
    answerPending();
  }

  /** Never requests again; goes on answering. It must be idle: others may forget it from now on. */
  void beginLeave() {
    if (phase != Phase.IDLE) {
      throw new IllegalStateException("leaves while " + phase + " for " + want);
    }
    over = true;
    fences.end();
  }

  /** Learns a view, if it is later than the one known; numbers may be skipped. */
  void learn(View later) {
    if (later.number() <= view.number()) {
      return;
    }
    view = later;
    effects.learned(view);
    heard.values().removeIf(by -> by <= view.number());
    // Who has left is idle for ever or dead: nothing it asked is open, and what it sends late is
    // answered like anything else, which binds nobody. A ghost may still shrink.
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

  /** Repeats the request, or gives it up, or goes on with whom it suspects, if it is time. */
  void timer(long nowNs) {
    if (phase == Phase.TRYING && patience.isOver(nowNs)) {
      withdraw(missing.isEmpty() ? MutexFailure.OCCUPIED : MutexFailure.DEADLINE);
    } else if (phase == Phase.TRYING && patience.resends(nowNs)) {
      goOnWaiting(nowNs);
    }
    fences.timer(nowNs);
  }

  /** Takes {@code peer}, whose answer it needs, for crashed; it may be wrong. */
  final void suspect(ProcessId peer, long nowNs) {
    if (canConfine && missing.contains(peer) && mayRequest()) {
      Long by = heard.get(peer);
      fences.suspect(peer, by == null ? view.admittedBy(peer) : by, nowNs);
    }
  }

  private void goOnWaiting(long nowNs) {
    if (missing.isEmpty() && isOccupied() && patience.isOverForGhosts(nowNs)) {
      withdraw(MutexFailure.OCCUPIED);
      return;
    }
    sendRequests();
    if (canConfine && !missing.isEmpty()) {
      patience.silent(missing, nowNs).forEach(peer -> suspect(peer, nowNs));
      if (patience.wantsNews()) {
        effects.refresh();
      }
    }
  }

  // --------------------------------------------------------------- messages

  /** Takes a message whose addressee is this participant. */
  final void receive(MutexMessage message, long nowNs) {
    if (!message.to().equals(me) || message.from().equals(me)) {
      throw new IllegalArgumentException(message + " is not for " + me);
    }
    patience.heard(message.from(), nowNs);
    fences.heardFrom(message.from());
    switch (message) {
      case Req req -> hear(req);
      case Ok ok -> hearOk(ok);
      case Rem rem -> hearRem(rem);
      case Noted noted -> {
        // That it has come says all: its sender is alive.
      }
      case FenceQ question -> fences.asked(question, nowNs);
      case Fence fence -> fences.answered(fence);
      case Fenced fenced -> givenUp();
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
    } else if (keepsBack(req)) {
      if (peers.keepBack(req)) {
        effects.send(new Noted(me, req.from(), req.num()));
      }
    } else {
      grant(req, peer);
    }
    lookAtGhost(req.from());
  }

  private void hearOk(Ok ok) {
    if (phase == Phase.TRYING && answersMyRequest(ok) && missing.remove(ok.from())) {
      patience.needsOnly(missing);
      enter();
    }
  }

  private void hearRem(Rem rem) {
    peers.hearRem(rem);
    lookAtGhost(rem.from());
  }

  /** Others have given me up, as crashed: I shall never get all the answers that I need. */
  private void givenUp() {
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

  /** Whether it does not grant {@code req} now. */
  boolean keepsBack(Req req) {
    return phase != Phase.IDLE
        && Sections.meet(want, req.want())
        // By rule, not by clock: a newcomer's clock may be low.
        && (phase == Phase.CRITICAL || isBefore(ts, me, req.ts(), req.from()));
  }

  /** Whether it grants {@code peer} nothing, ever. */
  boolean refuses(ProcessId peer) {
    return fences.isFenced(peer) || view.ghost(peer) != null;
  }

  /**
   * Whether {@code suspect} cannot enter without my consent: because every view that lists it lists
   * me, or because it has asked me.
   */
  @Override
  public boolean hasSayOver(ProcessId suspect, long itsAdmittedBy) {
    return mayRequest() && (admittedBy <= itsAdmittedBy || peers.hasAsked(suspect));
  }

  /** Logical clocks: whoever hears of a request requests later than it. */
  void witness(long otherTs) {
    clock.advanceTo(otherTs);
  }

  /** Whether {@code ok} counts for the current request. */
  boolean answersMyRequest(Ok ok) {
    return ok.num() == num;
  }

  /** Whoever was admitted after my latest view and asks me has to be asked by me. */
  void noteHeard(ProcessId other, long otherAdmittedBy) {
    if (otherAdmittedBy > view.number()
        && heard.put(other, otherAdmittedBy) == null
        && phase != Phase.IDLE) {
      knownChanged();
    }
  }

  /** Whether every answer that it needs is there. */
  boolean hasAllAnswers() {
    return missing.isEmpty();
  }

  /** A view without this participant, or with its ghost, came after one with it. */
  void removed() {
    boolean isNew = !over;
    over = true;
    fences.end();
    withdraw(MutexFailure.REMOVED);
    if (isNew && phase == Phase.IDLE) {
      effects.markIdle();
    }
  }

  /** Whether a ghost may stand in a section that is wanted; my own robot does not block itself. */
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

  /** Enters, if nothing is in the way; called whenever something may have gone out of it. */
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
    for (Req req : peers.takePending(each -> !keepsBack(each))) {
      Peers.Peer peer = peers.find(req.from());
      if (peer != null && !refuses(req.from())) {
        grant(req, peer);
      }
    }
  }

  /** The view, or who was heard, has changed during a request. */
  private void knownChanged() {
    SortedSet<ProcessId> now = known();
    effects.known(num, now);
    if (phase == Phase.TRYING) {
      missing.retainAll(now);
      patience.needsOnly(missing);
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

  /**
   * Everything that its messages and outcomes will depend on, but for times: participants with
   * equal texts behave alike.
   */
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

  // ------------------------------------------------------ what its fences do

  @Override
  public final void fenced(ProcessId suspect) {
    peers.dropPending(suspect);
    effects.fenced(suspect, peers.open(suspect));
  }

  @Override
  public final void send(MutexMessage message) {
    effects.send(message);
  }

  @Override
  public final void propose(Confinement confinement) {
    effects.propose(confinement);
  }
}
