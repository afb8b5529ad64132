package org.starl.apps.maze.logic;

import static org.starl.apps.maze.logic.CollisionMode.BACK;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.starl.Computation;
import org.starl.GlobalVarHolder;
import org.starl.GvhCell;
import org.starl.LogicThread;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.RegionText;
import org.starl.motion.Contact;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.primitives.mutex.MutexTimes;
import org.starl.primitives.paths.Capsule;
import org.starl.primitives.paths.Path;

/**
 * One robot in the maze (paper, section 5.4): it goes to its goals in turn, and says of each whether
 * it got there. See the package for why what it says is true. What lies between two sleeps is one
 * atomic action.
 *
 * <p>At each goal it ends at the goal, or back where it stood before, holding nothing.
 */
public final class MazeApp extends LogicThread {

  /** What it is about. */
  public enum Location {
    START,
    /** Stands at its start or at a goal, holds nothing, and looks for a way to the next goal. */
    CHOOSE,
    ASK,
    ASK_WAIT,
    DRIVE,
    /** Has bumped, and learns from it. */
    FEEL,
    /** Stands somewhere in the blocks that it holds, and looks for a way on. */
    PLAN_AGAIN,
    /** Goes back on its trail, from where no way leads on. */
    RETREAT,
    DONE
  }

  /** What becomes of a goal. */
  public enum Answer {
    REACHED,
    /** There is none for a body that is wider by {@link Errand#MARGIN_MM}. */
    NO_WAY,
    /** It squeezed through a gap that is narrower, and does not find back. */
    GAVE_UP
  }

  /** {@code source} of this app's trace events. */
  public static final String SOURCE = "app";

  /** Variable: the location. */
  public static final String LOCATION = "location";

  /** Variable: the goal that it is after, or {@code home}; and the way there, as x,y>x,y. */
  public static final String TOWARD = "toward";

  public static final String WAY = "way";

  /** Action: a goal's name, the answer, how well the robot knows its place in mm. */
  public static final String ANSWER = "answer";

  /** Action: a polygon in which no centre of a body can be that is wider by the margin. */
  public static final String MARK = "mark";

  public static final String XID = "floor";

  private static final long PERIOD_MS = 100;
  private static final long RETRY_MS = 1_000;
  private static final long PATIENCE_MS = 24L * 3600 * 1000;

  /** After a contact it waits for a place that is as certain, but not for ever. */
  private static final double CERTAIN_MM = 30;

  private static final long LONGEST_FEEL_MS = 5_000;

  /** Blocks are asked for so far around a way, and ways are planned so far inside of them. */
  private static final double ASK_MM = 120;

  private static final double INSIDE_MM = 50;

  /** Whom a contact this near to another one's place tells of is not known. */
  private static final double NEAR_MM = 40;

  private static final double ROUTINE_MM = 20;
  private static final double LEAST_RETREAT_MM = 30;

  /** So often it tries to squeeze through, or to go back on its trail, one after the other. */
  private static final int TRIES_WHEN_LOST = 30;

  private final Errand errand;
  private final MutexPrim mutex;
  private final Ride ride;
  private final double bodyMm;
  private final ArrayDeque<Goal> goals;
  private final List<Object> answers = new ArrayList<>();
  private final GvhCell<Location> location;
  private final GvhCell<String> toward;
  private final GvhCell<String> way;

  private Belief belief;
  private Point rest;
  private SortedSet<String> wanted;
  private Path path;
  private boolean goesBack;
  private boolean needsAll;
  private boolean isCutOff;
  private long feltMs;
  private int lost;

  public MazeApp(GlobalVarHolder gvh, Errand errand) {
    super(gvh);
    this.errand = errand;
    MutexTimes times = MutexTimes.DEFAULT.withDeadlineMs(PATIENCE_MS);
    mutex = new M_Mutex(gvh, XID, M_Mutex.closedGroup(gvh, gvh.id.participants()), times);
    ride = new Ride(gvh);
    bodyMm = gvh.plat.moat.parameters().robotRadiusMm();
    goals = new ArrayDeque<>(errand.goals());
    belief = new Belief(gvh.gps.knownObstacles().all(), List.of());
    rest = errand.start();
    wanted = errand.blocks().all();
    path = new Path(List.of(rest, rest));
    location = gvh.variable(SOURCE, LOCATION, Location.START);
    toward = gvh.variable(SOURCE, TOWARD, "");
    way = gvh.variable(SOURCE, WAY, "");
  }

