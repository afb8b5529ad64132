package org.starl.apps.maze.logic;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.geometry.Point;
import org.starl.motion.Contact;

/**
 * What one robot knows of the maze, and how it comes to know more: its map at first, and what each
 * contact proves. After a contact the collision mode does its part, while more contacts may come;
 * then all of them are learned from. Strand only.
 */
final class Knowledge {

  /** Contacts are learned from at a place that is as certain, but it is not waited for for ever. */
  private static final double CERTAIN_MM = 30;

  private static final long LONGEST_FEEL_MS = 5_000;

  private final GlobalVarHolder gvh;
  private final Errand errand;
  private final Ride ride;
  private final MazeTrace trace;
  private final double bodyMm;
  private Belief belief;
  private long feltMs;

  Knowledge(GlobalVarHolder gvh, Errand errand, Ride ride, MazeTrace trace) {
    this.gvh = gvh;
    this.errand = errand;
    this.ride = ride;
    this.trace = trace;
    bodyMm = gvh.plat.moat.parameters().robotRadiusMm();
    belief = new Belief(gvh.gps.knownObstacles().all(), List.of());
  }

  Belief belief() {
    return belief;
  }

  /** By what is known now, from here to {@code goal}. */
  Search searchTo(Point goal) {
    return new Search(errand, belief, gvh.gps.pose().at(), goal, bodyMm);
  }

  /** Whether the robot knows well enough where it is. */
  boolean isPlaceCertain() {
    return gvh.gps.errorMm() <= CERTAIN_MM;
  }

  /** The robot has bumped. */
  void bumped() {
    feltMs = 0;
  }

  /** Whether all is learned from the bump; to be asked once a period until it is. */
  boolean hasLearned(long periodMs) {
    feltMs += periodMs;
    if (gvh.plat.moat.inMotion() && feltMs < errand.mode().feelMs()) {
      return false;
    }
    ride.stop();
    if (!isPlaceCertain() && feltMs < LONGEST_FEEL_MS) {
      return false;
    }
    ride.contacts().forEach(this::learn);
    return true;
  }

  private void learn(Contact contact) {
    if (!errand.mayBeOther(contact, bodyMm)) {
      List<Mark> proven = Mark.of(contact, bodyMm);
      belief = belief.plus(proven);
      trace.marks(proven);
    }
  }
}
