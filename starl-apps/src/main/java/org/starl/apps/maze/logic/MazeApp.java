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
 * One robot in the maze (paper, section 5.4): it goes to its goals in turn, and says of each whether
 * it got there, standing at it, or back where it stood before. See the package for why what it says
 * is true. What lies between two sleeps is one atomic action.
 */
public final class MazeApp extends LogicThread {

  /** The mutex's instance. */
  public static final String FLOOR = "floor";

  private static final long PERIOD_MS = 100;
  private static final long RETRY_MS = 1_000;
  private static final MutexTimes DAY = MutexTimes.DEFAULT.withDeadlineMs(24L * 3600 * 1000);

  private final Errand errand;
  private final MutexPrim mutex;
  private final Ride ride;
  private final Footprint footprint;
  private final GvhCell<Location> location;
  private final MazeTrace trace;
  private final Knowledge known;
  private final Agenda agenda;

  private Path path;

  public MazeApp(GlobalVarHolder gvh, Errand errand) {
    super(gvh);
    this.errand = errand;
    mutex = new M_Mutex(gvh, FLOOR, M_Mutex.closedGroup(gvh, gvh.id.participants()), DAY);
    ride = new Ride(gvh);
    double bodyMm = gvh.plat.moat.parameters().robotRadiusMm();
    footprint = new Footprint(errand.blocks(), bodyMm, errand.mode().wanderMm());
    location = gvh.variable(MazeTrace.SOURCE, MazeTrace.LOCATION, Location.START);
    trace = new MazeTrace(gvh);
    known = new Knowledge(gvh, errand, ride, trace);
    agenda = new Agenda(errand);
    path = new Path(List.of(errand.start(), errand.start()));
  }

  @Override
  public List<Object> callStarL() {
    while (location.get() != Location.DONE) {
      switch (location.get()) {
        case START -> location.set(known.isPlaceCertain() ? Location.CHOOSE : Location.START);
        case CHOOSE -> choose();
        case ASK -> {
          mutex.do_mutex(agenda.needsAll() ? errand.blocks().all() : footprint.along(path));
          location.set(Location.ASK_WAIT);
        }
        case ASK_WAIT -> {
          if (mutex.od_mutex()) {
            drive(path);
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
    trace.toward(agenda.isDone() ? "" : agenda.goal().name());
    if (agenda.isDone()) {
      location.set(Location.DONE);
      return;
    }
    switch (found(known.searchTo(agenda.to())::anywhere)) {
      case Search.Outcome.Way way -> {
        path = way.path();
        trace.way(path);
        location.set(Location.ASK);
      }
      case Search.Outcome.NoWay no -> answer(Answer.NO_WAY);
      case Search.Outcome.Lost from -> answer(Answer.GAVE_UP);
    }
  }

  private void drive(Path way) {
    trace.way(way);
    CollisionMode mode = agenda.goesBack() ? errand.mode().goingBack() : errand.mode();
    ride.along(way, agenda.toleranceMm(), mode);
    location.set(Location.DRIVE);
  }

  private void drives(Runnable arrived) {
    switch (ride.look()) {
      case UNDER_WAY -> {}
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
    trace.noWay();
    Answer answer = agenda.arrived();
    if (answer != null) {
      answer(answer);
    }
    location.set(Location.CHOOSE);
  }

  private void planAgain() {
    Search search = known.searchTo(agenda.to());
    boolean isBack = agenda.goesBack();
    List<Polygon> outside = footprint.outside(mutex.held(), isBack);
    goOn(found(() -> isBack ? search.back(outside) : search.onward(outside)));
  }

  private void goOn(Search.Outcome outcome) {
    switch (outcome) {
      case Search.Outcome.Way found -> {
        if (!ride.mayTry(found)) {
          giveUp();
        } else if (agenda.goesBack() || mutex.held().containsAll(footprint.along(found.path()))) {
          drive(found.path());
        } else {
          agenda.backForAll();
        }
      }
      case Search.Outcome.NoWay no -> agenda.backForGood();
      case Search.Outcome.Lost from -> {
        if (ride.mayTry(from) && ride.retreat(known.belief())) {
          location.set(Location.RETREAT);
        } else {
          giveUp();
        }
      }
    }
  }

  private void answer(Answer answer) {
    trace.answer(agenda.answer(answer), answer);
    location.set(Location.CHOOSE);
  }

  /** Stays where it is, with the blocks that it stands in. */
  private void giveUp() {
    SortedSet<String> spare = footprint.spare(mutex.held(), gvh.gps.pose().at());
    if (!spare.isEmpty()) {
      mutex.release(spare);
    }
    while (!agenda.isDone()) {
      answer(Answer.GAVE_UP);
    }
  }

  /** Gives the strand up while it looks. */
  private Search.Outcome found(Supplier<Search.Outcome> search) {
    Computation<Search.Outcome> outcome = gvh.plat.compute(search);
    await(outcome::isDone);
    return outcome.result();
  }
}
