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
 * <p>A car asks for the next place while it holds the one behind, so each rank of places has its own
 * registration and mutex. A car waits only for cars ahead of it, so no cycle of waiting cars can form.
 */
public final class Lane {

  private final GlobalVarHolder gvh;
  private final ArrayDeque<ItemPosition> ahead;
  private final List<Claim> claims = new ArrayList<>();
  private boolean isDriving;

  /**
   * @param approach the places to drive to, in order
   * @param acceptors of every registration
   */
  Lane(GlobalVarHolder gvh, String xid, List<ItemPosition> approach, Participants acceptors) {
    this.gvh = gvh;
    ahead = new ArrayDeque<>(approach);
    for (int rank = 0; rank < approach.size(); rank++) {
      claims.add(new Claim(gvh, instance(xid, rank), acceptors));
    }
  }

  /** The instance of registration and mutex for one rank of places: {@code crossing.queue0}. */
  public static String instance(String xid, int rank) {
    return xid + ".queue" + rank;
  }

  /** Whether the car has reached the arrival zone, or started there. */
  boolean isAtTheHead() {
    return ahead.isEmpty();
  }

  /** Whether all places are released and all registrations left. */
  boolean isOver() {
    return claims.stream().allMatch(Claim::isOver);
  }

  /** Whether a place is wanted that is not held yet. */
  boolean isWaiting() {
    return claims.stream().anyMatch(Claim::isWaiting);
  }

  boolean holds() {
    return !held().isEmpty();
  }

  /** The places that are held. */
  List<String> held() {
    return claims.stream().filter(Claim::isHeld).map(Claim::place).collect(Collectors.toList());
  }

  /**
   * After a restart of the program: finds the place that the car stands in, claims it, and continues
   * from there.
   *
   * @param isPast whether the car has reached the critical zones or is beyond them
   */
  void resume(boolean isPast) {
    int rank = ahead.size();
    boolean isFound = false;
    for (ItemPosition place : new ArrayList<>(ahead)) {
      rank--;
      boolean isThere = !Crossing.isClearOf(gvh, place.name());
      claims.get(rank).standsIn(isThere ? place.name() : "");
      while (isThere && !isFound && !ahead.element().equals(place)) {
        ahead.remove();
      }
      isFound |= isThere;
    }
    if (isPast) {
      ahead.clear();
    }
    wantNext();
  }

  /** Continues registering, asking and leaving; call it once a period. */
  void step() {
    claims.forEach(Claim::step);
  }

  /**
   * Drives to the next place that is held; call it once a period.
   *
   * @param arrived whether the car is where it was sent
   */
  void drive(Predicate<ItemPosition> arrived) {
    ItemPosition next = ahead.element();
    if (!isDriving && !isWaiting()) {
      gvh.plat.moat.doMove(next);
      isDriving = true;
    } else if (isDriving && arrived.test(next)) {
      ahead.remove();
      isDriving = false;
      releaseLeft();
      wantNext();
    }
  }

  /** Releases the places behind that the whole body has left; call it when the car stands. */
  void releaseLeft() {
    for (Claim claim : claims) {
      boolean isAhead = ahead.stream().anyMatch(next -> next.name().equals(claim.place()));
      if (claim.isHeld() && !isAhead && Crossing.isClearOf(gvh, claim.place())) {
        claim.release();
      }
    }
  }

  /** Asks for the next place, unless the car holds the last one. */
  void wantNext() {
    ItemPosition next = ahead.peek();
    if (next != null && claims.get(ahead.size() - 1).place().isEmpty()) {
      claims.get(ahead.size() - 1).want(next.name());
    }
  }
}
