package org.starl.apps.intersection.logic;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.geometry.ItemPosition;
import org.starl.id.Participants;

/**
 * A car's way along its arm, place by place, to the arrival zone. A car drives to the next place only
 * while it holds that place, and releases the one behind only when its whole body is outside for
 * certain. So no two cars are in one place. The last place of an arm, where cars enter the road, needs
 * no claim: no car drives to it.
 *
 * <p>The places are one sequence of a registration and mutex of their own. A car waits only for cars
 * ahead of it, so no cycle of waiting cars can form.
 */
public final class Lane {

  private final GlobalVarHolder gvh;
  private final ArrayDeque<ItemPosition> ahead;
  private final @Nullable Claim claim;
  private boolean isDriving;

  /**
   * @param approach the places to drive to, in order
   * @param acceptors of the registration
   */
  Lane(GlobalVarHolder gvh, String xid, List<ItemPosition> approach, Participants acceptors) {
    this.gvh = gvh;
    ahead = new ArrayDeque<>(approach);
    claim = approach.isEmpty() ? null : new Claim(gvh, instance(xid), acceptors, () -> true);
  }

  /** The instance of registration and mutex of all places: {@code crossing.queue}. */
  public static String instance(String xid) {
    return xid + ".queue";
  }

  /** Whether the car has reached the arrival zone, or started there. */
  boolean isAtTheHead() {
    return ahead.isEmpty();
  }

  /** Whether all places are released and the registration left. */
  boolean isOver() {
    return claim == null || claim.isOver();
  }

  /** Whether a place is wanted that is not held yet. */
  boolean isWaiting() {
    return !held().containsAll(rest());
  }

  boolean holds() {
    return !held().isEmpty();
  }

  /** The places that are held. */
  Collection<String> held() {
    return claim == null ? List.of() : claim.held();
  }

  /** Asks for the places ahead. */
  void want() {
    if (claim != null) {
      claim.want(names());
    }
  }

  /**
   * After a restart of the program: finds the places that the car stands in, claims them, and continues
   * from there.
   *
   * @param isPast whether the car has reached the critical zones or is beyond them
   */
  void resume(boolean isPast) {
    List<String> stands = names();
    stands.removeIf(place -> Crossing.hasLeft(gvh, place));
    while (!stands.isEmpty() && !ahead.element().name().equals(stands.get(0))) {
      ahead.remove();
    }
    List<String> rest = isPast ? stands : names();
    if (claim != null) {
      claim.resume(stands, rest);
    }
    if (isPast) {
      ahead.clear();
    }
  }

  /** Continues registering, asking and leaving; call it once a period. */
  void step() {
    if (claim != null) {
      claim.step();
    }
  }

  /**
   * Drives to the next place that is held; call it once a period.
   *
   * @param arrived whether the car is where it was sent
   */
  void drive(Predicate<ItemPosition> arrived) {
    ItemPosition next = ahead.element();
    if (!isDriving && held().contains(next.name())) {
      gvh.plat.moat.doMove(next);
      isDriving = true;
    } else if (isDriving && arrived.test(next)) {
      ahead.remove();
      isDriving = false;
      releaseLeft();
    }
  }

  /** The places that are wanted or held, in order. */
  List<String> rest() {
    return claim == null ? List.of() : claim.rest();
  }

  /** Number of places that it has not reached. */
  int placesAhead() {
    return ahead.size();
  }

  /** The body has left a place on its way. */
  void leave(String place) {
    if (claim != null) {
      claim.leave(place);
    }
  }

  /** After a restart: the body is not where it was not seen since then. */
  void knowsPlace() {
    if (claim != null) {
      claim.knows(place -> Crossing.hasLeft(gvh, place));
    }
  }

  /** Releases the places behind that the whole body has left. */
  void releaseLeft() {
    for (String place : rest()) {
      boolean isAhead = ahead.stream().anyMatch(next -> next.name().equals(place));
      if (!isAhead && Crossing.hasLeft(gvh, place)) {
        leave(place);
      }
    }
    knowsPlace();
  }

  private List<String> names() {
    return ahead.stream().map(ItemPosition::name).collect(Collectors.toCollection(ArrayList::new));
  }
}
