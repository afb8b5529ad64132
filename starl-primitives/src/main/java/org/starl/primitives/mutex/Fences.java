package org.starl.primitives.mutex;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
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
 * Whom one participant has given up, and its part in having them confined.
 *
 * <p>Who suspects f asks everybody, itself included, for a fence: for the vow never to grant f
 * anything again, and for the part of f's newest request that f may still hold by the fencer's
 * consent. What all the answers have in common bounds what f holds, and that is proposed. Whoever
 * has vowed goes on asking and proposing until a view is without f, for the first to suspect it may
 * die; and whoever knows less of a ghost than the view says proposes that.
 */
final class Fences {

  /** From a question to a proposal with the answers that are there; then longer and longer. */
  private static final long ROUND_NS = 1_000_000_000;

  private static final long MAX_PAUSE_NS = 16 * ROUND_NS;

  /** The participant whose fences these are. */
  interface Owner {

    ProcessId me();

    View view();

    /** Everybody whose answer a request needs now. */
    SortedSet<ProcessId> known();

    /** Whether {@code suspect}, admitted by that view, cannot enter without this one's consent. */
    boolean hasSayOver(ProcessId suspect, long admittedBy);

    /**
     * The part of {@code suspect}'s newest request that it may still hold by this one's consent.
     */
    SortedSet<String> open(ProcessId suspect);

    /** From now on nothing is granted to {@code suspect}. */
    void fenced(ProcessId suspect);

    void send(MutexMessage message);

    void propose(Confinement confinement);
  }

  /** One suspect that no view is without yet. */
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

  private final Owner owner;
  private final Rng rng;
  private final Set<ProcessId> fenced = new TreeSet<>();
  private final Map<ProcessId, Case> cases = new TreeMap<>();

  Fences(Owner owner, Rng rng) {
    this.owner = owner;
    this.rng = rng;
  }

  /** Whether {@code id} is given up: for ever. */
  boolean isFenced(ProcessId id) {
    return fenced.contains(id);
  }

  /** All that are given up. */
  Set<ProcessId> all() {
    return Collections.unmodifiableSet(new TreeSet<>(fenced));
  }

  /** {@code suspect} says nothing, and its answer is needed. */
  void suspect(ProcessId suspect, long admittedBy, long nowNs) {
    if (!cases.containsKey(suspect)) {
      cases.put(suspect, new Case(admittedBy, nowNs));
      timer(nowNs);
    }
  }

  /** Somebody suspects {@code question}'s suspect: vows, if its own word counts. */
  void asked(FenceQ question, long nowNs) {
    ProcessId suspect = question.suspect();
    if (vow(suspect, question.admittedBy())) {
      owner.send(new Fence(owner.me(), question.from(), suspect, owner.open(suspect)));
      // At random and later than who asks, so that not all propose at once.
      long firstNs = nowNs + 3 * ROUND_NS + rng.nextLong(0, 2 * ROUND_NS);
      if (!isOut(suspect, question.admittedBy())) {
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

  /** A message has come from {@code id}: nothing is wrong, unless somebody has vowed already. */
  void heardFrom(ProcessId id) {
    Case open = cases.get(id);
    if (open != null && open.answers.isEmpty() && !fenced.contains(id)) {
      cases.remove(id);
    }
  }

  /** The view has changed, or what is known of a ghost. */
  void look() {
    cases.entrySet().removeIf(entry -> isOut(entry.getKey(), entry.getValue().admittedBy));
    owner.view().ghosts().forEach(this::shrink);
  }

  /** Asks and proposes no more: its word does not count any longer. Its vows stay. */
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
    vow(suspect, open.admittedBy);
    for (ProcessId other : owner.known()) {
      if (!other.equals(suspect)) {
        owner.send(new FenceQ(owner.me(), other, suspect, open.admittedBy));
      }
    }
    if (owner.known().equals(Set.of(suspect))) {
      propose(suspect, open); // there is nobody else to ask
    }
  }

  private boolean vow(ProcessId suspect, long admittedBy) {
    boolean counts = !suspect.equals(owner.me()) && owner.hasSayOver(suspect, admittedBy);
    if (counts && fenced.add(suspect)) {
      owner.fenced(suspect);
    }
    return counts;
  }

  /** Proposes what the answers say; those of participants that are gone say nothing. */
  private void propose(ProcessId suspect, Case open) {
    SortedMap<ProcessId, SortedSet<String>> words = new TreeMap<>(open.answers);
    if (fenced.contains(suspect)) {
      words.put(owner.me(), owner.open(suspect));
    }
    words.keySet().removeIf(fencer -> !owner.view().contains(fencer));
    List<SortedSet<String>> bounds = new ArrayList<>(words.values());
    if (!bounds.isEmpty()) {
      SortedSet<String> least = bounds.stream().reduce(Sections::common).orElse(Sections.NONE);
      owner.propose(new Confinement(suspect, least, new TreeSet<>(words.keySet())));
    }
  }

  /** Vouches for less, where this one knows that the ghost holds less than the view says. */
  private void shrink(ProcessId suspect, View.Ghost ghost) {
    SortedSet<String> open = owner.open(suspect);
    if (!open.containsAll(ghost.sections()) && vow(suspect, ghost.admittedBy())) {
      owner.propose(new Confinement(suspect, open, new TreeSet<>(Set.of(owner.me()))));
    }
  }

  /** Whether the view knows {@code suspect}, and as somebody who is not free. */
  private boolean isOut(ProcessId suspect, long admittedBy) {
    return owner.view().number() >= admittedBy && !owner.view().contains(suspect);
  }

  /** Everything that it will do depends on this, but for times. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder().append(fenced);
    cases.forEach((id, open) -> text.append(id).append(open.answers).append(open.hasAsked));
    return text.toString();
  }
}
