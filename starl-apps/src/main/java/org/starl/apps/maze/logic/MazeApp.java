package org.starl.apps.maze.logic;

import java.util.List;
import java.util.SortedSet;
import java.util.function.Supplier;
import org.starl.Computation;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Polygon;
import org.starl.gvh.GvhCell;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.primitives.mutex.MutexTimes;
import org.starl.primitives.paths.Path;

/**
 * One robot in the maze (paper, section 5.4). It drives to its goals in turn. For each goal it
 * answers, at the goal or back at its resting place, whether it has reached it. The package
 * documentation says why the answers are true. The code between two sleeps is one atomic action.
 */
public final class MazeApp extends LogicThread {

  /** The program's locations. */
  public enum Location {
    START,
    /** Stands at its resting place, holds nothing, and searches a way to the next goal. */
    CHOOSE,
    ASK,
    ASK_WAIT,
    DRIVE,
    /** Has bumped, and learns from it. */
    FEEL,
    /** Stands in the blocks that it holds, and searches another way. */
    PLAN_AGAIN,
    /** Drives back on its trail, because no way was found from where it stood. */
    RETREAT,
    DONE
  }

  /** Instance of the mutex over the blocks. */
  public static final String FLOOR = "floor";

  private static final long PERIOD_MS = 100;
  private static final long RETRY_MS = 1_000;
  private static final MutexTimes DAY = MutexTimes.DEFAULT.withDeadlineMs(24L * 3600 * 1000);

  private final MazeTask task;
  private final double bodyMm;
  private final MutexPrim mutex;
  private final Ride ride;
  private final GvhCell<Location> location;
  private final Diary diary;
  private final Knowledge known;
  private final Agenda agenda;

  private Path path;

  public MazeApp(GlobalVarHolder gvh, MazeTask task) {
    super(gvh);
    this.task = task;
    bodyMm = gvh.plat.moat.parameters().robotRadiusMm();
    mutex = new M_Mutex(gvh, FLOOR, M_Mutex.closedGroup(gvh, gvh.id.participants()), DAY);
    ride = new Ride(gvh);
    location = gvh.variable(MazeFact.LOCATION, Location.START);
    diary = new Diary(gvh);
    known = new Knowledge(gvh, task, ride, diary);
    agenda = new Agenda(task);
    path = new Path(List.of(task.start(), task.start()));
  }

  @Override
  public List<Object> callStarL() {
    while (location.get() != Location.DONE) {
      switch (location.get()) {
        case START -> location.set(known.isPositionCertain() ? Location.CHOOSE : Location.START);
        case CHOOSE -> choose();
        case ASK -> {
          mutex.do_mutex(agenda.withNeeded(blocksFor(path)));
          location.set(Location.ASK_WAIT);
        }
        case ASK_WAIT -> {
          if (mutex.od_mutex()) {
            drive(path);
          } else if (known.hasClosed(path)) {
            mutex.withdraw();
            location.set(Location.CHOOSE);
          } else if (mutex.failed().get()) {
            location.set(Location.ASK);
          }
        }
        case DRIVE -> drives(this::arrived);
        case RETREAT -> drives(() -> location.set(Location.PLAN_AGAIN));
        case FEEL -> {
          boolean hasLearned = known.hasLearned(PERIOD_MS);
          location.set(hasLearned ? Location.PLAN_AGAIN : Location.FEEL);
        }
        case PLAN_AGAIN -> planAgain();
        case DONE -> throw new IllegalStateException("the loop has ended");
      }
      sleep(PERIOD_MS);
    }
    return agenda.answers();
  }

  private void choose() {
    diary.toward(agenda.isDone() ? "" : agenda.goal().name());
    if (agenda.isDone()) {
      location.set(Location.DONE);
      return;
    }
    switch (found(known.searchTo(agenda.to())::anywhere)) {
      case Search.Outcome.Way way -> {
        path = way.path();
        diary.way(path);
        location.set(Location.ASK);
      }
      case Search.Outcome.NoWay no -> answer(Answer.NO_WAY);
      case Search.Outcome.Lost lost -> answer(Answer.GAVE_UP);
    }
  }

  private void drive(Path way) {
    path = way;
    diary.way(way);
    CollisionMode mode = agenda.goesBack() ? task.mode().goingBack() : task.mode();
    ride.along(way, agenda.toleranceMm(), mode);
    location.set(Location.DRIVE);
  }

  private void drives(Runnable arrived) {
    switch (ride.step()) {
      case UNDER_WAY -> {
        if (known.hasClosed(path)) {
          ride.stop();
          location.set(Location.PLAN_AGAIN);
        }
      }
      case ARRIVED -> arrived.run();
      case BUMPED -> {
        known.bumped();
        location.set(Location.FEEL);
      }
      case HELD_UP -> {
        sleep(RETRY_MS);
        location.set(Location.PLAN_AGAIN);
      }
    }
  }

  private void arrived() {
    mutex.release(mutex.held());
    diary.noWay();
    Answer answer = agenda.arrived();
    if (answer != null) {
      answer(answer);
    }
    location.set(Location.CHOOSE);
  }

  private void planAgain() {
    Search search = known.searchTo(agenda.to());
    boolean isBack = agenda.goesBack();
    // The way back starts where the body already stands, which may be near the edge of its blocks.
    double reachMm = isBack ? bodyMm : bodyMm + task.mode().wanderMm();
    List<Polygon> forbidden = task.blocks().forbidden(mutex.held(), reachMm);
    switch (found(() -> isBack ? search.back(forbidden) : search.onward(forbidden))) {
      case Search.Outcome.Way way -> {
        if (!ride.mayTry(way)) {
          giveUp();
        } else if (isBack || mutex.held().containsAll(blocksFor(way.path()))) {
          drive(way.path());
        } else {
          agenda.backForMore(mutex.held(), blocksFor(way.path()));
        }
      }
      case Search.Outcome.NoWay no -> agenda.backForGood();
      case Search.Outcome.Lost lost -> {
        if (ride.mayTry(lost) && ride.retreat(known::isUnmarked)) {
          location.set(Location.RETREAT);
        } else {
          giveUp();
        }
      }
    }
  }

  private SortedSet<String> blocksFor(Path way) {
    return task.blocks().toRequest(way, bodyMm + task.mode().wanderMm());
  }

  private void answer(Answer answer) {
    diary.answer(agenda.answer(answer), answer);
    location.set(Location.CHOOSE);
  }

  /** Gives up all goals and stays where it is, with the blocks that it stands in. */
  private void giveUp() {
    SortedSet<String> spare = task.blocks().spare(mutex.held(), gvh.gps.pose().at(), bodyMm);
    if (!spare.isEmpty()) {
      mutex.release(spare);
    }
    while (!agenda.isDone()) {
      answer(Answer.GAVE_UP);
    }
  }

  /** Runs the search off the strand and waits for its result. */
  private Search.Outcome found(Supplier<Search.Outcome> search) {
    Computation<Search.Outcome> outcome = gvh.plat.compute(search);
    await(outcome::isDone);
    return outcome.result();
  }
}
