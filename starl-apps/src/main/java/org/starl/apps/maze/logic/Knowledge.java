package org.starl.apps.maze.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.motion.Contact;

/**
 * One robot's knowledge of the maze: its map, and the marks that contacts have proven. After a bump
 * the collision mode moves the robot, which may give more contacts. Then the robot learns from all
 * of them. Strand only.
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
  private long feltMs;

  Knowledge(GlobalVarHolder gvh, MazeTask task, Ride ride, Diary diary) {
    this.gvh = gvh;
    this.task = task;
    this.ride = ride;
    this.diary = diary;
    bodyMm = gvh.plat.moat.parameters().robotRadiusMm();
    map = gvh.gps.knownObstacles().all();
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
    if (gvh.plat.moat.inMotion() && feltMs < task.mode().feelMs()) {
      return false;
    }
    ride.stop();
    if (!isPositionCertain() && feltMs < LONGEST_FEEL_MS) {
      return false;
    }
    ride.contacts().forEach(this::learn);
    return true;
  }

  private void learn(Contact contact) {
    if (!task.mayBeOther(contact, bodyMm)) {
      List<Mark> proven = Mark.of(contact, bodyMm);
      marks.addAll(proven);
      diary.marks(proven);
    }
  }
}
