package org.starl.apps.lightpaint.logic;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Point;
import org.starl.gvh.GvhCell;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.TubeFlag;

/**
 * One painter (paper, section 5.4). It drives to the nearest free stroke, asks for it at an end of it,
 * claims a tube along it, and paints it with its light on. A painter that finds no stroke or no path,
 * or gets no tube, gives way: it waits at its home beside the drawing.
 *
 * <p>A stroke is assigned to one painter for ever. Before it asks for a stroke, a painter writes a
 * note on stable storage, and later how far it has painted: after a restart it continues where it
 * stopped, as its note and its position tell. If a painter never restarts, the rest of its stroke
 * stays unpainted: its body and its tube are in the way.
 */
public final class LightPaintApp extends LogicThread {

  private static final long PERIOD_MS = 100;
  private static final long PAUSE_MS = 1_000;

  private final DistributedPathPlanning paths;
  private final PainterMotion motion;
  private final Assignment assignment;
  private final CurrentWork work;
  private final GvhCell<Location> location;

  /**
   * @param home a place beside the drawing, of this robot alone
   */
  public LightPaintApp(GlobalVarHolder gvh, Painting painting, Point home) {
    super(gvh);
    gvh.plat.moat.setParameters(Painting.motion(gvh.plat.moat.parameters()));
    paths = painting.paths(gvh);
    assignment = new Assignment(gvh, painting.strokes(), 2.0 * paths.radiusMm());
    location = gvh.variable(PaintTrace.SOURCE, PaintTrace.LOCATION, Location.RESUME);
    motion = new PainterMotion(gvh, paths, home);
    work = new CurrentWork(gvh, painting.strokes());
  }

  /** Returns how many strokes it has painted, and how many it knows to be unassigned. */
  @Override
  public List<Object> callStarL() {
    while (location.get() != Location.DONE) {
      switch (location.get()) {
        case RESUME -> {
          if (gvh.gps.hasFix() && paths.isPlaced()) {
            work.resume(gvh.gps.pose().at());
            location.set(work.isNone() ? Location.PICK : Location.GO);
          }
        }
        case PICK -> pick();
        case GO -> go(work.get());
        case NOTE -> {
          if (work.isNoted()) {
            assignment.request(work.stroke());
            location.set(Location.ASK);
          }
        }
        case ASK -> {
          if (assignment.isOwn(work.stroke())) {
            begin(work.get());
          } else if (assignment.isOfAnother(work.stroke())) {
            drop();
          } else if (assignment.hasFailed(work.stroke())) {
            assignment.request(work.stroke());
          }
        }
        case PAINT -> paint();
        case LEAVE -> {
          if (work.isNoted()) {
            leave(work.get().isDone());
          }
        }
        case RETREAT -> {
          if (motion.goHome()) {
            sleep(PAUSE_MS);
            comeBack();
          }
        }
        case PARK -> {
          if (motion.goHome() || assignment.isHopelessForLong()) {
            location.set(Location.DONE);
          }
        }
        case DONE -> throw new IllegalStateException("the loop has ended");
      }
      work.traceNumber();
      assignment.sendHint(work.number());
      pause();
    }
    return List.of(assignment.finished(work.number()), assignment.unassigned());
  }

  private void pick() {
    Point here = gvh.gps.pose().at();
    Stroke free = assignment.nearestFree(here);
    if (assignment.unassigned() == 0 || assignment.isHopeless()) {
      location.set(Location.PARK);
    } else if (free == null) {
      location.set(Location.RETREAT);
    } else {
      work.set(Work.from(free, here));
      setOut();
    }
  }

  private void go(Work current) {
    if (assignment.isContested(current.stroke())) {
      paths.stop();
      drop();
    } else if (motion.isAt(current)) {
      work.note(true);
      location.set(Location.NOTE);
    } else if (paths.failed()) {
      assignment.postpone(current.stroke());
      leave(!assignment.isOwn(current.stroke()));
    } else if (!paths.isUnderWay()) {
      setOut();
    }
  }

  private void begin(Work current) {
    if (current.isDone()) {
      location.set(Location.LEAVE);
    } else if (motion.mayPaint(current)) {
      motion.paint(current);
      location.set(Location.PAINT);
    } else {
      location.set(Location.GO);
    }
  }

  private void paint() {
    switch (motion.keepPainting(work)) {
      case PAINTING -> work.noteProgress();
      case STOPPED -> setOut();
      case PAINTED, NO_TUBE -> {
        work.note(false);
        location.set(Location.LEAVE);
      }
    }
  }

  /** Leaves the stroke and picks another; or, not for good, gives way and keeps the stroke. */
  private void leave(boolean isForGood) {
    if (isForGood) {
      work.clear();
    }
    location.set(isForGood ? Location.PICK : Location.RETREAT);
  }

  private void drop() {
    work.drop();
    location.set(Location.PICK);
  }

  private void setOut() {
    motion.goTo(work.get());
    location.set(Location.GO);
  }

  private void comeBack() {
    if (assignment.isHopeless()) {
      location.set(Location.PARK);
    } else if (!work.isNone()) {
      if (!assignment.mustWait(work.stroke())) {
        setOut();
      }
    } else if (assignment.unassigned() == 0
        || assignment.nearestFree(gvh.gps.pose().at()) != null) {
      location.set(Location.PICK);
    }
  }

  /** Waits for the next period; while painting also for the tube: the light follows the wheels. */
  private void pause() {
    TubeFlag before = paths.tubeflag().get();
    await(() -> location.get() == Location.PAINT && paths.tubeflag().get() != before, PERIOD_MS);
  }
}