  @Override
  public List<Object> callStarL() {
    while (location.get() != Location.DONE) {
      switch (location.get()) {
        case START -> {
          if (knowsItsPlace()) {
            location.set(Location.CHOOSE);
          }
        }
        case CHOOSE -> choose();
        case ASK -> {
          mutex.do_mutex(wanted);
          location.set(Location.ASK_WAIT);
        }
        case ASK_WAIT -> {
          if (mutex.od_mutex()) {
            drive(path);
          } else if (mutex.failed().get()) {
            location.set(Location.ASK);
          }
        }
        case DRIVE, RETREAT -> {
          switch (ride.look()) {
            case UNDER_WAY -> {}
            case ARRIVED -> arrived();
            case BUMPED -> {
              feltMs = 0;
              location.set(Location.FEEL);
            }
            case HELD_UP -> {
              sleep(RETRY_MS);
              location.set(Location.PLAN_AGAIN);
            }
          }
        }
        case FEEL -> feel();
        case PLAN_AGAIN -> planAgain();
        case DONE -> throw new IllegalStateException("the loop has ended");
      }
      sleep(PERIOD_MS);
    }
    return returnResults();
  }

  @Override
  protected List<Object> returnResults() {
    return List.copyOf(answers);
  }

  private boolean knowsItsPlace() {
    return gvh.gps.hasFix() && gvh.gps.errorMm() <= CERTAIN_MM;
  }

  private void choose() {
    if (goals.isEmpty()) {
      toward.set("");
      location.set(Location.DONE);
      return;
    }
    Goal goal = goals.element();
    toward.set(goal.name());
    switch (outcome(search(goal.at())::anywhere)) {
      case Search.Outcome.Way found -> {
        path = found.path();
        way.set(text(path));
        wanted = needsAll ? errand.blocks().all() : along(path);
        location.set(Location.ASK);
      }
      case Search.Outcome.NoWay no -> answer(Answer.NO_WAY);
      case Search.Outcome.Lost from -> answer(Answer.GAVE_UP);
    }
  }

  /** Gives the strand up while it looks. */
  private Search.Outcome outcome(Supplier<Search.Outcome> search) {
    Computation<Search.Outcome> outcome = gvh.plat.compute(search);
    await(outcome::isDone);
    return outcome.result();
  }

  private Search search(Point to) {
    return new Search(errand, belief, gvh.gps.pose().at(), to, bodyMm);
  }

  private SortedSet<String> along(Path somewhere) {
    double aroundMm = bodyMm + ASK_MM + errand.mode().wanderMm();
    return errand.blocks().along(somewhere, aroundMm);
  }

  private void drive(Path newPath) {
    path = newPath;
    way.set(text(path));
    boolean feels = errand.mode() == CollisionMode.DISCOVER && !goesBack;
    CollisionMode mode = feels || errand.mode() == CollisionMode.STOP ? errand.mode() : BACK;
    ride.along(path, goesBack ? ROUTINE_MM : goals.element().toleranceMm(), mode);
    location.set(Location.DRIVE);
  }

  private void arrived() {
    if (location.get() == Location.RETREAT) {
      location.set(Location.PLAN_AGAIN);
      return;
    }
    mutex.release(mutex.held());
    way.set("");
    if (!goesBack) {
      rest = goals.element().at();
      answer(Answer.REACHED);
    } else if (isCutOff) {
      answer(Answer.NO_WAY);
    } else {
      location.set(Location.CHOOSE);
    }
    goesBack = false;
    isCutOff = false;
  }

