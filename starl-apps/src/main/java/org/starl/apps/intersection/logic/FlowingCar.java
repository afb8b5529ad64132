package org.starl.apps.intersection.logic;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.apps.intersection.logic.CrossingFact.Way;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
import org.starl.body.MotionParameters;
import org.starl.geometry.Angles;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.gvh.GvhCell;
import org.starl.id.Participants;
import org.starl.motion.MotionFlag;
import org.starl.random.Rng;
import org.starl.time.Time;

/**
 * One car that keeps moving. It registers when it comes onto its arm, asks for its zones as one sequence
 * ({@link org.starl.primitives.mutex.PipelinePrim}), drives on while it holds the next zone, turns in an
 * arc, and releases each zone when the last of its body is certainly outside. A car that does not hold
 * the next zone stops before it: it drives only to points from which its body touches no other zone, and
 * the motion's guard keeps it out of all that it does not hold.
 *
 * <p>It asks late: near its first zone, when no other car wants that, but for one that is about to leave
 * it, and few want the zones behind; or when it has waited long. A car that asked early would hold up
 * others, which come after it, with zones that it cannot reach yet. This is about time only.
 *
 * <p>A restarted program finds the sections that the body may be in, resumes the rest of its sequence from
 * there, and turns on the spot.
 */
public final class FlowingCar extends LogicThread {

  private static final long PERIOD_MS = 50;
  private static final long PATIENCE_NS = 25 * Time.NS_PER_S;

  // It asks from here on: a second or two before its front is at the first zone.
  private static final double ASKS_WITHIN_MM = 2 * Crossing.LANE_MM;

  // So many others may come before it in each zone.
  private static final int MOST_BEFORE = 2;

  private static final long RETRY_NS = Time.NS_PER_S;
  private static final long LATEST_AFTER_BUMP_NS = 6 * Time.NS_PER_S;
  private static final long OFF_FLOOR_NS = Time.NS_PER_S / 2;
  private static final double NEAR_MM = 30;

  private final Trip trip;
  private final GvhCell<Location> location;
  private final GvhCell<List<String>> myseq;
  private final Track track;
  private final Lane lane;
  private final Claim claim;
  private final Rng rng;
  private final MotionParameters straight;
  private final MotionParameters arcing;
  private boolean hasBegun;
  private boolean hasBumped;

  // The straight run begins at this section; all before it are behind.
  private int from;
  private @Nullable Point arcEnd;
  private boolean turnsOnTheSpot;
  private boolean isOffTrack;
  private @Nullable Point goal;
  private long retryAtNs;
  private long atTheHeadSinceNs = Long.MAX_VALUE;

  /**
   * @param xid names this intersection: cars with another one are at another intersection
   * @param acceptors of the registrations: all cars of the deployment, or on an open road, where any
   *     car may arrive, the roadside units
   */
  public FlowingCar(GlobalVarHolder gvh, String xid, Trip trip, Participants acceptors) {
    super(gvh);
    this.trip = trip;
    claim = new Claim(gvh, xid, acceptors, this::mayAsk);
    lane = new Lane(gvh, xid, trip.approach(), acceptors);
    track = new Track(trip, gvh.plat.moat.parameters().robotRadiusMm());
    gvh.trace.action(Way.SHAPE, Way.of(trip, trip.zones()));
    Location start = gvh.id.boot() == 1 ? Location.QUEUE : Location.RESUME;
    location =
        gvh.variable(CrossingFact.LOCATION, trip.stations().isEmpty() ? Location.DONE : start);
    myseq = gvh.variable(CrossingFact.MYSEQ, trip.zones());
    rng = gvh.plat.entropy.fork("app");
    MotionParameters body = Crossing.motion(gvh.plat.moat.parameters());
    straight =
        body.toBuilder()
            .constantSpeed()
            .arcSpeedMaxMmPerS(body.linSpeedMaxMmPerS())
            .arcAngleMaxRad(Angles.fromDegrees(10))
            .build();
    arcing =
        straight.toBuilder()
            .arcAngleMaxRad(Angles.fromDegrees(60))
            .arcExitAngleRad(Angles.fromDegrees(75))
            .build();
    gvh.plat.moat.setRetreatAvoid(() -> Crossing.others(gvh, own()));
    gvh.plat.moat.onContact(contact -> hasBumped = true);
  }

