package org.starl.apps.intersection.logic;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.starl.GlobalVarHolder;
import org.starl.geometry.ItemPosition;
import org.starl.id.Participants;

/**
 * A car's way up its arm, place by place, to the arrival zone. No two cars are in one place: a car
 * drives to the next place only while it holds it, and gives the one behind it back only once its
 * whole body is out of it for certain. Nobody drives to the last place of an arm, where cars come
 * onto the road, so that one is held by nobody.
 *
 * <p>Each rank of places has a registration and a mutex of its own, for a car asks for a place while
 * it holds the one behind. Whoever waits, waits for a car that is farther ahead: nobody waits in a
 * circle.
 */
public final class Lane {

  private final GlobalVarHolder gvh;
  private final Crossing crossing;
  private final ArrayDeque<ItemPosition> ahead;
  private final List<Claim> claims = new ArrayList<>();
  private boolean isDriving;

  /**
   * @param approach the places to come to, in order
   * @param acceptors of every registration
   */
  Lane(
      GlobalVarHolder gvh,
      String xid,
      Crossing crossing,
      List<ItemPosition> approach,
      Participants acceptors) {
    this.gvh = gvh;
    this.crossing = crossing;
    ahead = new ArrayDeque<>(approach);
    for (int rank = 0; rank < approach.size(); rank++) {
      claims.add(new Claim(gvh, instance(xid, rank), acceptors));
    }
  }

  /** The instance of registration and mutex for the places of one rank: {@code crossing.queue0}. */
  public static String instance(String xid, int rank) {
    return xid + ".queue" + rank;
  }

  /** Whether the car is in the arrival zone, or began there. */
  boolean isAtTheHead() {
    return ahead.isEmpty();
  }

  /** Whether no place is held any more, and every registration is left. */
  boolean isOver() {
    return claims.stream().allMatch(Claim::isOver);
  }

  /** Whether a place is wanted and not held. */
  boolean isWaiting() {
    return claims.stream().anyMatch(Claim::isWaiting);
  }

  /** For a car that has come onto the road. */
  void begin() {
    wantNext();
  }

  /**
   * For a program that has started anew: finds out where on its arm the car stands, wants what it
   * stands in, and goes on from there.
   *
   * @param isPast whether the car has reached the critical zones or is beyond them
   */
  void beginAnew(boolean isPast) {
    double radiusMm = gvh.plat.moat.parameters().robotRadiusMm();
    int rank = ahead.size();
    int behind = 0;
    boolean isFound = false;
    for (ItemPosition place : ahead) {
      rank--;
      boolean isThere = !gvh.gps.isClearOf(crossing.region(place.name()), radiusMm);
      claims.get(rank).standsIn(isThere ? place.name() : "");
      isFound |= isThere;
      behind += isFound ? 0 : 1;
    }
    if (isPast) {
      ahead.clear();
    } else if (isFound) {
      for (int i = 0; i < behind; i++) {
        ahead.remove();
      }
    }
    wantNext();
  }

  /** Whether a place is held. */
  boolean holds() {
    return claims.stream().anyMatch(Claim::isHeld);
  }

  /** What is to be done while the car does something else; to be called once a period. */
  void look() {
    claims.forEach(Claim::look);
  }

  /**
   * Drives up as far as possible; to be called once a period.
   *
   * @param arrived whether the car is where it was sent
   */
  void drive(Predicate<ItemPosition> arrived) {
    ItemPosition next = ahead.element();
    if (isDriving) {
      if (arrived.test(next)) {
        ahead.remove();
        isDriving = false;
        giveBackWhatIsBehind();
        wantNext();
      }
    } else if (!isWaiting()) {
      gvh.plat.moat.doMove(next);
      isDriving = true;
    }
  }

  /** Gives back the places that this car is out of for certain; to be called when it stands. */
  void giveBackWhatIsBehind() {
    double radiusMm = gvh.plat.moat.parameters().robotRadiusMm();
    for (Claim claim : claims) {
      if (claim.isHeld()
          && !isAhead(claim.place())
          && gvh.gps.isClearOf(crossing.region(claim.place()), radiusMm)) {
        claim.release();
      }
    }
  }

  private boolean isAhead(String place) {
    return ahead.stream().anyMatch(next -> next.name().equals(place));
  }

  private void wantNext() {
    ItemPosition next = ahead.peek();
    if (next != null && claims.get(ahead.size() - 1).place().isEmpty()) {
      claims.get(ahead.size() - 1).want(next.name());
    }
  }
}
