/**
 * Exploration: runs one simulation again and again, with other orders of its events.
 *
 * <p>Contract: a schedule is a list of faults, each of which changes the arrival of one copy of a
 * datagram, delays a link, or crashes a robot. So every schedule is a run that the network of the
 * {@link org.starl.sim.explore.Bounds} can produce, its times included, and every finding is
 * replayed, shrunk and viewed as any other run. Equal bounds, strategies and seeds give equal
 * results, on any number of threads, and in any number of parts that run in processes of their own.
 *
 * <p>Strategies: {@code random} draws delays, losses and crashes; {@code pct} gives each link a
 * priority and changes a few priorities at random times (Burckhardt et al., "A randomized scheduler
 * with probabilistic guarantees of finding bugs", ASPLOS 2010, for links instead of threads); {@code
 * exhaustive} tries every order in which the next datagrams can arrive, those with the fewest
 * changes first (as in Emmi, Qadeer, Rakamaric, "Delay-bounded scheduling", POPL 2011).
 *
 * <p>May import: the JDK, core, {@code org.starl.input}, {@code org.starl.sim}, its check, fault
 * and net.
 */
@NullMarked
package org.starl.sim.explore;

import org.jspecify.annotations.NullMarked;
