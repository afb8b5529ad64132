package org.starl.apps.intersection.logic;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.primitives.registration.Registration;

/**
 * A car's claim to one place of its arm. It registers with the cars that want a place of the same rank,
 * asks the mutex for the place, and unregisters after it has released the place. It asks again when a
 * primitive reports a failure.
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
  private final Registration reg;
  private final MutexPrim mutex;
  private String place = "";
  private boolean restarted;
  private State state = State.OUT;

  /**
   * @param xid instance of the registration and the mutex
   * @param acceptors of the registration
   */
  Claim(GlobalVarHolder gvh, String xid, Participants acceptors) {
    self = gvh.id.name();
    reg = new Registration(gvh, xid, acceptors);
    mutex = new M_Mutex(gvh, xid, reg);
  }

  /** The place that is wanted or held; empty for none. */
  String place() {
    return place;
  }

  /** Asks for {@code wanted} from now on; the car must hold it before it enters it. */
  void want(String wanted) {
    if (state != State.OUT || !place.isEmpty()) {
      throw new IllegalStateException("wants " + wanted + " while " + state + " for " + place);
    }
    place = wanted;
  }

  /** After a restart of the program: the body is in {@code occupied}; empty for no place. */
  void standsIn(String occupied) {
    restarted = true;
    mutex.standsIn(occupied.isEmpty() ? List.of() : List.of(occupied));
    place = occupied;
  }

  boolean isHeld() {
    return state == State.HELD;
  }

  boolean isWaiting() {
    return !place.isEmpty() && state != State.HELD;
  }

  /** Whether neither this process nor an earlier one of this robot is registered or wants a place. */
  boolean isOver() {
    return state == State.OUT && place.isEmpty() && !(restarted && isMentioned());
  }

  private boolean isMentioned() {
    return reg.view().number() == 0
        || reg.view().mentioned().stream().anyMatch(id -> id.robot().equals(self));
  }

  /** Releases the place, which must be held, and unregisters. */
  void release() {
    mutex.release(place);
    place = "";
    reg.unregister();
    state = State.LEAVING;
  }

  /** Takes the next step; call it once a period. */
  void step() {
    switch (state) {
      case OUT -> {
        if (!place.isEmpty()) {
          reg.do_register();
          state = State.REGISTERING;
        }
      }
      case REGISTERING -> {
        if (reg.getList() != null) {
          mutex.do_mutex(List.of(place));
          state = State.ASKING;
        } else if (reg.failed().get()) {
          state = State.OUT;
        }
      }
      case ASKING -> {
        if (mutex.od_mutex()) {
          state = State.HELD;
          if (restarted) {
            mutex.standsIn(List.of()); // the claim of the earlier process is no longer needed
          }
        } else if (mutex.failed().get()) {
          state = mutex.failure().get().mustRegister() ? State.OUT : State.REGISTERING;
        }
      }
      case HELD -> {
        // Until release().
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
