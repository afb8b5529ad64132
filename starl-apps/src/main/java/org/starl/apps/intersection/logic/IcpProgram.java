// Generated from IcpProgram.starl by 'starl compile': change that file instead.
package org.starl.apps.intersection.logic;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.gvh.GvhCell;
import org.starl.gvh.Wait;
import org.starl.id.Participants;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.primitives.registration.Registration;
import org.starl.shape.Shapes;
import org.starl.spec.automaton.Sets;
import org.starl.spec.automaton.Undefined;
import org.starl.trace.Instance;
import org.starl.trace.Var;

/** One car at the automatic intersection: Figure 3 of the StarL paper, repaired. */
public final class IcpProgram extends LogicThread {

  /** The locations, with their lines in IcpProgram.starl. */
  public enum Location {
    S0(68),
    REG_WAIT(72),
    MUTEX_WAIT(78),
    MOVE_WAIT(82),
    S1(87),
    UNREG_WAIT(90),
    DONE(94);

    private final int line;

    Location(int line) {
      this.line = line;
    }
  }

  /** Where it is. */
  public static final Var<Location> LOCATION = Var.of("location", Location.class);

  /** The variable plist. */
  public static final Var<Participants> PLIST = Var.of("plist", Shapes.PARTICIPANTS);

  /** the zones that the car has not left */
  public static final Var<List<String>> MYSEQ = Var.of("myseq", Shapes.list(Shapes.TEXT, 0xFFFF));

  private final Trip trip;
  private final Registration reg;
  private final MutexPrim mux;
  private final Driver car;
  private final GvhCell<Location> location;
  private final GvhCell<Participants> plist;
  // the zones that the car has not left
  private final GvhCell<List<String>> myseq;
  // of the branch that it takes, or else of its location, in IcpProgram.starl
  private int line;

  public IcpProgram(GlobalVarHolder gvh, String xid, Trip trip, Participants acceptors) {
    super(gvh);
    this.trip = trip;
    reg = new Registration(gvh, xid, acceptors);
    mux = new M_Mutex(gvh, xid, reg);
    car = new Driver(gvh, xid, trip, acceptors, mux);
    location = gvh.variable(LOCATION, Location.S0);
    plist = gvh.variable(PLIST, Participants.of());
    myseq = gvh.variable(MYSEQ, Driver.way(trip));
    gvh.explain(() -> isOver() ? null : new Wait(Instance.APP, where(), List.of()));
  }

  @Override
  public List<Object> callStarL() {
    while (!isOver()) {
      line = location.get().line;
      switch (location.get()) {
        case S0 -> {
          if (Driver.way(trip).isEmpty()) {
            line = 69;
            location.set(Location.DONE);
          } else if (car.isReady()) {
            line = 70;
            myseq.set(car.ahead());
            reg.do_register();
            location.set(Location.REG_WAIT);
          }
        }
        case REG_WAIT -> {
          if (reg.getList() != null && myseq.get().isEmpty()) {
            line = 73;
            car.drive(Sets.emptyset());
            location.set(Location.S1);
          } else if (reg.getList() != null) {
            line = 74;
            plist.set(reg.listOrEmpty());
            mux.do_mutex(Sets.of(myseq.get()), plist.get());
            location.set(Location.MUTEX_WAIT);
          } else if (reg.failed().get()) {
            line = 76;
            restart();
          }
        }
        case MUTEX_WAIT -> {
          if (mux.od_mutex()) {
            line = 79;
            car.drive(Sets.of(myseq.get()));
            location.set(Location.MOVE_WAIT);
          } else if (mux.failed().get()) {
            line = 80;
            location.set(Location.REG_WAIT);
          }
        }
        case MOVE_WAIT -> {
          if (myseq.get().isEmpty()) {
            line = 83;
            location.set(Location.S1);
          } else if (car.left().contains(Undefined.head("IcpProgram.starl:84:8", myseq.get()))) {
            line = 84;
            mux.release(Sets.singleton(Undefined.head("IcpProgram.starl:85:18", myseq.get())));
            myseq.set(Undefined.tail("IcpProgram.starl:85:42", myseq.get()));
          }
        }
        case S1 -> {
          if (car.isAtExit()) {
            line = 88;
            reg.unregister();
            location.set(Location.UNREG_WAIT);
          }
        }
        case UNREG_WAIT -> {
          if (reg.isUnregistered()) {
            line = 91;
            location.set(Location.DONE);
          } else if (reg.failed().get()) {
            line = 92;
            location.set(Location.S1);
          }
        }
        case DONE -> throw new IllegalStateException("the program has ended");
      }
      sleep(100);
    }
    return List.of();
  }

  private boolean isOver() {
    return location.get() == Location.DONE;
  }

  /** Where it is, for people who ask why a run does not end. */
  private String where() {
    return location.get() + ", IcpProgram.starl:" + location.get().line;
  }

  @Override
  protected StackTraceElement inSource() {
    return new StackTraceElement(getClass().getName(), "callStarL", "IcpProgram.starl", line);
  }

  /** Begins anew. */
  private void restart() {
    plist.set(Participants.of());
    myseq.set(Driver.way(trip));
    location.set(Location.S0);
  }
}
