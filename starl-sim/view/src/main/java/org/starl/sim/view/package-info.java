/**
 * The window: shows a recorded or live run at any moment. Plain classes ({@link
 * org.starl.sim.view.Playback}, {@link org.starl.sim.view.ViewState}, {@link
 * org.starl.sim.view.Traffic}, {@link org.starl.sim.view.Inspection}) decide the content and the
 * playback, and do not depend on Swing; the other classes display it, only on Swing's event thread.
 * The window observes the run; only a person's interventions change the run, and they are events of
 * its trace.
 *
 * <p>May import: core, {@code org.starl.sim}, {@code org.starl.sim.record}, {@code
 * org.starl.sim.replay}, {@code org.starl.sim.fault}, {@code org.starl.input}, Swing and FlatLaf.
 */
@NullMarked
package org.starl.sim.view;

import org.jspecify.annotations.NullMarked;
