package org.starl.apps.intersection.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.id.Participants;

/**
 * The program that the operator starts on a crashed car after taking it off the road. It declares that
 * the car is in no zone and no place, and ends when no registration mentions the car.
 */
public final class TowedCar extends LogicThread {

  private static final long PERIOD_MS = 500;

  private final List<Claim> claims = new ArrayList<>();

  /**
   * @param acceptors of the registrations
   * @param claimsPlaces whether cars claim the places of their arm
   */
  public TowedCar(GlobalVarHolder gvh, String xid, Participants acceptors, boolean claimsPlaces) {
    super(gvh);
    add(xid, acceptors);
    if (claimsPlaces) {
      add(Lane.instance(xid), acceptors);
    }
  }

  private void add(String xid, Participants acceptors) {
    Claim claim = new Claim(gvh, xid, acceptors, () -> true);
    claim.resume(List.of(), List.of());
    claims.add(claim);
  }

  @Override
  public List<Object> callStarL() {
    while (!claims.stream().allMatch(Claim::isOver)) {
      sleep(PERIOD_MS);
    }
    return returnResults();
  }
}
