package org.starl.apps.lightpaint.logic;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.gvh.GvhCell;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.OptimalPlanner;
import org.starl.primitives.paths.Path;
import org.starl.primitives.paths.TubeFailure;
import org.starl.primitives.paths.TubeFlag;
import org.starl.time.Time;

/**
 * One painter (paper, section 5.4). It drives to the nearest free stroke, asks for it at an end of
 * it, claims a tube along it, and paints it with its light on. A painter that finds no stroke or no
 * path, or gets no tube, gives way: it waits at its home beside the drawing.
 *
 * <p>A stroke is assigned to one painter for ever. Before it asks for a stroke, a painter writes a
 * note on stable storage, and later how far it has painted: after a restart it continues where it
 * stopped, as its note and its position tell. If a painter never restarts, the rest of its stroke
 * stays unpainted: its body and its tube are in the way.
 */
public final class LightPaintApp extends LogicThread {

  /** Instance of the tubes and of the hints. */
  public static final String XID = "lightpaint";

  private static final long PERIOD_MS = 100;
  private static final long PAUSE_MS = 200;
  private static final double HOME_MM = 100;
  private static final double FAR_AROUND = 1.5;
  private static final double ARRIVED_MM = 12;

  private static final long POSTPONE_NS = 20 * Time.NS_PER_S;
  private static final long PATIENCE_NS = 6 * Time.NS_PER_S;

  private final DistributedPathPlanning paths;
  private final Assignment assignment;
  private final CurrentWork work;
  private final ItemPosition home;
  private final GvhCell<Location> location;
  private final GvhCell<Light> light;

  /** Until when it waits at a stroke for others to make room. */
  private long patientToNs;

  /**
   * @param home a place beside the drawing, of this robot alone
   */
  public LightPaintApp(GlobalVarHolder gvh, Painting painting, Point home) {
    super(gvh);
    gvh.plat.moat.setParameters(Painting.motion(gvh.plat.moat.parameters()));
    paths =
        new DistributedPathPlanning(
            gvh,
            XID,
            gvh.id.participants(),
            new OptimalPlanner(),
            painting.floor(),
            Painting.TUBES);
    assignment = new Assignment(gvh, painting.strokes(), 2.0 * paths.radiusMm());
    location = gvh.variable(PaintFact.LOCATION, Location.RESUME);
    light = gvh.variable(PaintFact.LIGHT, Light.OFF);
    this.home = new ItemPosition("home", home.xMm(), home.yMm());
    work = new CurrentWork(gvh, painting.strokes());
  }

  /** Returns how many strokes it has painted, and how many it knows to be unassigned. */
  @Override
  public List<Object> callStarL() {
    while (location.get() != Location.DONE) {
      switch (location.get()) {
        case RESUME -> {
          if (gvh.gps.hasFix() && paths.isPlaced()) {
            work.resume(gvh.gps.pose().at(), gvh.gps.errorMm());
            if (work.isNone()) {
              location.set(Location.PICK);
            } else {
              // Asked for before the crash: it may be decided that this robot paints it.
              assignment.request(work.stroke());
              location.set(Location.ASK);
            }
          }
        }
        case PICK -> pick();
        case GO -> go();
        case ASK -> ask();
        case PAINT -> paint();
        case RETREAT -> {
          if (goHome()) {
            sleep(PAUSE_MS);
            comeBack();
          } else if (work.isNone() && nearestFree() != null) {
            paths.stop();
            location.set(Location.PICK);
          }
        }
        case PARK -> {
          if (goHome() || assignment.isHopelessForLong()) {
            location.set(Location.DONE);
          }
        }
        case DONE -> throw new IllegalStateException("the loop has ended");
      }
      if (location.get() != Location.RESUME) {
        boolean isGivingWay = location.get() == Location.RETREAT;
        assignment.sendHint(work.number(), isGivingWay, gvh.gps.pose().at());
      }
      pause();
    }
    return List.of(assignment.finished(work.number()), assignment.unassigned());
  }

  private void pick() {
    Stroke free = nearestFree();
    if (assignment.unassigned() == 0 || assignment.isHopeless()) {
      location.set(Location.PARK);
    } else if (free == null) {
      location.set(Location.RETREAT);
    } else {
      work.begin(free, gvh.gps.pose().at());
      setOut();
    }
  }

  private @Nullable Stroke nearestFree() {
    return assignment.nearestFree(gvh.gps.pose().at(), this::isClear);
  }

  /** Whether a tube along {@code stroke} would meet no tube of another robot, as far as known. */
  private boolean isClear(Stroke stroke) {
    return paths.taken().stream()
        .allMatch(taken ->
            stroke.path().distanceMm(taken.axis()) > taken.radiusMm() + paths.radiusMm() + 2);
  }

