package org.starl.primitives.mutex;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.ProcessId;
import org.starl.comms.LamportClock;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexMessage.Ok;
import org.starl.primitives.mutex.MutexMessage.Rem;
import org.starl.primitives.mutex.MutexMessage.Req;

/**
 * One participant of the mutex: Ricart and Agrawala ("An optimal algorithm for mutual exclusion in
 * computer networks", CACM 1981) on sets of sections, among participants that come and go. Pure and
 * clock-driven: (state, message or timer or call) to messages and outcomes. Its methods are named as
 * the model's actions.
 *
 * <p>The rule of membership is the heart of it. A process requests only when it has learned a view
 * that lists it. It needs the answers of everybody in its latest view, and of everybody that it
 * heard a request from who was admitted by a view later than that; it stops needing an answer only
 * through a learned view that lists itself and not the other. So of two participants the younger one
 * has a view with the elder in it, and asks; the elder learns of it by being asked, and asks back.
 */
class MutexProtocol {

  private static final long NS_PER_MS = 1_000_000;

  /** What a process does with the sections that it named last. */
  enum Phase {
    IDLE,
    TRYING,
    CRITICAL
  }

  /** Takes messages and outcomes, inside the call that brings them about; must not call back. */
  interface Effects {

    void send(MutexMessage message);

    /** A request begins, and {@code known} is whom it needs. */
    void requested(long num, long ts, SortedSet<String> want, SortedSet<ProcessId> known);

    /** Whom the current request needs, or would need if it began now, has changed to this. */
    void known(long num, SortedSet<ProcessId> known);

    /** Request {@code num} of {@code to} is granted for the first time. */
    void granted(ProcessId to, long num);

    void entered(long num, SortedSet<String> held);

    void released(long num, SortedSet<String> given, SortedSet<String> left);

    /** The request ended without access; number 0 if it did not even begin. */
    void failed(long num, MutexFailure why);
  }

  /** What is remembered of another participant: its newest request, and what became of it. */
  private static final class Peer {
    private long seen;
    private boolean granted;
    private boolean done;
    // The part of what was granted that the other may still hold.
    private SortedSet<String> open = Sections.NONE;

    private void isNowAt(long num) {
      seen = num;
      granted = false;
      done = false;
      open = Sections.NONE;
    }
  }

  private final ProcessId me;
  private final LamportClock clock;
  private final MutexTimes times;
  private final Effects effects;

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
  private long deadlineNs = Long.MAX_VALUE;
  private long resendAtNs = Long.MAX_VALUE;
  private long resendNs;

  // Those heard from that were admitted after the latest view, with the number of that view.
  private final TreeMap<ProcessId, Long> heard = new TreeMap<>();
  private final TreeMap<ProcessId, Peer> peers = new TreeMap<>();
  private final Map<ProcessId, Req> pending = new LinkedHashMap<>();

  MutexProtocol(ProcessId me, LamportClock clock, MutexTimes times, Effects effects) {
    this.me = me;
    this.clock = clock;
    this.times = times;
    this.effects = effects;
  }

  ProcessId me() {
    return me;
  }

  Phase phase() {
    return phase;
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
    return phase == Phase.TRYING ? Math.min(deadlineNs, resendAtNs) : Long.MAX_VALUE;
  }

  /** Whether it stands in the latest view that it learned, and may go on requesting. */
  boolean mayRequest() {
    return !over && view.contains(me);
  }

  /**
   * The part of {@code peer}'s newest request that this process granted and that {@code peer} may
   * still hold.
   */
  SortedSet<String> open(ProcessId peer) {
    Peer known = peers.get(peer);
    return known == null ? Sections.NONE : known.open;
  }

  /** Everybody whose answer a request needs now. */
  SortedSet<ProcessId> known() {
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
    deadlineNs = nowNs + times.deadlineMs() * NS_PER_MS;
    resendNs = times.resendMs() * NS_PER_MS;
    resendAtNs = nowNs + resendNs;
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
  }

  /** Gives up what it waits for; if it does not wait, nothing. */
  void withdraw(MutexFailure why) {
    if (phase != Phase.TRYING) {
      return;
    }
    phase = Phase.IDLE;
    want = Sections.NONE;
    missing.clear();
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
  }

  /** Learns a view, if it is later than the one known; numbers may be skipped. */
  void learn(View later) {
    if (later.number() <= view.number()) {
      return;
    }
    view = later;
    heard.values().removeIf(by -> by <= view.number());
    forgetTheGone();
    if (view.contains(me)) {
      admittedBy = view.admittedBy(me);
    } else if (admittedBy > 0) {
      removed();
    }
    if (phase != Phase.IDLE) {
      knownChanged();
    }
  }

