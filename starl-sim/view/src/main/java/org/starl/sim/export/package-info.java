/**
 * Observers that write a run down: its trace, and tables.
 *
 * <p>May import: core, {@code org.starl.sim}'s observer and result.
 */
@NullMarked
package org.starl.sim.export;

import org.jspecify.annotations.NullMarked;