  private void go() {
    if (assignment.isContested(work.stroke(), gvh.gps.pose().at())) {
      paths.stop();
      leave(true);
    } else if (goesFarAround() && !assignment.wasPostponed(work.stroke())) {
      paths.stop();
      assignment.postpone(work.stroke(), PATIENCE_NS);
      leave(!assignment.isOwn(work.stroke()));
    } else if (isAtWork() && !assignment.isOwn(work.stroke()) && !isClear(work.stroke())) {
      long nowNs = gvh.plat.clock.nowNs();
      patientToNs = Math.min(patientToNs, nowNs + PATIENCE_NS);
      if (nowNs >= patientToNs) {
        assignment.postpone(work.stroke(), PATIENCE_NS);
        leave(true);
      }
    } else if (isAtWork()) {
      work.note(true);
      await(work::isNoted);
      assignment.request(work.stroke());
      location.set(Location.ASK);
    } else if (paths.failed()) {
      assignment.postpone(work.stroke(), POSTPONE_NS);
      leave(!assignment.isOwn(work.stroke()));
    } else if (!paths.isUnderWay()) {
      setOut();
    }
  }

  /** Whether it drives in a long tube around others, which would have to wait for it. */
  private boolean goesFarAround() {
    double directMm = gvh.gps.pose().at().distanceMm(work.next());
    return paths.held().stream()
        .anyMatch(tube -> Polyline.lengthMm(tube.points()) > FAR_AROUND * directMm + 1000);
  }

  /** Whether the painter has arrived where its work continues, and {@link #mayPaint}. */
  private boolean isAtWork() {
    boolean isNear = gvh.gps.pose().at().distanceMm(work.next()) <= ARRIVED_MM;
    boolean hasArrived = paths.tubeflag().get() == TubeFlag.DONE || isNear;
    return !paths.isUnderWay() && hasArrived && mayPaint();
  }

  /** Whether the painter is certainly near enough to claim a tube from where its work continues. */
  private boolean mayPaint() {
    double offMm = Painting.TUBES.positionErrorMm() + gvh.plat.moat.parameters().goalRadiusMm();
    return gvh.gps.maxDistanceMm(work.next()) <= offMm;
  }

  private void ask() {
    if (assignment.isOfAnother(work.stroke())) {
      leave(true);
    } else if (!assignment.isOwn(work.stroke())) {
      if (assignment.hasFailed(work.stroke())) {
        assignment.request(work.stroke());
      }
    } else if (work.isDone()) {
      leave(true);
    } else if (mayPaint()) {
      paths.goAlong(new Path(work.rest().points()));
      location.set(Location.PAINT);
    } else {
      location.set(Location.GO);
    }
  }

  private void paint() {
    shine();
    if (paths.isUnderWay()) {
      work.noteProgress();
    } else if (paths.failure().get() == TubeFailure.MOTION) {
      // Stopped on the stroke: stuck wheels, no fix.
      setOut();
    } else {
      if (!paths.failed()) {
        work.finish();
      }
      work.note(false);
      await(work::isNoted);
      leave(work.isDone());
    }
  }

  /** Switches the light, on exactly while the painter moves in its tube, and records progress. */
  private void shine() {
    if (paths.tubeflag().get() == TubeFlag.MOVING) {
      switchLight(Light.of(work.stroke()));
    }
    if (light.get().isOn()) {
      work.paintedTo(gvh.gps.pose().at());
    }
    if (!paths.isUnderWay()) {
      switchLight(Light.OFF);
    }
  }

  private void switchLight(Light now) {
    if (!now.equals(light.get())) {
      light.set(now);
      gvh.plat.light.show(now.rgb());
    }
  }

  /** Leaves the stroke and picks another; or, not for good, gives way and keeps the stroke. */
  private void leave(boolean isForGood) {
    if (isForGood) {
      work.drop();
    }
    location.set(isForGood ? Location.PICK : Location.RETREAT);
  }

  private void setOut() {
    Point next = work.next();
    patientToNs = Long.MAX_VALUE;
    paths.goTo(new ItemPosition("stroke" + work.number(), next.xMm(), next.yMm()));
    location.set(Location.GO);
  }

  /** Whether the painter is at home and holds only its place there; if not, it goes there. */
  private boolean goHome() {
    if (paths.isUnderWay()) {
      return false;
    }
    boolean isHome = gvh.gps.minDistanceMm(home.at()) <= HOME_MM;
    // A painter that was stopped on its way still holds the rest of its tube.
    if (isHome && paths.held().stream().allMatch(tube -> tube.points().size() == 1)) {
      return true;
    }
    // After an arrival the tube is given back once storage has flushed that. Setting out again
    // before would claim another tube, for ever if storage is slow.
    boolean isGivingBack = isHome && paths.tubeflag().get() == TubeFlag.DONE;
    if (!isGivingBack) {
      paths.goTo(home);
    }
    return false;
  }

  private void comeBack() {
    if (assignment.isHopeless()) {
      location.set(Location.PARK);
    } else if (!work.isNone()) {
      if (!assignment.mustWait(work.stroke()) && isClear(work.stroke())) {
        setOut();
      }
    } else if (assignment.unassigned() == 0 || nearestFree() != null) {
      location.set(Location.PICK);
    }
  }

  /** Waits for the next period; while painting also for the tube: the light follows the wheels. */
  private void pause() {
    TubeFlag before = paths.tubeflag().get();
    await(() -> location.get() == Location.PAINT && paths.tubeflag().get() != before, PERIOD_MS);
  }
}
