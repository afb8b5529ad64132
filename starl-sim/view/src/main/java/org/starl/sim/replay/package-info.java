/**
 * Recordings of runs: a {@link org.starl.sim.replay.Recording} stores the events of a live run or
 * of a trace, and a {@link org.starl.sim.replay.Cursor} moves to any moment of it, forwards and
 * backwards. {@link org.starl.sim.replay.LiveRun} executes a simulation on its own thread, at most
 * a given time ahead of the viewer, and accepts a person's interventions. Each intervention is an
 * event of the run, and {@link org.starl.sim.replay.SameInterventions} repeats it. {@link
 * org.starl.sim.replay.TraceShow} passes a trace to observers; {@link
 * org.starl.sim.replay.TraceReading} does so on its own thread, for a viewer.
 *
 * <p>A recording is filled by one thread and read by others; a cursor is used by one thread.
 * Watching does not change a run: its trace is the same with and without a recording.
 *
 * <p>May import: core, {@code org.starl.sim} and its sub-packages {@code record}, {@code fault}, {@code
 * input}, {@code net} and {@code world}.
 */
@NullMarked
package org.starl.sim.replay;

import org.jspecify.annotations.NullMarked;
