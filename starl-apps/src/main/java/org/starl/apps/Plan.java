package org.starl.apps;

import org.starl.geometry.Obstacles;
import org.starl.sim.Simulation;
import org.starl.sim.record.Layer;

/**
 * A simulation that is ready to be built, monitors included, with what tells and draws it.
 *
 * @param story observes the simulation already
 * @param layer what the app draws into pictures
 * @param obstacles of the world, hidden ones included
 */
public record Plan(Simulation.Builder simulation, Story story, Layer layer, Obstacles obstacles) {

  /** One whose story is what each robot's app returned, and whose pictures show robots alone. */
  public static Plan of(Simulation.Builder simulation) {
    return of(simulation, Layer.NONE);
  }

  /** One whose story is what each robot's app returned. */
  public static Plan of(Simulation.Builder simulation, Layer layer) {
    Returned story = new Returned();
    simulation.observer(story);
    return new Plan(simulation, story, layer, simulation.obstacles());
  }
}
