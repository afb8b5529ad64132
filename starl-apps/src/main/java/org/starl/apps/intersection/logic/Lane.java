package org.starl.apps.intersection.logic;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;
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
  private final Claim claim;
  private boolean isDriving;

  /**
   * @param approach the places to drive to, in order
   * @param acceptors of the registration
   */
  Lane(GlobalVarHolder gvh, String xid, List<ItemPosition> approach, Participants acceptors) {
    this.gvh = gvh;
    ahead = new ArrayDeque<>(approach);
    claim = new Claim(gvh, instance(xid), acceptors, () -> true);
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
    return claim.isOver();
  }

  /** Whether a place is wanted that is not held yet. */
  boolean isWaiting() {
    return !claim.held().containsAll(claim.rest());
  }

  boolean holds() {
    return !claim.held().isEmpty();
  }

  /** The places that are held. */
  List<String> held() {
    return List.copyOf(claim.held());
  }

  /** Asks for the places ahead. */
  void want() {
    claim.want(names());
  }

  /**
   * After a restart of the program: finds the places that the car stands in, claims them, and continues
   * from there.
   *
   * @param isPast whether the car has reached the critical zones or is beyond them
   */
  void resume(boolean isPast) {
    List<String> stands = names();
    stands.removeIf(place -> Crossing.isClearOf(gvh, place));
    while (!stands.isEmpty() && !ahead.element().name().equals(stands.get(0))) {
      ahead.remove();
    }
    List<String> rest = isPast ? stands : names();
    claim.resume(stands, rest);
    if (isPast) {
      ahead.clear();
    }
  }

  /** Continues registering, asking and leaving; call it once a period. */
  void step() {
    claim.step();
  }

  /**
   * Drives to the next place that is held; call it once a period.
   *
   * @param arrived whether the car is where it was sent
   */
  void drive(Predicate<ItemPosition> arrived) {
    ItemPosition next = ahead.element();
    if (!isDriving && claim.held().contains(next.name())) {
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
    return claim.rest();
  }

  /** The places that the body may be in. */
  List<String> stands() {
    List<String> stands = new ArrayList<>(claim.rest());
    stands.removeIf(place -> Crossing.isClearOf(gvh, place));
    return stands;
  }

  /** Number of places that it has not reached. */
  int placesAhead() {
    return ahead.size();
  }

  void release(String place) {
    claim.release(place);
  }

  /** Releases the places behind that the whole body has left. */
  void releaseLeft() {
    for (String place : held()) {
      boolean isAhead = ahead.stream().anyMatch(next -> next.name().equals(place));
      if (!isAhead && Crossing.isClearOf(gvh, place)) {
        claim.release(place);
      }
    }
  }

  private List<String> names() {
    return ahead.stream().map(ItemPosition::name).collect(Collectors.toCollection(ArrayList::new));
  }
}
