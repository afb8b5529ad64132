package org.starl.apps.intersection.logic;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Membership;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.primitives.registration.RegPrim;
import org.starl.primitives.registration.Registration;

/**
 * A car's claim on one place of its arm: it registers among those who want a place of this rank, asks
 * for its own one, and unregisters when it has given that back. Where a primitive gives up and says
 * so, it asks again.
 */
final class Claim {

  private enum State {
    OUT,
    REGISTERING,
    ASKING,
    HELD,
    LEAVING
  }

  private final RobotId self;
  private final RegPrim reg;
  private final Membership membership;
  private final MutexPrim mutex;
  private String place = "";
  private boolean startedAnew;
  private State state = State.OUT;

  /**
   * @param xid of the registration and the mutex of one rank of places
   * @param acceptors of the registration
   */
  Claim(GlobalVarHolder gvh, String xid, Participants acceptors) {
    Registration registration = new Registration(gvh, xid, acceptors);
    self = gvh.id.name();
    reg = registration;
    membership = registration;
    mutex = new M_Mutex(gvh, xid, registration);
  }

  /** From now on {@code aPlace} is wanted; it must be held before the car enters it. */
  void want(String aPlace) {
    if (state != State.OUT || !place.isEmpty()) {
      throw new IllegalStateException("wants " + aPlace + " while " + state + " for " + place);
    }
    place = aPlace;
  }

  /**
   * For a program that has started anew: its body is in this place of those of this rank, and has to
   * hold it, or, if it is empty, in none of them.
   */
  void standsIn(String aPlace) {
    startedAnew = true;
    if (aPlace.isEmpty()) {
      mutex.standsIn(List.of());
    } else {
      mutex.standsIn(List.of(aPlace));
      want(aPlace);
    }
  }

  boolean isHeld() {
    return state == State.HELD;
  }

  /** Whether it waits for its place. */
  boolean isWaiting() {
    return !place.isEmpty() && state != State.HELD;
  }

  /** Whether it holds nothing, wants nothing and is not registered, as earlier starts are not. */
  boolean isOver() {
    return state == State.OUT && place.isEmpty() && !(startedAnew && isMentioned());
  }

  private boolean isMentioned() {
    return membership.view().number() == 0
        || membership.view().mentioned().stream().anyMatch(id -> id.robot().equals(self));
  }

  String place() {
    return place;
  }

  /** Gives the place back, which is held, and unregisters. */
  void release() {
    mutex.release(place);
    place = "";
    reg.unregister();
    state = State.LEAVING;
  }

  /** Does what is to be done now; to be called once a period. */
  void look() {
    switch (state) {
      case OUT -> {
        if (!place.isEmpty()) {
          reg.do_register();
          state = State.REGISTERING;
        }
      }
      case REGISTERING -> {
        if (reg.getList().isAgreed()) {
          mutex.do_mutex(List.of(place));
          state = State.ASKING;
        } else if (reg.failed().get()) {
          state = State.OUT;
        }
      }
      case ASKING -> {
        if (mutex.od_mutex()) {
          state = State.HELD;
          if (startedAnew) {
            mutex.standsIn(List.of()); // who it was before need not keep the place any more
          }
        } else if (mutex.failed().get()) {
          boolean mustRegister = mutex.failure().get().mustRegister();
          state = mustRegister ? State.OUT : State.REGISTERING;
        }
      }
      case HELD -> {
        // Until it is released.
      }
      case LEAVING -> {
        if (reg.isUnregistered()) {
          state = State.OUT;
        } else if (reg.failed().get()) {
          reg.unregister();
        }
      }
    }
  }
}
