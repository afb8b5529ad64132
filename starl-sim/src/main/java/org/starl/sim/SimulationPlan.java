package org.starl.sim;

import java.util.List;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Obstacles;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.platform.DeploymentKey;
import org.starl.sim.fault.FaultPlan;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.net.LinkRule;
import org.starl.spec.Monitor;
import org.starl.trace.TraceHeader;

/**
 * The immutable plan of one run: what the engine runs, and what a launcher of robots as processes
 * reads. {@link Simulation.Builder#build} makes it. It is good for one run, because directors and
 * observers keep state.
 *
 * @param header of its trace: name, seeds, settings, robots
 * @param carriers threads of apps that block
 * @param obstacles of the world, hidden ones included
 * @param key seals datagrams; null for none
 * @param robots that start
 * @param director null for none
 * @param bystander null for none
 * @param faults of the settings, then those that chaos drew
 * @param linkRules for every datagram, before the settings' delay and loss; earlier rules go first
 * @param endNs latest end of the run, in ns of virtual time
 * @param monitors makers of the specifications to check
 * @param observers in their order
 */
public record SimulationPlan(
    TraceHeader header,
    SimSettings settings,
    CarrierKind carriers,
    Obstacles obstacles,
    @Nullable DeploymentKey key,
    List<RobotSpec> robots,
    @Nullable Director director,
    @Nullable StepListener bystander,
    FaultPlan faults,
    List<LinkRule> linkRules,
    long endNs,
    List<Supplier<? extends Monitor>> monitors,
    List<SimObserver> observers) {

  public SimulationPlan {
    robots = List.copyOf(robots);
    linkRules = List.copyOf(linkRules);
    monitors = List.copyOf(monitors);
    observers = List.copyOf(observers);
  }

  /** The robots that start, by name. */
  Participants deployment() {
    return deployment(robots);
  }

  /** @throws BadInput if two robots have the same name */
  static Participants deployment(List<RobotSpec> robots) {
    List<RobotId> ids = robots.stream().map(RobotSpec::id).toList();
    Participants deployment = Participants.of(ids);
    if (deployment.size() != ids.size()) {
      throw new BadInput("two robots of one name among " + ids);
    }
    return deployment;
  }
}
