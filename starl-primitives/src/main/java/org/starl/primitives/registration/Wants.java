package org.starl.primitives.registration;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;

/** What one robot wants different in the views beside its own coming and going. */
final class Wants {

  private final RobotId self;
  private final RegistrationPort port;

  // Every id of this start of the program; others of this robot are of earlier ones, and dead.
  private final Set<ProcessId> mine = new TreeSet<>();

  // Ids of this start that request nothing any more, hold nothing and never will.
  private final Set<ProcessId> idle = new TreeSet<>();

  private final Map<ProcessId, Confinement> confinements = new TreeMap<>();
  private @Nullable SortedSet<String> ownWord;
  private final Map<ProcessId, Confinement> told = new TreeMap<>();

  Wants(RobotId self, RegistrationPort port) {
    this.self = self;
    this.port = port;
  }

  void isMine(ProcessId id) {
    mine.add(id);
  }

  /** {@code id} only waits to be dropped; returns whether that is new. */
  boolean isIdle(ProcessId id) {
    return idle.add(id);
  }

  /** Whether {@code view} still mentions an id of this start that only waits to be dropped. */
  boolean lingersIn(View view) {
    return idle.stream().anyMatch(view::mentions);
  }

  void confine(Confinement confinement) {
    confinements.put(confinement.who(), confinement);
  }

  /** Whether this robot has spoken for its ids of earlier starts. */
  boolean hasOwnWord() {
    return ownWord != null;
  }

  void standsIn(SortedSet<String> sections) {
    ownWord = sections;
  }

  /** What is wanted different in {@code view}, with {@code join} and {@code leave} if not null. */
  Change in(View view, @Nullable ProcessId join, @Nullable ProcessId leave) {
    Set<ProcessId> leaving = new TreeSet<>(idle);
    if (leave != null) {
      leaving.add(leave);
    }
    leaving.removeIf(id -> !view.mentions(id));
    // What is done is done for good; and a fencer that is gone does not come back.
    confinements.values().removeIf(each -> !each.changes(view) || !each.isVouchedForIn(view));
    List<Confinement> confine = new ArrayList<>(ownWords(view));
    confine.addAll(confinements.values());
    confine.forEach(this::tell);
    return new Change(join, List.copyOf(leaving), confine);
  }

  private List<Confinement> ownWords(View view) {
    SortedSet<String> sections = ownWord;
    List<Confinement> words = new ArrayList<>();
    if (sections != null) {
      for (ProcessId id : view.mentioned()) {
        Confinement word = new Confinement(id, sections, new TreeSet<>());
        if (id.robot().equals(self) && !mine.contains(id) && word.changes(view)) {
          words.add(word);
        }
      }
    }
    return words;
  }

  private void tell(Confinement confinement) {
    if (!confinement.equals(told.put(confinement.who(), confinement))) {
      port.confines(confinement);
    }
  }
}
