/**
 * Checks that take more than one run: {@link org.starl.sim.check.Determinism} runs the same twice, on
 * both kinds of carriers, and finds the first event that differs; {@link
 * org.starl.sim.check.Campaign} runs many seeds on all cores; {@link org.starl.sim.check.Shrink}
 * reduces a bad run to a small one; {@link org.starl.sim.check.MalformedBytes} tests readers.
 *
 * <p>The one place of the simulator besides its carriers that uses threads: one simulation on each,
 * nothing shared.
 *
 * <p>May import: core, {@code org.starl.sim}, its {@code fault}, {@code
 * input} and {@code kernel}.
 */
@NullMarked
package org.starl.sim.check;

import org.jspecify.annotations.NullMarked;
