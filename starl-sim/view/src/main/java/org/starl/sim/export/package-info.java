/**
 * Observers that export a run: CSV tables, and MCAP files for Foxglove.
 *
 * <p>May import: core, {@code org.starl.sim}'s observer and result.
 */
@NullMarked
package org.starl.sim.export;

import org.jspecify.annotations.NullMarked;
