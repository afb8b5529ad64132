package org.starl.sim;

import java.util.List;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Obstacles;
import org.starl.platform.DeploymentKey;
import org.starl.spec.Monitor;
import org.starl.trace.TraceHeader;

/**
 * What a {@link Simulation} consists of, for those who bring its robots up otherwise: as processes,
 * in real time. Good for one run, as the simulation is.
 *
 * @param header of its trace: name, seeds, settings, robots
 * @param obstacles of the world, hidden ones included
 * @param key what datagrams are sealed with, or null for none
 * @param robots of the start
 * @param director null for none
 * @param monitors makers of the specifications to check
 * @param observers in their order
 */
public record Blueprint(
    TraceHeader header,
    SimSettings settings,
    Obstacles obstacles,
    @Nullable DeploymentKey key,
    List<RobotSpec> robots,
    @Nullable Director director,
    List<Supplier<? extends Monitor>> monitors,
    List<SimObserver> observers) {

  public Blueprint {
    robots = List.copyOf(robots);
    monitors = List.copyOf(monitors);
    observers = List.copyOf(observers);
  }
}
