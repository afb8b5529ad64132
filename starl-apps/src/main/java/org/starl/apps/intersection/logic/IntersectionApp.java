package org.starl.apps.intersection.logic;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.apps.intersection.logic.CrossingFact.Way;
import org.starl.geometry.ItemPosition;
import org.starl.gvh.GvhCell;
import org.starl.id.Participants;
import org.starl.motion.MotionFlag;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.primitives.registration.RegPrim;
import org.starl.primitives.registration.Registration;
import org.starl.random.Rng;

/**
 * One car at the automatic intersection: the paper's Figure 4, with its locations, which are also those
 * of the PVS theory in Figure 5. The code between two sleeps is one atomic action.
 *
 * <p>Differences from the figure, needed for safety:
 *
 * <ul>
 *   <li>The figure releases a zone when the car is not in motion. But a car that has bumped into
 *       something is not in motion either, and still stands in the zone. Here a zone is released only
 *       when the motion is DONE <em>and</em> the whole body is proven to be outside, position error
 *       included. After a FAIL the car keeps its zones and tries again.
 *   <li>A car that bumps backs off along the way that it came, up to 100 mm, but into no zone or place
 *       that it does not hold. It tries again after a random time: of two cars that have bumped into
 *       each other, one then goes first.
 *   <li>The figure's first release is of a zone that was never requested. Here nothing is released
 *       before the first critical zone is behind the car.
 *   <li>The car drives past its departure zone before it releases it, so the next car finds it free.
 *   <li>On an open road a car enters its arm behind other cars. In QUEUE it drives, place by place, to
 *       the arrival zone, where the figure begins.
 *   <li>A restarted program does not know how far the car has come. In RESUME it waits for a position
 *       fix, declares which zones its body may be in, so that the process before the restart keeps no
 *       others, and continues from the first of them. It may turn back to that zone's middle.
 *   <li>Unregistering takes messages, as registering does: the car waits for it in UNREGISTER_WAIT.
 *   <li>When a primitive gives up ({@code failed}), the car asks again: in MUTEX_S for its zones, in S_0
 *       for registration, also if the mutex failed because the car is no longer registered.
 * </ul>
 */
public final class IntersectionApp extends LogicThread {

  /** Figure 4's locations, and RESUME, QUEUE and UNREGISTER_WAIT. */
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
  private static final long LATEST_AFTER_BUMP_MS = 6000;

  private final GvhCell<Location> location;
  private final Course myseq;
  private final Lane lane;
  private final RegPrim reg;
  private final MutexPrim mutex;
  private final Rng rng;
  private boolean hasBumped;
  private Participants plist = Participants.of();

  /**
   * @param xid names this intersection: cars with another one are at another intersection
   * @param acceptors of the registrations: all cars of the deployment, or on an open road, where any
   *     car may arrive, the roadside units
   */
  public IntersectionApp(GlobalVarHolder gvh, String xid, Trip trip, Participants acceptors) {
    this(gvh, xid, trip, acceptors, zones -> zones);
  }

  /**
   * A car that asks for its zones in another way, for comparisons.
   *
   * @param rule makes the object that it asks, from the mutex over the zones
   */
  public IntersectionApp(
      GlobalVarHolder gvh,
      String xid,
      Trip trip,
      Participants acceptors,
      UnaryOperator<MutexPrim> rule) {
    super(gvh);
    Registration registration = new Registration(gvh, xid, acceptors);
    reg = registration;
    mutex = rule.apply(new M_Mutex(gvh, xid, registration));
    lane = new Lane(gvh, xid, trip.approach(), acceptors);
    gvh.trace.action(Way.SHAPE, Way.of(trip, trip.zones()));
    location = gvh.variable(CrossingFact.LOCATION, start(trip));
    GvhCell<List<String>> zonesAhead = gvh.variable(CrossingFact.MYSEQ, trip.zones());
    myseq = new Course(gvh, trip, zonesAhead::set);
    rng = gvh.plat.entropy.fork("app");
    gvh.plat.moat.setParameters(Crossing.motion(gvh.plat.moat.parameters()));
    gvh.plat.moat.setRetreatAvoid(() -> Crossing.others(gvh, own()));
    gvh.plat.moat.onContact(contact -> hasBumped = true);
  }

  @Override
  public List<Object> callStarL() {
    while (location.get() != Location.DONE) {
      lane.step();
      switch (location.get()) {
        case RESUME -> {
          if (gvh.gps.hasFix()) {
            mutex.standsIn(myseq.occupied());
            lane.resume(myseq.resume());
            myseq.tell();
            location.set(lane.isAtTheHead() ? Location.S_0 : Location.QUEUE);
          }
        }
        case QUEUE -> {
          if (gvh.gps.hasFix()) {
            lane.drive(this::hasArrived);
            location.set(lane.isAtTheHead() ? Location.S_0 : Location.QUEUE);
          }
        }
        case S_0 -> {
          if (gvh.gps.hasFix()) {
            reg.do_register();
            location.set(Location.REGISTER_WAIT);
          }
        }
        case REGISTER_WAIT -> {
          Participants list = reg.getList();
          if (list != null) {
            plist = list;
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
          if (mutex.od_mutex() && !lane.isWaiting()) { // the place that the car stands in, too
            if (isRestarted()) {
              mutex.standsIn(List.of()); // the claim of the earlier process is no longer needed
            }
            gvh.plat.moat.doMove(myseq.currentDestination());
            location.set(Location.MOVE_WAIT);
          } else if (!mutex.od_mutex() && mutex.failed().get()) {
            location.set(mutex.failure().get().mustRegister() ? Location.S_0 : Location.MUTEX_S);
          }
        }
        case MOVE_WAIT -> {
          if (hasArrived(myseq.currentDestination())) {
            releaseLeft();
            myseq.remove();
            gvh.plat.moat.doMove(myseq.currentDestination());
            location.set(myseq.isEmpty() ? Location.S_1 : Location.MOVE_WAIT);
          }
        }
        case S_1 -> {
          if (hasArrived(myseq.currentDestination())) {
            releaseLeft();
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
    if (isRestarted()) {
      return Location.RESUME;
    }
    lane.want();
    return lane.isAtTheHead() ? Location.S_0 : Location.QUEUE;
  }

  private boolean isRestarted() {
    return gvh.id.boot() > 1;
  }

  /** Whether the car is at {@code destination}; a car that was stopped on its way tries again. */
  private boolean hasArrived(ItemPosition destination) {
    MotionFlag flag = gvh.plat.moat.motionflag().get();
    if (flag == MotionFlag.FAIL) {
      sleep(hasBumped ? rng.nextLong(RETRY_MS, LATEST_AFTER_BUMP_MS) : RETRY_MS);
      hasBumped = false;
      gvh.plat.moat.doMove(destination);
    }
    return flag == MotionFlag.DONE;
  }

  /** The zones and places that the car holds. */
  private List<String> own() {
    List<String> own = new ArrayList<>(lane.held());
    own.addAll(mutex.held());
    return own;
  }

  /** Releases the zones and places behind that the whole body has left. */
  private void releaseLeft() {
    lane.releaseLeft();
    myseq.takeLeft().forEach(mutex::release);
  }
}
