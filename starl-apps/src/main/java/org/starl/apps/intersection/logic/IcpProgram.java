package org.starl.apps.intersection.logic;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.gvh.GvhCell;
import org.starl.id.Participants;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.registration.Registration;
import org.starl.spec.automaton.Sets;

/** One car at the automatic intersection: Figure 3 of the StarL paper, repaired. */
public final class IcpProgram extends LogicThread {

  /** The locations. */
  public enum Location {
    S0,
    REG_WAIT,
    MUTEX_WAIT,
    MOVE_WAIT,
    S1,
    UNREG_WAIT,
    DONE
  }

  private final Trip trip;
  private final Registration reg;
  private final M_Mutex mux;
  private final Driver car;
  private final GvhCell<Location> location;
  private final GvhCell<Participants> plist;
  private final GvhCell<List<String>> myseq;

  public IcpProgram(GlobalVarHolder gvh, String xid, Trip trip, Participants acceptors) {
    super(gvh);
    this.trip = trip;
    reg = new Registration(gvh, xid, acceptors);
    mux = new M_Mutex(gvh, xid, reg);
    car = new Driver(gvh, xid, trip, acceptors, mux);
    location = gvh.variable("app", "location", Location.S0);
    plist = gvh.variable("app", "plist", Participants.of());
    myseq = gvh.variable("app", "myseq", Driver.way(trip));
  }

  @Override
  public List<Object> callStarL() {
    while (location.get() != Location.DONE) {
      switch (location.get()) {
        case S0 -> {
          if (Driver.way(trip).isEmpty()) {
            location.set(Location.DONE);
          } else if (car.isReady()) {
            car.begin();
            mux.standsIn(car.occupied());
            myseq.set(car.ahead());
            reg.do_register();
            location.set(Location.REG_WAIT);
          }
        }
        case REG_WAIT -> {
          if (reg.getList() != null && myseq.get().isEmpty()) {
            car.drive();
            location.set(Location.S1);
          } else if (reg.getList() != null) {
            plist.set(reg.getList());
            mux.do_mutex(Sets.of(myseq.get()), plist.get());
            location.set(Location.MUTEX_WAIT);
          } else if (reg.failed().get()) {
            location.set(Location.S0);
          }
        }
        case MUTEX_WAIT -> {
          if (mux.crit().get() && car.mayGo()) {
            mux.standsIn(Sets.emptyset());
            car.drive();
            location.set(Location.MOVE_WAIT);
          } else if (mux.failed().get()) {
            location.set(Location.REG_WAIT);
          }
        }
        case MOVE_WAIT -> {
          if (myseq.get().isEmpty()) {
            location.set(Location.S1);
          } else if (car.hasLeft(myseq.get().get(0))) {
            mux.release(Sets.singleton(myseq.get().get(0)));
            myseq.set(myseq.get().subList(1, myseq.get().size()));
          }
        }
        case S1 -> {
          if (car.isAtExit()) {
            reg.unregister();
            location.set(Location.UNREG_WAIT);
          }
        }
        case UNREG_WAIT -> {
          if (reg.isUnregistered() && car.isOver()) {
            location.set(Location.DONE);
          } else if (reg.failed().get()) {
            reg.unregister();
          }
        }
        case DONE -> {}
      }
      sleep(100);
    }
    return List.of();
  }
}
