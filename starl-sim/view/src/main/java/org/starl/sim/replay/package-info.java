/**
 * Runs that the viewer can seek in. A {@link org.starl.sim.replay.Recording} keeps the events of a
 * live run or of a trace; a {@link org.starl.sim.replay.Cursor} goes to any moment of it, forwards
 * and backwards. {@link org.starl.sim.replay.LiveRun} runs a simulation on its own thread, limits
 * how far it is ahead of the display, and accepts interventions of the user. Interventions are
 * events of the trace; {@link org.starl.sim.replay.InterventionReplayer} repeats them. {@link
 * org.starl.sim.replay.TracePlayer} shows a trace to observers; {@link
 * org.starl.sim.replay.TraceLoader} does it on its own thread.
 *
 * <p>One thread fills a recording, others read it; a cursor belongs to one thread. A run has the
 * same trace with and without a recording.
 *
 * <p>May import: core, {@code org.starl.sim} and its sub-packages {@code record}, {@code fault},
 * {@code input}, {@code net} and {@code world}.
 */
@NullMarked
package org.starl.sim.replay;

import org.jspecify.annotations.NullMarked;
