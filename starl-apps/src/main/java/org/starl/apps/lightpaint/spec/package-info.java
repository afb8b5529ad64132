/**
 * The specification of light painting, as a monitor: nothing beside the drawing, no place twice,
 * all of it, in time; by true positions.
 *
 * <p>May import: core, primitives, {@code logic} beside it.
 */
@NullMarked
package org.starl.apps.lightpaint.spec;

import org.jspecify.annotations.NullMarked;