  @Override
  public List<Object> callStarL() {
    while (location.get() != Location.DONE) {
      if (!hasBegun && gvh.gps.hasFix()) {
        begin();
      }
      if (hasBegun) {
        lane.step();
        claim.step();
        if (gvh.gps.hasFix()) {
          releaseLeft();
          drive();
        }
        tell();
      }
      sleep(PERIOD_MS);
    }
    return returnResults();
  }

  /** The car is on the floor. */
  private void begin() {
    hasBegun = true;
    if (gvh.id.boot() == 1) {
      lane.want();
      claim.want(trip.zones());
    } else {
      resume();
    }
  }

  /** After a restart of the program: finds the sections that the body may be in. */
  private void resume() {
    List<String> stands = new ArrayList<>(trip.zones());
    stands.removeIf(zone -> Crossing.hasLeft(gvh, zone));
    boolean isBeyond = stands.isEmpty() && isIn(track.sections().size());
    List<String> rest = new ArrayList<>(isBeyond ? List.of() : trip.zones());
    while (!stands.isEmpty() && !rest.get(0).equals(stands.get(0))) {
      rest.remove(0);
    }
    claim.resume(stands, rest);
    boolean isPast = isBeyond || !stands.isEmpty();
    lane.resume(isPast);
    from = track.sections().size() - rest.size() - (isPast ? 0 : lane.placesAhead());
    turnsOnTheSpot = isPast;
    gvh.trace.action(Way.SHAPE, Way.of(trip, rest));
  }

  /** Whether asking now holds up no other car. */
  private boolean mayAsk() {
    if (!isAtTheHead() || !gvh.gps.hasFix()) {
      return false;
    }
    long nowNs = gvh.plat.clock.nowNs();
    atTheHeadSinceNs = Math.min(atTheHeadSinceNs, nowNs);
    if (nowNs - atTheHeadSinceNs > PATIENCE_NS) {
      return true;
    }
    String first = claim.rest().get(0);
    double awayMm = gvh.gps.pose().at().distanceMm(Crossing.region(first).center());
    if (awayMm > ASKS_WITHIN_MM || isUsed(first)) {
      return false;
    }
    return claim.rest().stream().allMatch(zone -> claim.contenders(zone) <= MOST_BEFORE);
  }

  /** Whether others want its first zone, but for one that is in it with its whole body. */
  private boolean isUsed(String first) {
    return claim.contenders(first) > 1
        || trip.route()
            .filter(r -> claim.contenders(first, r.from().before().name()) > 0)
            .isPresent();
  }

  /** Whether it may drive to the arrival zone, or is there. */
  private boolean isAtTheHead() {
    return held(from) >= trip.approach().size() - 1;
  }

  /** The last of the sections from {@code first} on that it holds without a gap; else the one before. */
  private int held(int first) {
    int index = first;
    while (index < track.sections().size() && holds(index)) {
      index++;
    }
    return index - 1;
  }

  private boolean holds(int index) {
    String section = track.sections().get(index);
    return claim.held().contains(section) || lane.held().contains(section) || isLeft(section);
  }

  private boolean isLeft(String section) {
    return !claim.rest().contains(section) && !lane.rest().contains(section);
  }

  private void drive() {
    MotionFlag flag = gvh.plat.moat.motionflag().get();
    long nowNs = gvh.plat.clock.nowNs();
    if (flag == MotionFlag.FAIL && goal != null) {
      retryAtNs = nowNs + (hasBumped ? rng.nextLong(RETRY_NS, LATEST_AFTER_BUMP_NS) : RETRY_NS);
      hasBumped = false;
      turnsOnTheSpot = true;
      arcEnd = null;
      isOffTrack = true;
      goal = null;
    }
    if (nowNs >= retryAtNs && !returnsToTrack(flag)) {
      advance(flag);
    }
  }

  /** After a failure it may be beside its track: it drives to the middle of the section it is in first. */
  private boolean returnsToTrack(MotionFlag flag) {
    if (!isOffTrack) {
      return false;
    }
    int here = track.sections().size() - 1;
    while (here >= 0 && !isIn(here)) {
      here--;
    }
    if (here < 0 || !own().contains(track.sections().get(here))) {
      isOffTrack = false;
      return false;
    }
    Point middle = track.region(here).center();
    isOffTrack = flag != MotionFlag.DONE || !middle.equals(goal);
    if (isOffTrack) {
      moveTo(middle, straight);
    }
    return isOffTrack;
  }

