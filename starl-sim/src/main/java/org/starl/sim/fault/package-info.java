/**
 * Fault injection: what goes wrong in a run, from when to when.
 *
 * <p>Contract: a {@link org.starl.sim.fault.Fault} is a value with one text, read and written by
 * {@link org.starl.sim.fault.FaultGrammar}: {@code crash(bot2,at=12s,restart=5s)}. A {@link
 * org.starl.sim.fault.FaultPlan} is a list of them; installed in a run, it acts through the run's
 * {@link org.starl.sim.fault.FaultTarget} alone: rules of the air, impairments of robots, crashes, bodies
 * that block a robot. Each fault draws from a generator of its own, forked by its text, so that
 * removing one from a plan changes no other. Every begin and end is an event of the trace, and so is
 * {@code healed}: the last fault has ended, and from then on primitives must make progress. A run
 * without faults is the same as a run without this package.
 *
 * <p>May import: {@code org.starl} core, {@code org.starl.input}, {@code kernel}, {@code net},
 * {@code world}.
 */
@NullMarked
package org.starl.sim.fault;

import org.jspecify.annotations.NullMarked;
