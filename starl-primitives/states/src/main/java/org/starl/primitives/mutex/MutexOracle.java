package org.starl.primitives.mutex;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;

/** The mutex's invariants over the participants' states, independent of the monitors. */
final class MutexOracle {

  /** Of the exploration alone: a circle stays until a process withdraws. */
  static final String CIRCLE = "mutex.Circle";

  private MutexOracle() {}

  /**
   * The violations of invariants, each with its lemma's name first.
   *
   * @param last the view that was decided last, even if no participant has learned it
   */
  static List<String> violations(List<MutexNode> nodes, View last) {
    List<MutexNode> active = new ArrayList<>(nodes);
    active.removeIf(node -> !node.isActive());
    List<Set<ProcessId>> known = new ArrayList<>();
    active.forEach(node -> known.add(node.protocol.known()));
    List<String> found = new ArrayList<>();
    for (MutexNode i : nodes) {
      for (MutexNode j : nodes) {
        // A restarted robot may hold the sections of its own ghost.
        if (!i.id.robot().equals(j.id.robot()) && Sections.exclude(i.held(), j.held())) {
          found.add(MutexSpec.EXCLUSIVE + ": " + i.protocol + " and " + j.protocol);
        }
      }
      for (String section : i.held()) {
        long robots =
            nodes.stream()
                .filter(j -> j.held().contains(section))
                .map(j -> j.id.robot())
                .distinct()
                .count();
        if (robots > Sections.capacity(section)) {
          found.add(MutexSpec.CAPACITY + ": " + robots + " robots in " + section);
        }
      }
      View.Ghost ghost = last.ghost(i.id);
      SortedSet<String> atMost = ghost == null ? Sections.NONE : ghost.sections();
      if (!last.contains(i.id) && !atMost.containsAll(i.held())) {
        found.add(MutexSpec.KEPT + ": " + i.protocol + " in " + last);
      }
    }
    active.stream()
        .filter(node -> isInCircle(node, active))
        .forEach(node -> found.add(CIRCLE + ": " + node.protocol + " waits for itself"));
    for (int a = 0; a < active.size(); a++) {
      for (int b = 0; b < active.size(); b++) {
        MutexNode i = active.get(a);
        MutexNode j = active.get(b);
        if (a != b && breaksPromise(i, j)) {
          found.add(MutexSpec.PROMISE + ": " + j.protocol + " to " + i.protocol);
        }
        if (a < b
            && last.contains(i.id)
            && last.contains(j.id)
            && !known.get(a).contains(j.id)
            && !known.get(b).contains(i.id)) {
          found.add(MutexSpec.CONNECTED + ": " + i.protocol + " and " + j.protocol);
        }
      }
    }
    return found;
  }

  private static boolean breaksPromise(MutexNode i, MutexNode j) {
    MutexNode.Consent consent = j.consentedTo.get(i.id);
    if (consent == null || consent.num() != i.num) {
      return false;
    }
    SortedSet<String> promised =
        consent.part().isEmpty() ? i.want : Sections.common(i.want, consent.part());
    return Sections.exclude(promised, j.want) && !MutexProtocol.isBefore(i.ts, i.id, j.ts, j.id);
  }

  /** Whether it waits for a holder of its next section, which waits for the next one, and so on to it. */
  private static boolean isInCircle(MutexNode start, List<MutexNode> active) {
    MutexNode at = start;
    for (int step = 0; step < active.size(); step++) {
      List<String> waiting = at.protocol.waiting();
      Optional<MutexNode> holder =
          active.stream()
              .filter(other ->
                  !waiting.isEmpty() && Sections.exclude(other.held(), waiting.subList(0, 1)))
              .findFirst();
      if (holder.isEmpty()) {
        return false;
      }
      at = holder.get();
      if (at == start) {
        return true;
      }
    }
    return false;
  }
}
