package org.starl.apps.lightpaint.logic;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.GvhCell;
import org.starl.LogicThread;
import org.starl.geometry.Point;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.OptimalPlanner;
import org.starl.primitives.paths.Path;
import org.starl.primitives.paths.TubeFailure;
import org.starl.primitives.paths.TubeFlag;

/**
 * One painter (paper, section 5.4). It goes to the stroke that is nearest and free, is given it once
 * it stands at an end of it, claims a tube along it, and paints it with its light on. Whoever finds
 * no stroke, no way or gets no tube gives way: it waits in its own place beside the drawing.
 *
 * <p>A stroke is given to one painter for ever. What a painter has in hand, and how far it is, stands
 * in its notes, written before it asks for the stroke: one that starts anew finds by its place and its
 * note where it stopped, and goes on from there. Where a painter is gone for good in mid-stroke, the
 * rest of that stroke is not painted: its body and its tube are in the way.
 */
public final class LightPaintApp extends LogicThread {

  /** Where a painter is in its work. */
  public enum Location {
    RESUME,
    PICK,
    GO,
    NOTE,
    ASK,
    PAINT,
    LEAVE,
    RETREAT,
    PARK,
    DONE
  }

  private static final long PERIOD_MS = 100;
  private static final long PAUSE_MS = 1_000;

  /** Where nothing becomes of the work for so long, something is in the way that will not move. */
  private static final long GIVE_UP_NS = 240_000_000_000L;

  private final Painting painting;
  private final DistributedPathPlanning paths;
  private final Trips trips;
  private final Board board;
  private final Notes notes;
  private final GvhCell<Location> location;
  private final GvhCell<Light> light;
  private final GvhCell<Integer> target;

  private @Nullable Work work;

  /**
   * @param home a place beside the drawing, this robot's own
   */
  public LightPaintApp(GlobalVarHolder gvh, Painting painting, Point home) {
    super(gvh);
    this.painting = painting;
    gvh.plat.moat.setParameters(Painting.motion(gvh.plat.moat.parameters()));
    paths =
        new DistributedPathPlanning(
            gvh,
            "lightpaint",
            gvh.id.participants(),
            new OptimalPlanner(),
            painting.floor(),
            Painting.TUBES);
    trips = new Trips(gvh, paths, home);
    board = new Board(gvh, painting.strokes(), 2.0 * paths.radiusMm());
    notes = new Notes(gvh.plat.stable);
    location = gvh.variable(PaintTrace.SOURCE, PaintTrace.LOCATION, Location.RESUME);
    light = gvh.variable(PaintTrace.SOURCE, PaintTrace.LIGHT, Light.OFF);
    target = gvh.variable(PaintTrace.SOURCE, PaintTrace.STROKE, Hint.NONE);
  }

  @Override
  public List<Object> callStarL() {
    while (location.get() != Location.DONE) {
      switch (location.get()) {
        case RESUME -> {
          if (gvh.gps.hasFix() && paths.isPlaced()) {
            work = notes.read(painting.strokes(), gvh.gps.pose().at());
            location.set(work == null ? Location.PICK : Location.GO);
          }
        }
        case PICK -> pick();
        case GO -> go(work());
        case NOTE -> {
          if (notes.isSafe()) {
            board.ask(work().stroke());
            location.set(Location.ASK);
          }
        }
        case ASK -> {
          if (board.isMine(work().stroke())) {
            begin(work());
          } else if (board.painter(work().stroke()) != null) {
            drop();
          } else if (board.hasGivenUp(work().stroke())) {
            board.ask(work().stroke());
          }
        }
        case PAINT -> paint(work());
        case LEAVE -> {
          if (notes.isSafe()) {
            boolean isDone = work().isDone();
            work = isDone ? null : work;
            location.set(isDone ? Location.PICK : Location.RETREAT);
          }
        }
        case RETREAT -> {
          if (trips.isBack()) {
            sleep(PAUSE_MS);
            comeBack();
          }
        }
        case PARK -> {
          if (trips.isBack() || board.silenceNs() > 2 * GIVE_UP_NS) {
            location.set(Location.DONE);
          }
        }
        case DONE -> throw new IllegalStateException("the loop has ended");
      }
      tell();
      rest();
    }
    return returnResults();
  }

