/**
 * A run as files to send to a person.
 *
 * <p>May import: core, {@code org.starl.sim}, {@code org.starl.sim.check}, {@code
 * org.starl.sim.record}, {@code org.starl.sim.replay}, {@code org.starl.sim.view}, {@code
 * org.starl.input}.
 */
@NullMarked
package org.starl.sim.view.page;

import org.jspecify.annotations.NullMarked;
