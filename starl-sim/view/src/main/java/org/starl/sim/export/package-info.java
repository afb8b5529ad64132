/**
 * Observers that export a run: CSV tables, and messages for Foxglove, in MCAP files or elsewhere.
 *
 * <p>May import: core, {@code org.starl.sim}'s observer and result, {@code org.starl.sim.record},
 * {@code org.starl.sim.view.page}.
 */
@NullMarked
package org.starl.sim.export;

import org.jspecify.annotations.NullMarked;
