package org.starl.apps.intersection.logic;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.Participants;
import org.starl.primitives.registration.Registration;

/**
 * A post at the side of the road, without wheels. It serves the intersection's registrations as an
 * acceptor, so that cars that come and go agree on who is there, and takes no other part.
 */
public final class RoadsideUnit extends LogicThread {

  /**
   * @param units all roadside units of the intersection, this one among them
   */
  public RoadsideUnit(GlobalVarHolder gvh, String xid, Participants units) {
    super(gvh);
    if (!units.contains(gvh.id.name())) {
      throw new IllegalArgumentException(gvh.id.name() + " is none of the units " + units);
    }
    new Registration(gvh, xid, units);
    for (int rank = 0; rank < Crossing.PLACES - 1; rank++) {
      new Registration(gvh, Lane.instance(xid, rank), units);
    }
  }

  /** Has nothing to do: the registrations go on answering. */
  @Override
  public List<Object> callStarL() {
    return returnResults();
  }
}
