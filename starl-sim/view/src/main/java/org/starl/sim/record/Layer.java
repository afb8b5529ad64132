package org.starl.sim.record;

import java.awt.Graphics2D;
import java.util.List;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;

/**
 * What an app draws into the picture of a run. Coordinates are the world's: mm, y upwards.
 *
 * <p>What it draws depends on nothing but what it was made with and the events that it has observed:
 * so that a picture of any moment can be painted, of a run that goes on as of one in a file, forwards
 * and backwards.
 */
public interface Layer {

  /** A layer without content: pictures show only robots and obstacles. */
  Layer NONE =
      new Layer() {
        @Override
        public Layer copy() {
          return this;
        }
      };

  /**
   * The same layer at this moment: the copy and this one, which is left as it is, go on apart, maybe
   * on two threads. A layer that keeps nothing of the events is its own copy, and returns itself; one
   * that keeps something must give the copy its own.
   */
  Layer copy();

  /** Sees each event of the run before it is painted. */
  default void observe(TraceEvent event) {}

  /** What can be switched off, a word each; {@link Look#shows(String)} tells whether it is on. */
  default List<String> parts() {
    return List.of();
  }

  /**
   * Under the bodies: zones, routes, goals.
   *
   * @param look colours to paint in, and what is switched on
   */
  default void paintFloor(Graphics2D floor, Scene scene, Look look) {}

  /** Whether to draw where the bodies have been. */
  default boolean showsTrails() {
    return true;
  }

  /** Over obstacles, trails and bodies. */
  default void paintOver(Graphics2D floor, Scene scene, Look look) {}

  /** A line or two for each robot, in the legend. */
  default String describe(RobotId robot, Scene scene) {
    return "";
  }

  /** Points that every picture must include. */
  default List<Point> corners() {
    return List.of();
  }

  /** The amount of content: the best picture is taken where this is greatest. */
  default double interest(Scene scene) {
    return scene.robots().stream().filter(robot -> scene.pose(robot).isPresent()).count();
  }
}