  /** Finds the next point to drive to. */
  private void advance(MotionFlag flag) {
    int corner = track.corner(from);
    int reach = held(from);
    Point at = gvh.gps.pose().at();
    if (arcEnd != null) {
      if (flag == MotionFlag.DONE || at.distanceMm(arcEnd) < NEAR_MM) {
        arcEnd = null;
        from = corner + 1;
        advance(flag);
      }
    } else if (reach < corner || corner == track.sections().size()) {
      moveTo(reach);
    } else if (flag == MotionFlag.DONE && track.stop(corner).equals(goal)) {
      from = corner + 1;
      if (reach == corner && trip.route().isPresent()) {
        gvh.plat.moat.turnTo(station(track.stop(from))); // while it waits
      }
      moveTo(Math.min(reach, track.corner(from)));
    } else {
      // Into the zone of the turn also if it cannot leave that yet: it is clear of all others in
      // the middle.
      arcEnd = reach == corner || turnsOnTheSpot ? null : track.arcEnd(at);
      moveTo(arcEnd == null ? track.stop(corner) : arcEnd, arcEnd == null ? straight : arcing);
    }
  }

  private void moveTo(int index) {
    if (index >= from) {
      moveTo(track.stop(index), straight);
    }
  }

  private void moveTo(Point target, MotionParameters parameters) {
    if (!target.equals(goal)) {
      goal = target;
      gvh.plat.moat.setParameters(parameters);
      gvh.plat.moat.doMove(
          station(target), trip.route().isPresent() ? Crossing.others(gvh, own()) : new Nowhere());
    }
  }

  private static ItemPosition station(Point at) {
    return new ItemPosition("way", at.xMm(), at.yMm());
  }

  /** Releases the sections behind that the whole body has left: its middle is in a later one. */
  private void releaseLeft() {
    List<String> sections = track.sections();
    boolean isBehind = isIn(sections.size());
    for (int i = sections.size() - 1; i >= 0; i--) {
      boolean isOld = i < from && isLeft(sections.get(i));
      if (isBehind && !isOld && Crossing.hasLeft(gvh, sections.get(i))) {
        from = arcEnd != null ? from : Math.max(from, i + 1);
        lane.leave(sections.get(i));
        if (claim.leave(sections.get(i))) {
          gvh.trace.action(Way.SHAPE, Way.of(trip, claim.rest()));
        }
      }
      isBehind = isBehind || isIn(i);
    }
    claim.knows(zone -> Crossing.hasLeft(gvh, zone));
    lane.knowsPlace();
  }

  /** Whether its middle is in this section; after the last one, whether it is beyond all. */
  private boolean isIn(int index) {
    Point at = gvh.gps.pose().at();
    return index == track.sections().size()
        ? track.isBeyond(at, bodyMm())
        : track.region(index).contains(at);
  }

  private double bodyMm() {
    return gvh.plat.moat.parameters().robotRadiusMm();
  }

  /** The zones and places that the car holds. */
  private List<String> own() {
    List<String> own = new ArrayList<>(lane.held());
    own.addAll(claim.held());
    return own;
  }

  /** Writes how far it has come. */
  private void tell() {
    myseq.set(claim.rest());
    location.set(now());
  }

  private Location now() {
    if (claim.rest().isEmpty()) {
      if (gvh.plat.moat.inMotion() && gvh.gps.ageNs() > OFF_FLOOR_NS) {
        gvh.plat.moat.motion_stop();
      }
      boolean isOver = claim.isOver() && lane.isOver() && !gvh.plat.moat.inMotion();
      return isOver ? Location.DONE : Location.UNREGISTER_WAIT;
    }
    if (!claim.held().isEmpty()) {
      return claim.rest().size() == 1 ? Location.S_1 : Location.MOVE_WAIT;
    }
    if (claim.isAsking()) {
      return Location.MUTEX_WAIT;
    }
    if (!isAtTheHead()) {
      return Location.QUEUE;
    }
    return claim.isRegistered() ? Location.MUTEX_S : Location.REGISTER_WAIT;
  }
}
