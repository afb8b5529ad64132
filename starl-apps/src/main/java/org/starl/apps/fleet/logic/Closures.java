package org.starl.apps.fleet.logic;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.starl.GlobalVarHolder;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.primitives.mutex.MutexPrim.Occupant;

/** What robots keep closed that others have given up as crashed. Strand only. */
final class Closures {

  private final GlobalVarHolder gvh;
  private final Roads roads;
  private final MutexPrim floor;
  private final Places places;
  private List<Occupant> told = List.of();

  Closures(GlobalVarHolder gvh, Roads roads, MutexPrim floor, Places places) {
    this.gvh = gvh;
    this.roads = roads;
    this.floor = floor;
    this.places = places;
  }

  /** These robots, and where they may be. Tells when this changes. */
  private List<Occupant> occupants() {
    List<Occupant> all = new ArrayList<>(floor.occupants());
    all.addAll(places.occupants());
    all.removeIf(one -> one.robot().equals(gvh.id.name()));
    if (!all.equals(told)) {
      gvh.log.w("fleet", all.isEmpty() ? "no place is closed" : "closed: " + all);
      told = all;
    }
    return all;
  }

  /** The sections of the floor, and of private vertices. */
  Set<String> sections() {
    Set<String> sections = new TreeSet<>();
    occupants().forEach(one -> sections.addAll(one.sections()));
    return sections;
  }

  /** Whether such a robot may be at a private vertex. */
  boolean isAt(int vertex) {
    return places.isAt(occupants(), vertex);
  }

  /** Whether such a robot may be at one of these stops, or on all ways to it. */
  boolean isShut(int from, List<Integer> stops) {
    Set<String> sections = sections();
    int last = from;
    for (int stop : sections.isEmpty() ? List.<Integer>of() : stops) {
      if (isAt(stop) || roads.wayAround(last, List.of(stop), sections).isEmpty()) {
        return true;
      }
      last = stop;
    }
    return false;
  }
}
