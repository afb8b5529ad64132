package org.starl.apps;

import org.starl.sim.Simulation;

/**
 * A simulation that is ready to be built, monitors included, and the teller of its story, which
 * observes it already.
 */
public record Plan(Simulation.Builder simulation, Story story) {}
