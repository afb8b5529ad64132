package org.starl.primitives.mutex;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexMessage.Fence;
import org.starl.primitives.mutex.MutexMessage.FenceQ;
import org.starl.random.Rng;

/**
 * The fences of one participant: which participants it has fenced, and its part in their
 * confinement.
 *
 * <p>A participant that suspects f asks all participants, itself included, for a fence: a promise
 * never to grant f anything again, and the part of f's newest request that f may still hold with
 * the fencer's consent. The intersection of all answers bounds the sections of f, and is proposed
 * to the membership. Every fencer repeats its questions and proposals until f is not in the view,
 * because the first one to suspect f may crash. A fencer that knows a smaller bound for a ghost
 * than the view proposes it.
 */
final class Fences {

  /** The time from a question to a proposal with the answers so far; later rounds are longer. */
  private static final long ROUND_NS = 1_000_000_000;

  private static final long MAX_PAUSE_NS = 16 * ROUND_NS;

  /** One suspect that is still in the view. */
  private static final class Case {
    final long admittedBy;
    final SortedMap<ProcessId, SortedSet<String>> answers = new TreeMap<>();
    boolean hasAsked;
    long nextAtNs;
    long pauseNs = ROUND_NS;

    Case(long admittedBy, long nextAtNs) {
      this.admittedBy = admittedBy;
      this.nextAtNs = nextAtNs;
    }
  }

  private final MutexProtocol owner;
  private final MutexEffects effects;
  private final Rng rng;
  private final Set<ProcessId> fenced = new TreeSet<>();
  private final Map<ProcessId, Case> cases = new TreeMap<>();

  Fences(MutexProtocol owner, MutexEffects effects, Rng rng) {
    this.owner = owner;
    this.effects = effects;
    this.rng = rng;
  }

  /** Whether {@code id} is fenced; a fence is permanent. */
  boolean isFenced(ProcessId id) {
    return fenced.contains(id);
  }

  /** All fenced participants. */
  Set<ProcessId> all() {
    return Collections.unmodifiableSet(new TreeSet<>(fenced));
  }

  /** Begins to fence {@code suspect}, which is silent while its answer is needed. */
  void suspect(ProcessId suspect, long admittedBy, long nowNs) {
    if (!cases.containsKey(suspect)) {
      cases.put(suspect, new Case(admittedBy, nowNs));
      timer(nowNs);
    }
  }

  /** Answers a question with a fence, if this participant's consent is needed by the suspect. */
  void asked(FenceQ question, long nowNs) {
    ProcessId suspect = question.suspect();
    if (fence(suspect, question.admittedBy())) {
      effects.send(new Fence(owner.me(), question.from(), suspect, owner.open(suspect)));
      // At random and later than the asking one, so that not all propose at once.
      long firstNs = nowNs + 3 * ROUND_NS + rng.nextLong(0, 2 * ROUND_NS);
      if (!isRemoved(suspect, question.admittedBy())) {
        cases.computeIfAbsent(suspect, id -> new Case(question.admittedBy(), firstNs));
      }
    }
  }

  void answered(Fence fence) {
    Case open = cases.get(fence.suspect());
    if (open != null) {
      open.answers.merge(fence.from(), fence.open(), Sections::common);
      Set<ProcessId> silent = new TreeSet<>(owner.known());
      silent.removeAll(open.answers.keySet());
      silent.removeAll(cases.keySet());
      if (silent.isEmpty()) {
        propose(fence.suspect(), open);
      }
    }
  }

  /** A message from {@code id} ends the suspicion, unless a fence exists already. */
  void heardFrom(ProcessId id) {
    Case open = cases.get(id);
    if (open != null && open.answers.isEmpty() && !fenced.contains(id)) {
      cases.remove(id);
    }
  }

  /** Reacts to a new view, or to a message about a ghost. */
  void look() {
    cases.entrySet().removeIf(entry -> isRemoved(entry.getKey(), entry.getValue().admittedBy));
    owner.view().ghosts().forEach(this::shrink);
  }

  /** Stops questions and proposals, because they no longer count. The fences stay. */
  void end() {
    cases.clear();
  }

  long wakeAtNs() {
    long earliestNs = Long.MAX_VALUE;
    for (Case open : cases.values()) {
      earliestNs = Math.min(earliestNs, open.nextAtNs);
    }
    return earliestNs;
  }

  void timer(long nowNs) {
    for (Map.Entry<ProcessId, Case> entry : new ArrayList<>(cases.entrySet())) {
      Case open = entry.getValue();
      if (nowNs >= open.nextAtNs) {
        if (open.hasAsked) {
          propose(entry.getKey(), open);
          open.pauseNs = Math.min(2 * open.pauseNs, MAX_PAUSE_NS);
        }
        open.nextAtNs = nowNs + open.pauseNs + rng.nextLong(0, open.pauseNs);
        ask(entry.getKey(), open);
      }
    }
  }

  private void ask(ProcessId suspect, Case open) {
    open.hasAsked = true;
    fence(suspect, open.admittedBy);
    for (ProcessId other : owner.known()) {
      if (!other.equals(suspect)) {
        effects.send(new FenceQ(owner.me(), other, suspect, open.admittedBy));
      }
    }
    if (owner.known().equals(Set.of(suspect))) {
      propose(suspect, open); // there is no other participant to ask
    }
  }

  /** Fences {@code suspect} if it needs this participant's consent; returns whether it does. */
  private boolean fence(ProcessId suspect, long admittedBy) {
    boolean counts = !suspect.equals(owner.me()) && owner.hasSayOver(suspect, admittedBy);
    if (counts && fenced.add(suspect)) {
      owner.fenced(suspect);
    }
    return counts;
  }

  /** Proposes the intersection of the answers of all participants in the view. */
  private void propose(ProcessId suspect, Case open) {
    SortedMap<ProcessId, SortedSet<String>> answers = new TreeMap<>(open.answers);
    if (fenced.contains(suspect)) {
      answers.put(owner.me(), owner.open(suspect));
    }
    answers.keySet().removeIf(fencer -> !owner.view().contains(fencer));
    answers.values().stream()
        .reduce(Sections::common)
        .ifPresent(bound ->
            effects.propose(new Confinement(suspect, bound, new TreeSet<>(answers.keySet()))));
  }

  /** Proposes a smaller bound for a ghost, if this participant knows one. */
  private void shrink(ProcessId suspect, View.Ghost ghost) {
    SortedSet<String> open = owner.open(suspect);
    if (!open.containsAll(ghost.sections()) && fence(suspect, ghost.admittedBy())) {
      effects.propose(new Confinement(suspect, open, new TreeSet<>(Set.of(owner.me()))));
    }
  }

  /** Whether the view is late enough to contain {@code suspect}, and does not. */
  private boolean isRemoved(ProcessId suspect, long admittedBy) {
    return owner.view().number() >= admittedBy && !owner.view().contains(suspect);
  }

  /** The state without times: equal texts behave alike. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder().append(fenced);
    cases.forEach((id, open) -> text.append(id).append(open.answers).append(open.hasAsked));
    return text.toString();
  }
}
