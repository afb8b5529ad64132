package org.starl.sim.fault;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.random.Rng;

/**
 * The context at the beginning of a fault.
 *
 * @param number of the fault in its plan, from 0
 * @param whom the affected robots, selected now by {@link FaultEffect#who}
 * @param lastingNs the fault's duration in ns, or {@link Span#NEVER}
 * @param rng the fault's generator
 */
public record FaultContext(
    FaultTarget ward, int number, List<RobotId> whom, long lastingNs, Rng rng) {}
