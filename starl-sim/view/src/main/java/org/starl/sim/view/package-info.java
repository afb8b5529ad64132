/**
 * The window: shows any moment of a live run or of a trace. The model ({@link
 * org.starl.sim.view.Playback}, {@link org.starl.sim.view.ViewState}, {@link
 * org.starl.sim.view.Traffic}, {@link org.starl.sim.view.Inspection}) does not use Swing; the other
 * classes display it and run only on Swing's event thread. The window observes events; only
 * interventions of the user change the run, and the trace records them.
 *
 * <p>May import: core, {@code org.starl.sim}, {@code org.starl.sim.record}, {@code
 * org.starl.sim.replay}, {@code org.starl.sim.fault}, {@code org.starl.input}, Swing and FlatLaf.
 */
@NullMarked
package org.starl.sim.view;

import org.jspecify.annotations.NullMarked;
