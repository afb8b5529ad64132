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
public record Plan(Simulation.Builder simulation, Story story, Layer layer, Obstacles obstacles) {}
