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

/** The changes that one robot wants in the views, beside its own joining and leaving. */
final class PendingChanges {

  private final RobotId self;
  private final RegistrationPort port;

  // All ids of this start of the program. The robot's other ids are of earlier starts, and dead.
  private final Set<ProcessId> own = new TreeSet<>();

  // Own ids that hold nothing and will request nothing again.
  private final Set<ProcessId> idle = new TreeSet<>();

  private final Map<ProcessId, Confinement> confinements = new TreeMap<>();
  // Set by standsIn: the sections in which the robot's body may be.
  private @Nullable SortedSet<String> bodySections;
  private final Map<ProcessId, Confinement> announced = new TreeMap<>();

  PendingChanges(RobotId self, RegistrationPort port) {
    this.self = self;
    this.port = port;
  }

  void addOwn(ProcessId id) {
    own.add(id);
  }

  /** {@code id} may be removed from the views; returns whether that is new. */
  boolean markIdle(ProcessId id) {
    return idle.add(id);
  }

  /** Whether {@code view} still mentions an idle id. */
  boolean lingersIn(View view) {
    return idle.stream().anyMatch(view::mentions);
  }

  void confine(Confinement confinement) {
    confinements.put(confinement.who(), confinement);
  }

  /** Whether {@link #standsIn} was called. */
  boolean hasOwnWord() {
    return bodySections != null;
  }

  void standsIn(SortedSet<String> sections) {
    bodySections = sections;
  }

  /** The changes wanted in {@code view}, with {@code join} and {@code leave} if not null. */
  Change in(View view, @Nullable ProcessId join, @Nullable ProcessId leave) {
    Set<ProcessId> leaving = new TreeSet<>(idle);
    if (leave != null) {
      leaving.add(leave);
    }
    leaving.removeIf(id -> !view.mentions(id));
    // A change that is made stays made, and a fencer that has gone never comes back.
    confinements.values().removeIf(each -> !each.changes(view) || !each.hasFencersIn(view));
    List<Confinement> confine = new ArrayList<>(ofEarlierStarts(view));
    confine.addAll(confinements.values());
    confine.forEach(this::announce);
    return new Change(join, List.copyOf(leaving), confine);
  }

  private List<Confinement> ofEarlierStarts(View view) {
    SortedSet<String> sections = bodySections;
    List<Confinement> changes = new ArrayList<>();
    if (sections != null) {
      for (ProcessId id : view.mentioned()) {
        Confinement change = new Confinement(id, sections, new TreeSet<>());
        if (id.robot().equals(self) && !own.contains(id) && change.changes(view)) {
          changes.add(change);
        }
      }
    }
    return changes;
  }

  /** The state. */
  @Override
  public String toString() {
    return idle + " " + own + confinements + bodySections + announced;
  }

  private void announce(Confinement confinement) {
    if (!confinement.equals(announced.put(confinement.who(), confinement))) {
      port.confines(confinement);
    }
  }
}
