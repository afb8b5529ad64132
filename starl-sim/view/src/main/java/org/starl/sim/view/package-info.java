/**
 * The window: a run, recorded or still going on, shown at any moment of it. What is shown and how the
 * time goes is decided by plain classes ({@link org.starl.sim.view.Playback}, {@link
 * org.starl.sim.view.ViewState}, {@link org.starl.sim.view.Traffic}, {@link
 * org.starl.sim.view.Inspection}) that know nothing of Swing; the others put it on the screen, on
 * Swing's event thread alone. The window is a guest at a run: it sees events, and changes nothing
 * unless a person intervenes, which the trace then tells.
 *
 * <p>May import: core, {@code org.starl.sim}, {@code org.starl.sim.record}, {@code
 * org.starl.sim.replay}, {@code org.starl.sim.fault}, {@code org.starl.input}, Swing and FlatLaf.
 */
@NullMarked
package org.starl.sim.view;

import org.jspecify.annotations.NullMarked;
