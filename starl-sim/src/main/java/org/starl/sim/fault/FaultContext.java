package org.starl.sim.fault;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.random.Rng;

/**
 * The context in which a fault begins.
 *
 * @param number of the fault in its plan, from 0
 * @param whom the robots that it affects: those that {@link FaultEffect#who} selects now
 * @param lastingNs its length in ns, or {@link Span#NEVER}
 * @param rng its generator
 */
public record FaultContext(
    FaultTarget ward, int number, List<RobotId> whom, long lastingNs, Rng rng) {}
