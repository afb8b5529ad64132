/**
 * What light painting owes, as a monitor: nothing off the drawing, no place twice, all of it, in
 * time. All from true positions.
 *
 * <p>May import: core, primitives, {@code logic} beside it.
 */
@NullMarked
package org.starl.apps.lightpaint.spec;

import org.jspecify.annotations.NullMarked;
