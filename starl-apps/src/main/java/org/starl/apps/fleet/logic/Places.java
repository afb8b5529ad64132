package org.starl.apps.fleet.logic;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;
import org.starl.GlobalVarHolder;
import org.starl.id.Participants;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexFailure;
import org.starl.primitives.mutex.MutexPrim.Occupant;
import org.starl.primitives.mutex.MutexTimes;
import org.starl.primitives.registration.Registration;

/**
 * The stations and chargers beside the ways: one robot at a time holds each. A mutex grants nothing more to
 * a robot that holds something, so there are several: while a robot stands at a place of one, it can ask
 * for a place of another. Strand only; what waits, from {@code callStarL}.
 */
final class Places {

  private static final int MOST_MUTEXES = 8;

  private final List<Integer> shared;
  private final int home;
  private final List<Registration> lists = new ArrayList<>();
  private final List<M_Mutex> mutexes = new ArrayList<>();

  /** @param home the robot's own place, which no other robot uses */
  Places(GlobalVarHolder gvh, Roads roads, int home, Participants voters, MutexTimes times) {
    shared = roads.shared();
    this.home = home;
    for (int i = 0; i < Math.min(MOST_MUTEXES, shared.size()); i++) {
      lists.add(new Registration(gvh, "places" + i, voters));
      mutexes.add(new M_Mutex(gvh, "places" + i, lists.get(i), times));
    }
  }

  /** The number of the mutex that a vertex belongs to; -1 for a vertex that is not shared, or on a way. */
  private int mutexOf(int vertex) {
    int place = vertex == home ? -1 : shared.indexOf(vertex);
    return place < 0 ? -1 : place % mutexes.size();
  }

  static String section(int vertex) {
    return "p" + vertex;
  }

  /** Whether a robot may ask for {@code to} while it holds {@code at}. */
  boolean mayAsk(int at, int to) {
    return mutexOf(to) < 0 || mutexOf(at) != mutexOf(to);
  }

  /** Registers where it has to for this vertex; false if there is no room. */
  boolean register(int vertex, long timeoutMs) {
    int its = mutexOf(vertex);
    return its < 0 || lists.get(its).register(timeoutMs);
  }

  /** Waits until the robot holds a vertex; false if it does not after this time. */
  boolean acquire(int vertex, long timeoutMs) {
    int its = mutexOf(vertex);
    return its < 0
        || (register(vertex, timeoutMs)
            && mutexes.get(its).acquire(List.of(section(vertex)), timeoutMs) == MutexFailure.NONE);
  }

  /** The body has left a vertex. */
  void leave(int vertex) {
    int its = mutexOf(vertex);
    if (its >= 0) {
      mutexes.get(its).release(section(vertex));
    }
  }

  /** After a restart: the body is at one of these vertices, or at none that is shared. */
  void standsIn(Collection<Integer> vertices) {
    for (int i = 0; i < mutexes.size(); i++) {
      List<String> sections = new ArrayList<>();
      for (int vertex : vertices) {
        if (mutexOf(vertex) == i) {
          sections.add(section(vertex));
        }
      }
      mutexes.get(i).standsIn(sections);
    }
  }

  /** The robots that were given up as crashed and may still be at a place. */
  List<Occupant> occupants() {
    return mutexes.stream()
        .flatMap(mutex -> mutex.occupants().stream())
        .collect(Collectors.toList());
  }

  /** Whether one of these robots may be at this vertex. */
  boolean isAt(Collection<Occupant> occupants, int vertex) {
    return mutexOf(vertex) >= 0
        && occupants.stream().anyMatch(one -> one.sections().contains(section(vertex)));
  }

  /** How many other robots are known to hold it or to wait for it. */
  int contenders(int vertex) {
    int its = mutexOf(vertex);
    return its < 0 ? 0 : mutexes.get(its).contenders(section(vertex));
  }

  /** The lists of the robots that use places. */
  List<Registration> lists() {
    return lists;
  }
}
