package org.starl.apps;

import org.starl.geometry.Obstacles;
import org.starl.sim.Simulation;
import org.starl.sim.record.Layer;

/**
 * A simulation that is ready to be built, monitors included, with its story and its drawing.
 *
 * @param story already observes the simulation
 * @param layer the app's drawing in pictures
 * @param obstacles of the world, hidden ones included
 */
public record Plan(Simulation.Builder simulation, Story story, Layer layer, Obstacles obstacles) {

  /** The story is each robot's result; pictures show only robots and obstacles. */
  public static Plan of(Simulation.Builder simulation) {
    return of(simulation, Layer.NONE);
  }

  /** The story is each robot's result. */
  public static Plan of(Simulation.Builder simulation, Layer layer) {
    Returned story = new Returned();
    simulation.observer(story);
    return new Plan(simulation, story, layer, simulation.obstacles());
  }
}
