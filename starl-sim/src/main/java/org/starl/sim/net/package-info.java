/**
 * The simulated air between the robots' radios: {@link org.starl.sim.net.SimNetwork} takes what a
 * radio sends and hands each copy to its recipient's strand, after a delay, or drops it.
 *
 * <p>Contract: without rules every copy is lost with the base {@link org.starl.sim.net.Loss} and
 * otherwise takes the base {@link org.starl.sim.net.Latency}, independently for each recipient of a
 * broadcast. Faults are {@link org.starl.sim.net.LinkRule}s, which can come and go in mid-run; the
 * first that drops or delivers decides, those before it may delay or repeat the copy. All randomness
 * is a function of the run's seed, the sender, the recipient and the sender's count of datagrams, so
 * that neither one more robot nor one more rule changes other robots' draws. The network knows no fault by name and nothing of positions.
 *
 * <p>May import: {@code org.starl} core, {@code org.starl.sim.kernel}, {@code org.starl.input}.
 */
@NullMarked
package org.starl.sim.net;

import org.jspecify.annotations.NullMarked;
