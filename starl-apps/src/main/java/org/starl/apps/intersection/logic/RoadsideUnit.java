package org.starl.apps.intersection.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.id.Participants;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.primitives.registration.Registration;

/**
 * A fixed unit at the roadside, without wheels. It is an acceptor of all registrations, so cars that
 * come and go agree on the list of cars. It is also a participant of every mutex, but never asks for a
 * section. It is older than any car, so every car needs its consent: it still knows the sections that a
 * crashed car may hold when all cars that crossed with it have left.
 */
public final class RoadsideUnit extends LogicThread {

  private static final long PERIOD_MS = 500;

  private final List<Member> members = new ArrayList<>();

  /** The unit's part in one registration and the mutex over it. */
  private static final class Member {
    private final Registration registration;
    private boolean isRegistering;

    Member(GlobalVarHolder gvh, String xid, Participants units) {
      registration = new Registration(gvh, xid, units);
      MutexPrim mutex = new M_Mutex(gvh, xid, registration);
      if (gvh.id.boot() > 1) {
        mutex.standsIn(List.of());
      }
    }

    void keepRegistered() {
      if (registration.mayRequest()) {
        isRegistering = false;
      } else if (!isRegistering || registration.failed().get()) {
        registration.do_register();
        isRegistering = true;
      }
    }
  }

  /**
   * @param units all roadside units of the intersection, including this one
   */
  public RoadsideUnit(GlobalVarHolder gvh, String xid, Participants units) {
    super(gvh);
    if (!units.contains(gvh.id.name())) {
      throw new IllegalArgumentException(gvh.id.name() + " is not among the units " + units);
    }
    members.add(new Member(gvh, xid, units));
    members.add(new Member(gvh, Lane.instance(xid), units));
  }

  /** Stays registered; never ends by itself. */
  @Override
  public List<Object> callStarL() {
    while (true) {
      members.forEach(Member::keepRegistered);
      sleep(PERIOD_MS);
    }
  }
}
