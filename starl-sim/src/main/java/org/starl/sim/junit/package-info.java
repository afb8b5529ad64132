/**
 * Simulations as JUnit tests: a method marked {@link org.starl.sim.junit.StarlTest} says what to
 * simulate, and passes if that goes well for every seed.
 *
 * <p>Contract: the test is one test for JUnit. Its method, and what it wants to be checked {@link
 * org.starl.sim.junit.RunChecks}, run seed by seed on the test's own thread, on one instance; the
 * simulations run on all cores, so robots and monitors of two seeds must not share what changes. A
 * failure names the seeds, what went wrong and how to run one of them alone. Equal code gives equal
 * verdicts, on any number of cores.
 *
 * <p>JUnit is the user's: nothing else of the simulator needs it on the class path.
 *
 * <p>May import: {@code org.starl.sim}, its {@code check}, {@code fault} and {@code input}, JUnit.
 */
@NullMarked
package org.starl.sim.junit;

import org.jspecify.annotations.NullMarked;
