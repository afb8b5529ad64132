package org.starl.apps.maze.logic;

import java.util.List;
import java.util.function.Supplier;
import org.starl.Computation;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Point;
import org.starl.gvh.GvhCell;
import org.starl.primitives.paths.Capsule;
import org.starl.primitives.paths.Path;
import org.starl.random.Rng;

/**
 * One robot in the maze (paper, section 5.4). It drives to its goals in turn. For each goal it
 * answers, at the goal or back at its resting place, whether it has reached it. The package
 * documentation says why the answers are true. The code between two sleeps is one atomic action.
 */
public final class MazeApp extends LogicThread {

  /** The program's locations. */
  public enum Location {
    START,
    /** Stands at its resting place, and searches a way to the next goal. */
    CHOOSE,
    /** Claims a tube along its way, and drives in it. */
    DRIVE,
    /** Has bumped, and learns from it. */
    FEEL,
    /** Stands away from its resting place, and searches a way. */
    PLAN_AGAIN,
    /** Drives to a place on its trail, or gives back all of its tube but where it stands. */
    RETREAT,
    DONE
  }

  private static final long PERIOD_MS = 100;
  private static final long RETRY_MS = 1_000;

  // A robot that is held up so often in a row makes way, or looks whether there is still a way.
  private static final int PATIENCE = 3;

  private final MazeTask task;
  private final Ride ride;
  private final GvhCell<Location> location;
  private final Diary diary;
  private final Knowledge known;
  private final Agenda agenda;
  private final Rng rng;

  /** Where it goes on if it gets no tube. */
  private Location before = Location.CHOOSE;

  /** The tubes that are in its way, while it waits. */
  private List<Capsule> inTheWay = List.of();

  private int heldUp;

  public MazeApp(GlobalVarHolder gvh, MazeTask task) {
    super(gvh);
    this.task = task;
    ride = new Ride(gvh, task);
    location = gvh.variable(MazeFact.LOCATION, Location.START);
    diary = new Diary(gvh);
    known = new Knowledge(gvh, task, ride, diary);
    agenda = new Agenda(task);
    rng = gvh.plat.entropy.fork("maze");
  }

  @Override
  public List<Object> callStarL() {
    while (location.get() != Location.DONE) {
      switch (location.get()) {
        case START -> location.set(mayBegin() ? Location.CHOOSE : Location.START);
        case CHOOSE -> choose();
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

  private boolean mayBegin() {
    return known.isPositionCertain() && ride.isPlaced();
  }

  private void choose() {
    diary.toward(agenda.isDone() ? "" : agenda.goal().name());
    if (agenda.isDone()) {
      location.set(Location.DONE);
    } else if (!waitsForTubes()) {
      search();
    }
  }

  private void search() {
    switch (found(known.searchTo(agenda.to())::onward)) {
      case Search.Outcome.Way way -> drive(way.path());
      case Search.Outcome.Taken taken -> {
        inTheWay = ride.taken();
        heldUp = 0;
      }
      case Search.Outcome.NoWay no -> answer(Answer.NO_WAY);
      case Search.Outcome.Lost lost -> answer(Answer.GAVE_UP);
    }
  }

  private void drive(Path way) {
    CollisionMode mode = agenda.goesBack() ? task.mode().goingBack() : task.mode();
    begin(way, agenda.toleranceMm(), mode, Location.DRIVE);
  }

  /** Sets out, if its position is certain enough for the tube; else it plans again. */
  private void begin(Path way, double lastMm, CollisionMode mode, Location next) {
    before = location.get();
    inTheWay = List.of();
    if (ride.along(way, lastMm, mode)) {
      diary.way(way);
      location.set(next);
    }
  }

  private void drives(Runnable arrived) {
    switch (ride.step()) {
      case UNDER_WAY -> {
        if (known.hasClosed(ride.way())) {
          ride.stop();
          location.set(Location.PLAN_AGAIN);
        }
      }
      case ARRIVED -> arrived.run();
      case PART_WAY -> location.set(Location.PLAN_AGAIN);
      case BUMPED -> {
        known.bumped();
        location.set(Location.FEEL);
      }
      case REFUSED -> {
        pause();
        location.set(before);
      }
      case HELD_UP -> {
        sleep(RETRY_MS);
        location.set(Location.PLAN_AGAIN);
      }
    }
  }

  private void arrived() {
    diary.noWay();
    Answer answer = agenda.arrived();
    if (answer != null) {
      answer(answer);
    }
    location.set(Location.CHOOSE);
  }

  private void planAgain() {
    if (agenda.isDone()) {
      location.set(Location.CHOOSE);
      return;
    }
    if (waitsForTubes()) {
      return;
    }
    Search search = known.searchTo(agenda.to());
    Search.Outcome outcome = found(agenda.goesBack() ? search::back : search::onward);
    switch (outcome) {
      case Search.Outcome.Way way -> {
        if (ride.mayTry(way)) {
          drive(way.path());
        } else {
          giveUp();
        }
      }
      case Search.Outcome.Taken taken -> {
        makeWay();
        inTheWay = ride.taken();
      }
      case Search.Outcome.NoWay no -> agenda.backForGood();
      case Search.Outcome.Lost lost -> {
        Point back = ride.mayTry(lost) ? ride.retreatTo(known::isUnmarked) : null;
        if (back == null) {
          giveUp();
        } else {
          retreat(new Path(List.of(gvh.gps.pose().at(), back)));
        }
      }
    }
  }

  /** Waits, if the tubes that were in its way still are, and not for too long. */
  private boolean waitsForTubes() {
    if (inTheWay.isEmpty() || heldUp > PATIENCE) {
      return false;
    }
    pause();
    heldUp++;
    return inTheWay.equals(ride.taken());
  }

  /**
   * Tubes of other robots are in its way: gives back its own, and after a while drives to a random
   * place on its trail, since two robots may wait for each other.
   */
  private void makeWay() {
    Point aside = heldUp > PATIENCE ? ride.somewhereOnTrail(rng) : null;
    if (heldUp > PATIENCE) {
      heldUp = 0;
    }
    if (aside == null) {
      if (!ride.isStill()) {
        stay();
      }
    } else if (found(known.searchTo(aside)::back) instanceof Search.Outcome.Way way) {
      retreat(way.path());
    }
  }

  /** Gives back all of its tube but where it stands. */
  private void stay() {
    Point here = gvh.gps.pose().at();
    retreat(new Path(List.of(here, here)));
  }

  private void retreat(Path way) {
    begin(way, Ride.PASS_MM, CollisionMode.BACK, Location.RETREAT);
  }

  /** A random time, so that robots that wait for each other do not try again in step. */
  private void pause() {
    sleep(rng.nextLong(RETRY_MS / 2, 2 * RETRY_MS));
  }

  private void answer(Answer answer) {
    diary.answer(agenda.answer(answer), answer);
    location.set(Location.CHOOSE);
  }

  /** Gives up all goals and stays where it is. */
  private void giveUp() {
    while (!agenda.isDone()) {
      answer(Answer.GAVE_UP);
    }
    stay();
  }

  /** Runs the search off the strand and waits for its result. */
  private Search.Outcome found(Supplier<Search.Outcome> search) {
    Computation<Search.Outcome> outcome = gvh.plat.compute(search);
    await(outcome::isDone);
    return outcome.result();
  }
}
