/**
 * Checks that need more than one run: {@link org.starl.sim.check.Determinism} repeats a run on both
 * kinds of carriers and finds the first difference; {@link org.starl.sim.check.Campaign} runs many
 * seeds on all cores; {@link org.starl.sim.check.Shrink} reduces a bad run to a small one; {@link
 * org.starl.sim.check.MalformedBytes} tests readers; {@link org.starl.sim.check.RunArtifacts} is the
 * service that writes pictures of a run for a failing test.
 *
 * <p>Besides the carriers, only this package of the simulator uses threads: one simulation per
 * thread, without shared state.
 *
 * <p>May import: core, {@code org.starl.sim}, its {@code fault}, {@code
 * input} and {@code kernel}.
 */
@NullMarked
package org.starl.sim.check;

import org.jspecify.annotations.NullMarked;
