package org.starl.apps.intersection.logic;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.GlobalVarHolder;
import org.starl.apps.intersection.logic.CrossingFact.Way;
import org.starl.geometry.ItemPosition;
import org.starl.id.Participants;
import org.starl.motion.MotionFlag;
import org.starl.platform.Timer;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.random.Rng;
import org.starl.time.Time;

/**
 * Drives the car of {@link IcpProgram}: along its arm to the zones; then, when the program says so,
 * from zone to zone and past the last one. The program decides when, and knows zones by name; where
 * these are, and where the body is, is known here. A car that was stopped on its way tries again, as
 * that of {@link IntersectionApp} does. Strand only.
 */
final class Driver {

  private static final long PERIOD_NS = 100 * Time.NS_PER_MS;
  private static final long RETRY_NS = Time.NS_PER_S;
  private static final long LATEST_AFTER_BUMP_NS = 6 * Time.NS_PER_S;

  private enum State {
    /** After a restart: where the car stands is not known yet. */
    LOST,
    /** On its arm, or at the zones. */
    WAITING,
    /** Holds its zones, but perhaps not yet the place that it is in. */
    HOLDING,
    DRIVING,
    AT_EXIT
  }

  private final GlobalVarHolder gvh;
  private final Course course;
  private final Lane lane;
  private final MutexPrim mux;
  private final Rng rng;
  private final Timer timer;
  private State state;
  private boolean hasBumped;
  private long retryAtNs = Timer.NEVER;

  /**
   * @param mux of the zones
   */
  Driver(GlobalVarHolder gvh, String xid, Trip trip, Participants acceptors, MutexPrim mux) {
    this.gvh = gvh;
    this.mux = mux;
    gvh.trace.action(Way.SHAPE, Way.of(trip, trip.zones()));
    course = new Course(gvh, trip, zones -> {});
    lane = new Lane(gvh, xid, trip.approach(), acceptors);
    rng = gvh.plat.entropy.fork("app");
    gvh.plat.moat.setParameters(Crossing.motion(gvh.plat.moat.parameters()));
    gvh.plat.moat.setRetreatAvoid(() -> Crossing.others(gvh, own()));
    gvh.plat.moat.onContact(contact -> hasBumped = true);
    timer = gvh.plat.timers.timer(this::step);
    state = gvh.id.boot() > 1 ? State.LOST : State.WAITING;
    if (!trip.stations().isEmpty()) {
      if (state == State.WAITING) {
        lane.want();
      }
      timer.set(gvh.plat.clock.nowNs());
    }
  }

  /** The zones of a trip, in order; none if the car is parked. */
  static List<String> way(Trip trip) {
    return trip.zones();
  }

  /** Whether the car knows where it is, and has no other cars of its arm before it. */
  boolean isReady() {
    return state != State.LOST && gvh.gps.hasFix() && lane.isAtTheHead();
  }

  /** The zones that it has not driven through; after a restart, from the first in which it may be. */
  List<String> ahead() {
    return course.zones();
  }

  /**
   * Drives through the zones ahead, and past the last one, as soon as it holds the place in which it
   * stands, too.
   *
   * @param zones which it may enter until it has left them
   * @throws IllegalArgumentException if not all zones ahead are among them
   */
  void drive(Collection<String> zones) {
    if (!zones.containsAll(course.zones())) {
      throw new IllegalArgumentException(
          "drive through " + zones + ": expected " + course.zones() + " among them");
    }
    if (gvh.id.boot() > 1) {
      mux.standsIn(List.of()); // the claim of the earlier process is no longer needed
    }
    state = State.HOLDING;
  }

  /** The zones that it has driven through, and has left with its whole body for certain. */
  SortedSet<String> left() {
    return new TreeSet<>(course.left());
  }

  /** Whether it stands past all zones, and has nothing to do with its arm any more. */
  boolean isAtExit() {
    return state == State.AT_EXIT && lane.isOver();
  }

  private void step() {
    lane.step();
    switch (state) {
      case LOST -> {
        if (gvh.gps.hasFix()) {
          mux.standsIn(course.occupied());
          lane.resume(course.resume());
          course.tell();
          state = State.WAITING;
        }
      }
      case WAITING -> {
        if (gvh.gps.hasFix() && !lane.isAtTheHead()) {
          lane.drive(this::hasArrived);
        }
      }
      case HOLDING -> {
        if (!lane.isWaiting()) {
          state = State.DRIVING;
          gvh.plat.moat.doMove(course.currentDestination());
        }
      }
      case DRIVING -> {
        if (hasArrived(course.currentDestination())) {
          lane.releaseLeft();
          driveOn();
        }
      }
      case AT_EXIT -> lane.releaseLeft();
    }
    if (!isAtExit()) {
      timer.set(gvh.plat.clock.nowNs() + PERIOD_NS);
    }
  }

  private void driveOn() {
    if (course.isEmpty()) {
      state = State.AT_EXIT;
    } else {
      course.remove();
      gvh.plat.moat.doMove(course.currentDestination());
    }
  }

  /** Whether the car is at {@code destination}; a car that was stopped tries again some time later. */
  private boolean hasArrived(ItemPosition destination) {
    MotionFlag flag = gvh.plat.moat.motionflag().get();
    long nowNs = gvh.plat.clock.nowNs();
    if (flag == MotionFlag.FAIL && retryAtNs == Timer.NEVER) {
      retryAtNs = nowNs + (hasBumped ? rng.nextLong(RETRY_NS, LATEST_AFTER_BUMP_NS) : RETRY_NS);
    } else if (flag == MotionFlag.FAIL && nowNs >= retryAtNs) {
      retryAtNs = Timer.NEVER;
      hasBumped = false;
      gvh.plat.moat.doMove(destination);
    }
    return flag == MotionFlag.DONE;
  }

  /** The zones and places that the car holds. */
  private List<String> own() {
    List<String> own = new ArrayList<>(lane.held());
    own.addAll(mux.held());
    return own;
  }
}