  /** Repeats the request, or gives it up, if it is time. */
  void timer(long nowNs) {
    if (phase != Phase.TRYING) {
      return;
    }
    if (nowNs >= deadlineNs) {
      withdraw(MutexFailure.DEADLINE);
    } else if (nowNs >= resendAtNs) {
      double longerNs = (double) resendNs * times.backoff();
      resendNs = Math.min((long) longerNs, times.maxResendMs() * NS_PER_MS);
      resendAtNs = nowNs + resendNs;
      sendRequests();
    }
  }

  // --------------------------------------------------------------- messages

  /** Takes a message whose addressee is this participant. */
  final void receive(MutexMessage message) {
    if (!message.to().equals(me) || message.from().equals(me)) {
      throw new IllegalArgumentException(message + " is not for " + me);
    }
    switch (message) {
      case Req req -> hear(req);
      case Ok ok -> hearOk(ok);
      case Rem rem -> hearRem(rem);
    }
  }

  private void hear(Req req) {
    witness(req.ts());
    noteHeard(req.from(), req.admittedBy());
    Peer peer = peers.computeIfAbsent(req.from(), id -> new Peer());
    if (req.num() < peer.seen || (req.num() == peer.seen && peer.done)) {
      return; // stale or withdrawn: never answered
    }
    if (req.num() > peer.seen) {
      peer.isNowAt(req.num());
      pending.remove(req.from());
    }
    if (peer.granted) {
      effects.send(new Ok(me, req.from(), req.num()));
    } else if (keepsBack(req)) {
      pending.put(req.from(), req);
    } else {
      grant(req, peer);
    }
  }

  private void hearOk(Ok ok) {
    if (phase == Phase.TRYING && answersMyRequest(ok) && missing.remove(ok.from())) {
      enter();
    }
  }

  private void hearRem(Rem rem) {
    Peer peer = peers.computeIfAbsent(rem.from(), id -> new Peer());
    if (rem.num() > peer.seen && rem.left().isEmpty()) {
      peer.isNowAt(rem.num());
      peer.done = true;
      pending.remove(rem.from());
    } else if (rem.num() == peer.seen) {
      peer.open = Sections.common(peer.open, rem.left());
      if (rem.left().isEmpty()) {
        peer.done = true;
        pending.remove(rem.from());
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

  /** Logical clocks: whoever hears of a request requests later than it. */
  void witness(long otherTs) {
    clock.witness(otherTs);
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

  /** A view without this participant came after one with it. */
  void removed() {
    over = true;
    withdraw(MutexFailure.REMOVED);
  }

  static boolean isBefore(long ts, ProcessId id, long otherTs, ProcessId other) {
    return ts < otherTs || (ts == otherTs && id.compareTo(other) < 0);
  }

  // ------------------------------------------------------------------ steps

  private void enter() {
    if (phase == Phase.TRYING && hasAllAnswers()) {
      phase = Phase.CRITICAL;
      effects.entered(num, want);
    }
  }

  private void grant(Req req, Peer peer) {
    peer.granted = true;
    peer.open = req.want();
    effects.granted(req.from(), req.num());
    effects.send(new Ok(me, req.from(), req.num()));
  }

  private void answerPending() {
    List<Req> waiting = new ArrayList<>(pending.values());
    for (Req req : waiting) {
      Peer peer = peers.get(req.from());
      if (peer != null && !keepsBack(req)) {
        pending.remove(req.from());
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
      for (ProcessId other : now) {
        if (asked.add(other)) {
          missing.add(other);
          sendRequest(other);
        }
      }
      enter();
    }
  }

  // Who has left is idle for ever or dead: nothing it asked is open, and what it sends late is
  // answered like anything else, which binds nobody.
  private void forgetTheGone() {
    peers.keySet().removeIf(this::isGone);
    pending.keySet().removeIf(this::isGone);
  }

  private boolean isGone(ProcessId other) {
    return !view.contains(other) && !heard.containsKey(other);
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
   * Everything that its messages and outcomes will depend on, but for times: participants with equal
   * texts behave alike.
   */
  String state() {
    StringBuilder text = new StringBuilder();
    text.append(clock.now()).append(' ').append(this);
    text.append(over ? " over " : " ").append(num).append(' ').append(ts);
    text.append(' ').append(asked).append(missing).append(heard);
    peers.forEach((id, peer) ->
        text.append(' ')
            .append(id)
            .append(':')
            .append(peer.seen)
            .append(peer.granted ? "g" : "")
            .append(peer.done ? "d" : "")
            .append(peer.open));
    return text.append(' ').append(pending).toString();
  }

  @Override
  public String toString() {
    return me + " " + phase + " " + want + " in view " + view.number();
  }
}
