package org.starl.sim.fault;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.random.Rng;

/**
 * A fault's begin.
 *
 * @param number of the fault in its plan, from 0
 * @param whom it befalls: whom its {@link Harm#who} means now
 * @param lastingNs how long it lasts, or {@link Span#NEVER}
 * @param rng its own generator
 */
public record Onset(Ward ward, int number, List<RobotId> whom, long lastingNs, Rng rng) {}
