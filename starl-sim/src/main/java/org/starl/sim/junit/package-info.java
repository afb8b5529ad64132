/**
 * Simulations as JUnit tests: a method marked {@link org.starl.sim.junit.StarlTest} describes the
 * simulation, and passes if the run is good for every seed.
 *
 * <p>Contract: it is one test for JUnit. Its method and its checks ({@link
 * org.starl.sim.junit.RunChecks}) run seed by seed on the test's own thread, on one instance; the
 * simulations run on all cores, so that robots and monitors of two seeds must not share mutable
 * state. A failure names the seeds, the errors and how to repeat one of them. Equal code gives
 * equal verdicts, on any number of cores.
 *
 * <p>JUnit must be on the user's class path; the rest of the simulator does not need it.
 *
 * <p>May import: {@code org.starl.sim}, its {@code check}, {@code fault} and {@code input}, JUnit.
 */
@NullMarked
package org.starl.sim.junit;

import org.jspecify.annotations.NullMarked;