  /** How many strokes it has painted, and how many nobody had taken as far as it knows. */
  @Override
  protected List<Object> returnResults() {
    int inHand = work != null && board.isMine(work.stroke()) ? 1 : 0;
    return List.of(board.mine() - inHand, board.left());
  }

  private void pick() {
    Point here = gvh.gps.pose().at();
    Stroke free = board.nearestFree(here);
    if (board.left() == 0 || isHopeless()) {
      location.set(Location.PARK);
    } else if (free == null) {
      location.set(Location.RETREAT);
    } else {
      work = Work.from(free, here);
      trips.to(work);
      location.set(Location.GO);
    }
  }

  /** To where the work goes on. */
  private void go(Work now) {
    boolean isMine = board.isMine(now.stroke());
    boolean isOthers = !isMine && board.painter(now.stroke()) != null;
    if (isOthers || (!isMine && board.isContested(now.stroke()))) {
      paths.stop();
      drop();
    } else if (paths.isUnderWay()) {
      return;
    } else if (trips.mayBegin(now)
        && (paths.tubeflag().get() == TubeFlag.DONE || trips.isAt(now))) {
      notes.write(now, true);
      location.set(Location.NOTE);
    } else if (paths.failed()) {
      board.later(now.stroke());
      location.set(isMine ? Location.RETREAT : Location.PICK);
      work = isMine ? now : null;
    } else {
      trips.to(now);
    }
  }

  private void begin(Work now) {
    if (now.isDone()) {
      location.set(Location.LEAVE);
    } else if (trips.mayBegin(now)) {
      paths.goAlong(new Path(now.rest().points()));
      location.set(Location.PAINT);
    } else {
      location.set(Location.GO);
    }
  }

  private void paint(Work now) {
    if (paths.tubeflag().get() == TubeFlag.MOVING) {
      light.set(Light.of(now.stroke()));
    }
    boolean isLit = light.get().isOn();
    work = isLit ? now.reached(gvh.gps.pose().at()) : now;
    if (paths.isUnderWay()) {
      notes.progress(work());
      return;
    }
    light.set(Light.OFF);
    if (paths.failure().get() == TubeFailure.MOTION) {
      trips.to(work());
      location.set(Location.GO);
    } else {
      work = paths.failed() ? work : now.finished();
      notes.write(work(), false);
      location.set(Location.LEAVE);
    }
  }

  private void comeBack() {
    Work now = work;
    if (isHopeless()) {
      location.set(Location.PARK);
    } else if (now == null) {
      if (board.left() == 0 || board.nearestFree(gvh.gps.pose().at()) != null) {
        location.set(Location.PICK);
      }
    } else if (!board.mustWait(now.stroke())) {
      trips.to(now);
      location.set(Location.GO);
    }
  }

  private boolean isHopeless() {
    return board.silenceNs() > GIVE_UP_NS;
  }

  private void drop() {
    work = null;
    notes.clear();
    location.set(Location.PICK);
  }

  private Work work() {
    if (work == null) {
      throw new IllegalStateException("nothing in hand in " + location.get());
    }
    return work;
  }

  private void tell() {
    Work now = work;
    target.set(now == null ? Hint.NONE : now.stroke().number());
    board.tell(target.get(), now != null && board.isMine(now.stroke()));
  }

  /** While it paints it must not be late: the light goes on and off as the wheels do. */
  private void rest() {
    TubeFlag before = paths.tubeflag().get();
    if (location.get() == Location.PAINT) {
      await(() -> paths.tubeflag().get() != before, PERIOD_MS);
    } else {
      sleep(PERIOD_MS);
    }
  }
}
