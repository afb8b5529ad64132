/**
 * StarL's benchmarks, over its public API: {@code starl bench b1} measures the kernel with strands
 * and radio, {@code b2} the whole stack with motion and positioning, {@code b3} swarms, {@code b4}
 * traffic, {@code b5} runs that are checked; {@code fleet} compares the app with a central planner. Figures are per second of CPU time of the thread that ran
 * the simulation; no benchmark passes or fails.
 *
 * <p>May import: all other modules.
 */
@NullMarked
package org.starl.bench;

import org.jspecify.annotations.NullMarked;
