package org.starl.apps.intersection.logic;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.gvh.GvhCell;
import org.starl.id.Participants;
import org.starl.motion.MotionFlag;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.primitives.registration.RList;
import org.starl.primitives.registration.RegPrim;
import org.starl.primitives.registration.Registration;

/**
 * One car at the automatic intersection: the paper's Figure 4, with its locations, which are
 * those of the PVS theory in Figure 5. What lies between two sleeps is one atomic action.
 *
 * <p>Where it must differ from the figure to be safe:
 *
 * <ul>
 *   <li>The figure gives a zone back when the car is not in motion. A car that has bumped into
 *       something is not in motion either, and still stands in the zone. Here a zone is given back
 *       only once the motion is DONE <em>and</em> the whole body is proven to be outside, position
 *       error included; after a FAIL the car keeps its zones and tries again.
 *   <li>The figure's first release is of a zone that was never asked for. Here nothing is released
 *       before a first critical zone lies behind the car.
 *   <li>The car drives on past its departure zone before it gives that back, so that the next car
 *       finds it free.
 *   <li>On an open road a car comes onto its arm behind others: in QUEUE it drives up, place by
 *       place, until it is in the arrival zone, where the figure begins.
 *   <li>A program that has started anew does not know how far the car has come. In RESUME it waits
 *       for a position fix, says which zones its body may be in, so that who it was before keeps no
 *       others, and goes on from the first of them: it may turn back to that zone's middle.
 *   <li>To unregister takes messages, as to register does: UNREGISTER_WAIT is where a car waits for
 *       it. Where a primitive gives up and says so ({@code failed}), the car asks again: in MUTEX_S
 *       for its zones, in S_0 to be registered, also where the mutex failed because it is no longer.
 * </ul>
 */
public final class IntersectionApp extends LogicThread {

  /** Figure 4's locations, RESUME, QUEUE and UNREGISTER_WAIT. */
  public enum Location {
    RESUME,
    QUEUE,
    S_0,
    REGISTER_WAIT,
    MUTEX_S,
    MUTEX_WAIT,
    MOVE_WAIT,
    S_1,
    UNREGISTER_WAIT,
    DONE
  }

  private static final long PERIOD_MS = 100;
  private static final long RETRY_MS = 1000;

  private final RegPrim reg;
  private final MutexPrim mutex;
  private final Lane lane;
  private final GvhCell<Location> location;
  private final Course myseq;
  private Participants plist = Participants.of();

  /**
   * A car among those that the deployment knows, all of which are acceptors of the registration, at
   * the head of its arm.
   *
   * @param xid names this intersection: cars with another one are at another intersection
   */
  public IntersectionApp(GlobalVarHolder gvh, String xid, Crossing crossing, Trip trip) {
    this(gvh, xid, crossing, trip, gvh.id.participants());
  }

  /**
   * A car on an open road, where anybody may come.
   *
   * @param acceptors of the registrations: the roadside units
   */
  public IntersectionApp(
      GlobalVarHolder gvh, String xid, Crossing crossing, Trip trip, Participants acceptors) {
    super(gvh);
    Registration registration = new Registration(gvh, xid, acceptors);
    reg = registration;
    mutex = new M_Mutex(gvh, xid, registration);
    lane = new Lane(gvh, xid, crossing, trip.approach(), acceptors);
    CrossingTrace trace = new CrossingTrace(gvh, trip, start(trip));
    location = trace.location();
    myseq = new Course(gvh, crossing, trip, trace);
    gvh.plat.moat.setParameters(Crossing.motion(gvh.plat.moat.parameters()));
  }

  @Override
  public List<Object> callStarL() {
    while (location.get() != Location.DONE) {
      lane.look();
      switch (location.get()) {
        case RESUME -> {
          if (gvh.gps.hasFix()) {
            mutex.standsIn(myseq.occupied());
            lane.beginAnew(myseq.resume());
            myseq.tell();
            location.set(lane.isAtTheHead() ? Location.S_0 : Location.QUEUE);
          }
        }
        case QUEUE -> {
          if (gvh.gps.hasFix()) {
            lane.drive(this::arrivedOrRetried);
            if (lane.isAtTheHead()) {
              location.set(Location.S_0);
            }
          }
        }
        case S_0 -> {
          if (gvh.gps.hasFix()) {
            reg.do_register();
            location.set(Location.REGISTER_WAIT);
          }
        }
        case REGISTER_WAIT -> {
          if (reg.getList() instanceof RList.Agreed agreed) {
            plist = agreed.list();
            if (myseq.isEmpty()) {
              gvh.plat.moat.doMove(myseq.currentDestination());
              location.set(Location.S_1);
            } else {
              mutex.do_mutex(myseq.zones(), plist);
              location.set(Location.MUTEX_WAIT);
            }
          } else if (reg.failed().get()) {
            location.set(Location.S_0);
          }
        }
        case MUTEX_S -> {
          mutex.do_mutex(myseq.zones(), plist);
          location.set(Location.MUTEX_WAIT);
        }
        case MUTEX_WAIT -> {
          if (mutex.od_mutex() && !lane.isWaiting()) { // also for a place that the car stands in
            if (startedAnew()) {
              mutex.standsIn(List.of()); // who it was before need not keep anything any more
            }
            gvh.plat.moat.doMove(myseq.currentDestination());
            location.set(Location.MOVE_WAIT);
          } else if (!mutex.od_mutex() && mutex.failed().get()) {
            location.set(mutex.failure().get().mustRegister() ? Location.S_0 : Location.MUTEX_S);
          }
        }
        case MOVE_WAIT -> {
          if (arrivedOrRetried(myseq.currentDestination())) {
            giveBackWhatIsBehind();
            myseq.remove();
            gvh.plat.moat.doMove(myseq.currentDestination());
            location.set(myseq.isEmpty() ? Location.S_1 : Location.MOVE_WAIT);
          }
        }
        case S_1 -> {
          if (arrivedOrRetried(myseq.currentDestination())) {
            giveBackWhatIsBehind();
            if (myseq.isAllLeft() && !lane.holds()) {
              reg.unregister();
              gvh.plat.moat.motion_stop();
              location.set(Location.UNREGISTER_WAIT);
            }
          }
        }
        case UNREGISTER_WAIT -> {
          if (reg.isUnregistered() && lane.isOver()) {
            location.set(Location.DONE);
          } else if (reg.failed().get()) {
            reg.unregister();
          }
        }
        case DONE -> throw new IllegalStateException("the loop has ended");
      }
      sleep(PERIOD_MS);
    }
    return returnResults();
  }

  private Location start(Trip trip) {
    if (trip.stations().isEmpty()) {
      return Location.DONE;
    }
    if (startedAnew()) {
      return Location.RESUME;
    }
    lane.begin();
    return lane.isAtTheHead() ? Location.S_0 : Location.QUEUE;
  }

  private boolean startedAnew() {
    return gvh.id.boot() > 1;
  }

  /** Whether the car is at {@code destination}; one that was stopped on its way sets out again. */
  private boolean arrivedOrRetried(ItemPosition destination) {
    MotionFlag flag = gvh.plat.moat.motionflag().get();
    if (flag == MotionFlag.FAIL) {
      sleep(RETRY_MS);
      gvh.plat.moat.doMove(destination);
    }
    return flag == MotionFlag.DONE;
  }

  private void giveBackWhatIsBehind() {
    lane.giveBackWhatIsBehind();
    myseq.left().forEach(mutex::release);
  }
}
