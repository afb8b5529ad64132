package org.starl.sim.record;

import java.awt.Graphics2D;
import java.util.List;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;

/**
 * An app's drawing in the picture of a run. Coordinates are those of the world: mm, y upwards.
 *
 * <p>The drawing depends only on the layer's construction and the events that it has observed, so
 * that a picture of any moment can be painted, of a live run or of a file, forwards and backwards.
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
   * Copies this layer. The copy and this layer are then independent, possibly on two threads. A
   * layer without state from events may return itself; any other must copy that state.
   */
  Layer copy();

  /** Sees each event of the run before it is painted. */
  default void observe(TraceEvent event) {}

  /**
   * The names of the parts that can be hidden; {@link Look#shows(String)} tells whether one is
   * shown.
   */
  default List<String> parts() {
    return List.of();
  }

  /**
   * Draws below the bodies: zones, routes, goals.
   *
   * @param look the colours and the shown parts
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
