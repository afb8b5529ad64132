/**
 * Pictures of a run without a window: bodies, trails and obstacles, and the drawing of the app's
 * {@link org.starl.sim.record.Layer}. Only this package and the views may use {@code java.awt}.
 *
 * <p>May import: core, {@code org.starl.sim}.
 */
@NullMarked
package org.starl.sim.record;

import org.jspecify.annotations.NullMarked;
