package org.starl.sim.fault;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.random.Rng;

/**
 * The context at the beginning of a fault.
 *
 * @param target the run
 * @param number of the fault in its plan, from 0
 * @param selector the affected robots
 * @param robots those that it selects now
 * @param lastingNs the fault's duration in ns, or {@link Span#NEVER}
 * @param rng the fault's generator
 */
public record FaultContext(
    FaultTarget target,
    int number,
    RobotSelector selector,
    List<RobotId> robots,
    long lastingNs,
    Rng rng) {}
