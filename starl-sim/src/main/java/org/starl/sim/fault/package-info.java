/**
 * Fault injection: the faults of a run and their times.
 *
 * <p>Contract: a {@link org.starl.sim.fault.Fault} is a value with one text, read and written by
 * {@link org.starl.sim.fault.FaultGrammar}: {@code crash(bot2,at=12s,restart=5s)}. A {@link
 * org.starl.sim.fault.FaultPlan} is a list of faults; installed in a run, it acts only through the
 * run's {@link org.starl.sim.fault.FaultTarget}: network rules, impairments of robots, crashes,
 * bodies that block a robot. Each fault has its own random generator, forked by its text, so that
 * removing a fault from a plan does not change others. Every begin and end is an event of the
 * trace, and so is {@code healed}: the last fault has ended, and from then on primitives must make
 * progress. A run without faults does not depend on this package.
 *
 * <p>May import: {@code org.starl} core, {@code org.starl.input}, {@code kernel}, {@code net},
 * {@code world}.
 */
@NullMarked
package org.starl.sim.fault;

import org.jspecify.annotations.NullMarked;
