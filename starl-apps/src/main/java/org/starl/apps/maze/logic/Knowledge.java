package org.starl.apps.maze.logic;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.starl.GlobalVarHolder;
import org.starl.comms.Endpoint;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Segment;
import org.starl.motion.Contact;
import org.starl.primitives.paths.Path;

/**
 * One robot's knowledge of the maze: its map, and the marks that contacts have proven. After a bump
 * the collision mode moves the robot, which may give more contacts. Then the robot learns from all
 * of them, and tells the others, so that a wall is felt along once. A lost message costs another
 * bump. Strand only.
 */
final class Knowledge {

  // The robot waits for a position as certain as this before it learns, but not for ever.
  private static final double CERTAIN_MM = 30;
  private static final long LONGEST_FEEL_MS = 5_000;

  private final GlobalVarHolder gvh;
  private final MazeTask task;
  private final Ride ride;
  private final Diary diary;
  private final double bodyMm;
  private final Obstacles map;
  private final List<Mark> marks = new ArrayList<>();
  private final Endpoint<Mark> team;

  /** Marks since the latest look at them. */
  private final List<Mark> news = new ArrayList<>();

  private long feltMs;

  Knowledge(GlobalVarHolder gvh, MazeTask task, Ride ride, Diary diary) {
    this.gvh = gvh;
    this.task = task;
    this.ride = ride;
    this.diary = diary;
    bodyMm = gvh.plat.moat.parameters().robotRadiusMm();
    map = gvh.gps.knownObstacles().all();
    team = gvh.comms.open(MazeFact.MARKS, (from, mark) -> heard(mark));
  }

  /** A search for a way from here to {@code goal}, with the present knowledge. */
  Search searchTo(Point goal) {
    return new Search(task, map, marks, gvh.gps.pose().at(), goal, bodyMm);
  }

  /** Whether no mark excludes a body at {@code at} that is wider by the margin. */
  boolean isUnmarked(Point at) {
    return Mark.places(marks, 1).stream().noneMatch(place -> place.contains(at));
  }

  boolean isPositionCertain() {
    return gvh.gps.errorMm() <= CERTAIN_MM;
  }

  /** To be called after a bump, before {@link #hasLearned}. */
  void bumped() {
    feltMs = 0;
  }

  /** Whether the robot has learned all from the bump; call it once a period until then. */
  boolean hasLearned(long periodMs) {
    feltMs += periodMs;
    if (gvh.plat.moat.inMotion() && feltMs < task.mode().feelMs() && !isNearOther()) {
      return false;
    }
    ride.stop();
    if (!isPositionCertain() && feltMs < LONGEST_FEEL_MS) {
      return false;
    }
    ride.contacts().forEach(this::learn);
    return true;
  }

  /** Along an obstacle it may come to where another robot rests: the blocks do not keep them apart. */
  private boolean isNearOther() {
    double reachMm = bodyMm + gvh.gps.errorMm() + MazeTask.MARGIN_MM;
    return task.mode() == CollisionMode.DISCOVER && task.isNearOther(gvh.gps.pose().at(), reachMm);
  }

  private void learn(Contact contact) {
    if (!task.mayBeOther(contact, bodyMm)) {
      List<Mark> proven = Mark.of(contact, bodyMm);
      marks.addAll(proven);
      diary.marks(proven);
      proven.forEach(team::broadcast);
    }
  }

  private void heard(Mark mark) {
    if (mark.bodyMm() == bodyMm && !marks.contains(mark)) {
      marks.add(mark);
      news.add(mark);
    }
  }

  /** Whether a mark of another robot, heard since the latest call, is on this way. */
  boolean hasClosed(Path way) {
    boolean isClosed =
        Mark.places(news, 1).stream()
            .anyMatch(
                place -> IntStream.range(0, way.legs()).anyMatch(i -> meets(place, way.leg(i))));
    news.clear();
    return isClosed;
  }

  private static boolean meets(Polygon place, Segment leg) {
    return place.contains(leg.to())
        || IntStream.range(0, place.vertices().size())
            .anyMatch(side -> leg.distanceMm(place.side(side)) == 0);
  }
}
