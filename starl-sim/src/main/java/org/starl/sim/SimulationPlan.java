package org.starl.sim;

import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacles;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.platform.DeploymentKey;
import org.starl.sim.fault.FaultPlan;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.world.FloorObjects;
import org.starl.spec.Monitor;
import org.starl.spec.Specs;
import org.starl.trace.TraceHeader;

/**
 * The immutable plan of one run, built by {@link Simulation.Builder#build} and used by the engine
 * or by a launcher of robots as processes. It can be used once, because directors and observers
 * have state.
 *
 * @param header of the trace: name, seeds, settings, robots
 * @param carriers thread type of blocking apps
 * @param obstacles of the world, including hidden ones
 * @param objects on the floor, with the robots' sensors for them; null if they have none
 * @param waypoints named places on the floor, known to every robot
 * @param key seals datagrams; may be null
 * @param robots initial robots
 * @param placement the same robots, with drawn starts at least so many mm apart, and so many mm
 *     from edges and obstacles; null if no start is drawn. Throws {@link BadInput} if they do not
 *     fit
 * @param director may be null
 * @param stepListener may be null
 * @param faults of the settings, then those drawn by chaos
 * @param endNs latest end of the run, in ns of virtual time
 * @param actionLimitNs processor time that one action may use
 * @param monitors suppliers of the specifications to check
 * @param specs which of them
 * @param observers in calling order
 * @param commands the command lines that repeat the run and shrink it, for a description of a
 *     failure
 */
public record SimulationPlan(
    TraceHeader header,
    SimSettings settings,
    CarrierKind carriers,
    Obstacles obstacles,
    @Nullable FloorObjects objects,
    List<ItemPosition> waypoints,
    @Nullable DeploymentKey key,
    List<RobotSpec> robots,
    @Nullable BiFunction<Double, Double, List<RobotSpec>> placement,
    @Nullable Director director,
    @Nullable StepListener stepListener,
    FaultPlan faults,
    long endNs,
    long actionLimitNs,
    List<Supplier<? extends Monitor>> monitors,
    Specs specs,
    List<SimObserver> observers,
    Supplier<List<String>> commands) {

  public SimulationPlan {
    waypoints = List.copyOf(waypoints);
    robots = List.copyOf(robots);
    monitors = List.copyOf(monitors);
    observers = List.copyOf(observers);
  }

  /** The observer of the order of events, or null. */
  @Nullable OrderObserver orderObserver() {
    OrderObserver found = null;
    for (SimObserver observer : observers) {
      if (observer instanceof OrderObserver order) {
        if (found != null) {
          throw new IllegalStateException("two observers of the order of events: expected one");
        }
        found = order;
      }
    }
    return found;
  }

  /** The initial robots, by name. */
  Participants deployment() {
    return deployment(robots);
  }

  /** @throws BadInput if two robots have the same name */
  static Participants deployment(List<RobotSpec> robots) {
    List<RobotId> ids = robots.stream().map(RobotSpec::id).toList();
    Participants deployment = Participants.of(ids);
    if (deployment.size() != ids.size()) {
      throw new BadInput("duplicate robot name in " + ids);
    }
    return deployment;
  }
}
