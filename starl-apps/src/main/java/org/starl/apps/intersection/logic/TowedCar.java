package org.starl.apps.intersection.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.id.Participants;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.registration.Registration;

/**
 * What an operator starts on a car that has crashed and is off the road: it says that the car is in
 * no zone and no place any more, and ends when nobody lists the car.
 */
public final class TowedCar extends LogicThread {

  private static final long PERIOD_MS = 500;

  private final List<Registration> registrations = new ArrayList<>();

  /**
   * @param acceptors of the registrations
   * @param places how many ranks of places cars queue on
   */
  public TowedCar(GlobalVarHolder gvh, String xid, Participants acceptors, int places) {
    super(gvh);
    add(xid, acceptors);
    for (int rank = 0; rank < places; rank++) {
      add(Lane.instance(xid, rank), acceptors);
    }
  }

  private void add(String xid, Participants acceptors) {
    Registration registration = new Registration(gvh, xid, acceptors);
    new M_Mutex(gvh, xid, registration).standsIn(List.of());
    registrations.add(registration);
  }

  @Override
  public List<Object> callStarL() {
    while (registrations.stream().anyMatch(this::isMentioned)) {
      sleep(PERIOD_MS);
    }
    return returnResults();
  }

  private boolean isMentioned(Registration registration) {
    return registration.view().number() == 0
        || registration.view().mentioned().stream()
            .anyMatch(id -> id.robot().equals(gvh.id.name()));
  }
}
