package org.starl.apps.lightpaint.logic;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Point;
import org.starl.gvh.GvhCell;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.TubeFlag;

/**
 * One painter (paper, section 5.4). It goes to the stroke that is nearest and free, is given it once
 * it stands at an end of it, claims a tube along it, and paints it with its light on. Whoever finds
 * no stroke, no way or gets no tube gives way: it waits in its own place beside the drawing.
 *
 * <p>A stroke is given to one painter for ever. What a painter has in hand, and how far it is, stands
 * in its note, written before it asks for the stroke: one that starts anew finds by its place and its
 * note where it stopped, and goes on from there. Where a painter is gone for good in mid-stroke, the
 * rest of that stroke is not painted: its body and its tube are in the way.
 */
public final class LightPaintApp extends LogicThread {

  private static final long PERIOD_MS = 100;
  private static final long PAUSE_MS = 1_000;

  private final DistributedPathPlanning paths;
  private final Trips trips;
  private final Board board;
  private final Brush brush;
  private final InHand inHand;
  private final GvhCell<Location> location;

  /**
   * @param home a place beside the drawing, this robot's own
   */
  public LightPaintApp(GlobalVarHolder gvh, Painting painting, Point home) {
    super(gvh);
    gvh.plat.moat.setParameters(Painting.motion(gvh.plat.moat.parameters()));
    paths = painting.paths(gvh);
    trips = new Trips(gvh, paths, home);
    board = new Board(gvh, painting.strokes(), 2.0 * paths.radiusMm());
    location = gvh.variable(PaintTrace.SOURCE, PaintTrace.LOCATION, Location.RESUME);
    brush = new Brush(gvh, paths);
    inHand = new InHand(gvh, painting.strokes());
  }

  /** Returns how many strokes it has painted, and how many nobody had taken as far as it knows. */
  @Override
  public List<Object> callStarL() {
    while (location.get() != Location.DONE) {
      switch (location.get()) {
        case RESUME -> {
          if (gvh.gps.hasFix() && paths.isPlaced()) {
            inHand.resume(gvh.gps.pose().at());
            location.set(inHand.isNothing() ? Location.PICK : Location.GO);
          }
        }
        case PICK -> pick();
        case GO -> go(inHand.work());
        case NOTE -> {
          if (inHand.isNoted()) {
            board.ask(inHand.stroke());
            location.set(Location.ASK);
          }
        }
        case ASK -> {
          if (board.isMine(inHand.stroke())) {
            begin(inHand.work());
          } else if (board.isOthers(inHand.stroke())) {
            drop();
          } else if (board.hasGivenUp(inHand.stroke())) {
            board.ask(inHand.stroke());
          }
        }
        case PAINT -> paint();
        case LEAVE -> {
          if (inHand.isNoted()) {
            leave(inHand.work().isDone());
          }
        }
        case RETREAT -> {
          if (trips.isBack()) {
            sleep(PAUSE_MS);
            comeBack();
          }
        }
        case PARK -> {
          if (trips.isBack() || board.isLongHopeless()) {
            location.set(Location.DONE);
          }
        }
        case DONE -> throw new IllegalStateException("the loop has ended");
      }
      inHand.tell();
      board.tell(inHand.number());
      rest();
    }
    return List.of(board.finished(inHand.number()), board.left());
  }

  private void pick() {
    Point here = gvh.gps.pose().at();
    Stroke free = board.nearestFree(here);
    if (board.left() == 0 || board.isHopeless()) {
      location.set(Location.PARK);
    } else if (free == null) {
      location.set(Location.RETREAT);
    } else {
      inHand.take(Work.from(free, here));
      setOut();
    }
  }

  private void go(Work work) {
    if (board.isContested(work.stroke())) {
      paths.stop();
      drop();
    } else if (trips.isThere(work)) {
      inHand.note(true);
      location.set(Location.NOTE);
    } else if (paths.failed()) {
      board.later(work.stroke());
      leave(!board.isMine(work.stroke()));
    } else if (!paths.isUnderWay()) {
      setOut();
    }
  }

  private void begin(Work work) {
    if (work.isDone()) {
      location.set(Location.LEAVE);
    } else if (trips.mayBegin(work)) {
      brush.along(work);
      location.set(Location.PAINT);
    } else {
      location.set(Location.GO);
    }
  }

  private void paint() {
    switch (brush.look(inHand)) {
      case UNDER_WAY -> inHand.noteProgress();
      case HELD_UP -> setOut();
      case PAINTED, NO_TUBE -> {
        inHand.note(false);
        location.set(Location.LEAVE);
      }
    }
  }

  /** Gives way, and keeps the stroke in hand; or lets go of it, and picks another. */
  private void leave(boolean isForGood) {
    if (isForGood) {
      inHand.letGo();
    }
    location.set(isForGood ? Location.PICK : Location.RETREAT);
  }

  private void drop() {
    inHand.drop();
    location.set(Location.PICK);
  }

  private void setOut() {
    trips.to(inHand.work());
    location.set(Location.GO);
  }

  private void comeBack() {
    if (board.isHopeless()) {
      location.set(Location.PARK);
    } else if (inHand.isNothing() && board.isWorthALook(gvh.gps.pose().at())) {
      location.set(Location.PICK);
    } else if (!inHand.isNothing() && !board.mustWait(inHand.stroke())) {
      setOut();
    }
  }

  /** While it paints it must not be late: the light goes on and off as the wheels do. */
  private void rest() {
    TubeFlag before = paths.tubeflag().get();
    await(() -> location.get() == Location.PAINT && paths.tubeflag().get() != before, PERIOD_MS);
  }
}
