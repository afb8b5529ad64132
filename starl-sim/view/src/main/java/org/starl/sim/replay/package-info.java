/**
 * A run as something that can be looked at: its events are kept in a {@link
 * org.starl.sim.replay.Recording}, while it runs or from a trace, and a {@link
 * org.starl.sim.replay.Cursor} goes to any moment of it, forwards and backwards. {@link
 * org.starl.sim.replay.LiveRun} lets a simulation run on a thread of its own, no farther ahead of who
 * watches than that one likes, and takes what a person does to it. Whatever that is, is an event of the
 * run, and {@link org.starl.sim.replay.SameInterventions} does it again. {@link
 * org.starl.sim.replay.TraceShow} shows a trace to whoever observes runs; {@link
 * org.starl.sim.replay.TraceReading} does it on a thread of its own, for somebody who watches.
 *
 * <p>A recording is filled by one thread and read by others; a cursor is one thread's own. Watching
 * changes nothing: a run has the same trace with and without a recording.
 *
 * <p>May import: core, {@code org.starl.sim} and its sub-packages {@code record}, {@code fault}, {@code
 * input}, {@code net} and {@code world}.
 */
@NullMarked
package org.starl.sim.replay;

import org.jspecify.annotations.NullMarked;