  private void answer(Answer answer) {
    Goal goal = goals.remove();
    answers.add(goal.name() + " " + answer);
    gvh.trace.action(SOURCE, ANSWER, goal.name(), answer, gvh.gps.errorMm());
    needsAll = false;
    location.set(Location.CHOOSE);
  }

  /** Lets the collision mode do its part, then learns what the contacts prove. */
  private void feel() {
    feltMs += PERIOD_MS;
    long longestMs = errand.mode().feelMs() > 0 ? errand.mode().feelMs() : LONGEST_FEEL_MS;
    if (gvh.plat.moat.inMotion() && feltMs < longestMs) {
      return;
    }
    ride.stop();
    if (gvh.gps.errorMm() <= CERTAIN_MM || feltMs >= LONGEST_FEEL_MS) {
      ride.contacts().forEach(this::learn);
      location.set(Location.PLAN_AGAIN);
    }
  }

  private void learn(Contact contact) {
    Point at = contact.at().pose().at();
    for (Capsule other : errand.others()) {
      double reachMm = bodyMm + other.radiusMm() + contact.at().errorMm() + NEAR_MM;
      if (other.axis().distanceMm(at) <= reachMm) {
        return;
      }
    }
    List<Mark> marks = Mark.of(contact, bodyMm);
    belief = belief.plus(marks);
    for (Mark mark : marks) {
      Polygon place = mark.place(1);
      if (place != null) {
        gvh.trace.action(SOURCE, MARK, RegionText.format(place));
      }
    }
  }

  private void planAgain() {
    if (goesBack) {
      Search home = search(rest);
      List<Polygon> notHeld = outside(0);
      goOn(outcome(() -> home.back(notHeld)));
      return;
    }
    Search search = search(goals.element().at());
    List<Polygon> outside = outside(errand.mode().wanderMm());
    Search.Outcome inside = outcome(() -> search.within(outside));
    goOn(inside instanceof Search.Outcome.Way ? inside : outcome(search::anywhere));
  }

  private void goOn(Search.Outcome outcome) {
    boolean holdsAll = mutex.held().equals(errand.blocks().all());
    switch (outcome) {
      case Search.Outcome.Way found -> {
        lost = found.isNarrow() ? lost + 1 : 0;
        if (lost > TRIES_WHEN_LOST) {
          giveUp();
        } else if (goesBack || holdsAll || mutex.held().containsAll(along(found.path()))) {
          drive(found.path());
        } else {
          needsAll = true;
          goesBack = true;
        }
      }
      case Search.Outcome.NoWay no -> {
        isCutOff = true;
        goesBack = true;
      }
      case Search.Outcome.Lost from -> {
        lost++;
        if (lost > TRIES_WHEN_LOST || !retreated()) {
          giveUp();
        }
      }
    }
  }

  private List<Polygon> outside(double wanderMm) {
    return errand.blocks().outside(mutex.held(), bodyMm + INSIDE_MM + wanderMm);
  }

  /** Sets out to where it came from; false if it does not remember such a place. */
  private boolean retreated() {
    Point here = gvh.gps.pose().at();
    for (Point at : ride.trail()) {
      if (at.distanceMm(here) >= LEAST_RETREAT_MM && !belief.isMarked(at)) {
        ride.forgetAfter(at);
        ride.along(new Path(List.of(here, at)), ROUTINE_MM, BACK);
        location.set(Location.RETREAT);
        return true;
      }
    }
    return false;
  }

  /** Stays where it is, with the blocks that it stands in. */
  private void giveUp() {
    SortedSet<String> free = new TreeSet<>(mutex.held());
    free.removeAll(errand.blocks().around(gvh.gps.pose().at(), bodyMm + ASK_MM));
    if (!free.isEmpty()) {
      mutex.release(free);
    }
    while (!goals.isEmpty()) {
      answer(Answer.GAVE_UP);
    }
  }

  private static String text(Path path) {
    StringBuilder text = new StringBuilder();
    for (Point point : path.points()) {
      text.append(text.length() == 0 ? "" : ">");
      text.append(Math.round(point.xMm())).append(',').append(Math.round(point.yMm()));
    }
    return text.toString();
  }
}
