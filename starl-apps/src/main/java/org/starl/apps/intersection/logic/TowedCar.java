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
   * @param places number of ranks of places that cars claim; 0 if cars start in the arrival zone
   */
  public TowedCar(GlobalVarHolder gvh, String xid, Participants acceptors, int places) {
    super(gvh);
    add(xid, acceptors);
    for (int rank = 0; rank < places; rank++) {
      add(Lane.instance(xid, rank), acceptors);
    }
  }

  private void add(String xid, Participants acceptors) {
    Claim claim = new Claim(gvh, xid, acceptors);
    claim.standsIn("");
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
