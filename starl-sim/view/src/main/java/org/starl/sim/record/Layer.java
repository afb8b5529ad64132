package org.starl.sim.record;

import java.awt.Graphics2D;
import java.util.Collections;
import java.util.List;
import java.util.SortedMap;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;

/**
 * The app's part of the picture of a run. Coordinates are the world's: mm, y upwards.
 *
 * <p>A layer's drawing depends only on its constructor's arguments and on the events that it has
 * observed. So the viewer can paint any moment of a run or of a trace, and go forwards and
 * backwards.
 */
public interface Layer {

  /** Draws nothing: pictures show only robots and obstacles. */
  Layer NONE =
      new Layer() {
        @Override
        public Layer copy() {
          return this;
        }
      };

  /**
   * An independent copy in the same state; copy and original may be used by two threads. A layer
   * without state returns itself; a layer with state must copy it.
   */
  Layer copy();

  /** Updates the state; called for each event, before painting. */
  default void observe(TraceEvent event) {}

  /** Parts that the user can hide, one word each; see {@link Look#shows(String)}. */
  default List<String> parts() {
    return List.of();
  }

  /**
   * Paints zones, routes and goals, under the bodies.
   *
   * @param look colours and visible parts
   */
  default void paintFloor(Graphics2D floor, Scene scene, Look look) {}

  /** Whether pictures show the trails of bodies. */
  default boolean showsTrails() {
    return true;
  }

  /** Paints over obstacles, trails and bodies. */
  default void paintOver(Graphics2D floor, Scene scene, Look look) {}

  /** One or two lines about a robot, for the legend. */
  default String describe(RobotId robot, Scene scene) {
    return "";
  }

  /** Points that every picture contains, even if no robot goes there. */
  default List<Point> corners() {
    return List.of();
  }

  /** Areas of the floor by name, to mark on the floor of real robots: {@code starl deploy plan}. */
  default SortedMap<String, Rectangle> areas() {
    return Collections.emptySortedMap();
  }

  /**
   * How interesting the scene is; {@link PictureTime.Best} maximizes it. By default the robots on
   * the floor count, and the lengths of their trails: so the picture shows how far they have driven.
   */
  default double interest(Scene scene) {
    return scene.robots().stream()
        .filter(robot -> scene.pose(robot).isPresent())
        .mapToInt(robot -> scene.driven(robot))
        .sum();
  }
}
