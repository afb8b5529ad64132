/**
 * The simulated radio channel: {@link org.starl.sim.net.SimNetwork} takes datagrams from radios and
 * delivers each copy on its recipient's strand after a delay, or drops it.
 *
 * <p>Contract: without rules every copy is lost with the base {@link org.starl.sim.net.Loss} and
 * otherwise takes the base {@link org.starl.sim.net.Latency}, independently for each recipient of a
 * broadcast. Faults are {@link org.starl.sim.net.LinkRule}s, which can be installed and removed
 * during a run; a rule may drop, delay or repeat a copy. All randomness is a function of the run's seed, the sender, the recipient and
 * the sender's count of datagrams, so that neither an additional robot nor an additional rule
 * changes the random numbers of other robots. With a {@link org.starl.sim.net.Coverage} a radio has a limited range. The
 * network does not depend on specific faults or on positions.
 *
 * <p>May import: {@code org.starl} core, {@code org.starl.sim.kernel}, {@code org.starl.input}.
 */
@NullMarked
package org.starl.sim.net;

import org.jspecify.annotations.NullMarked;
