/**
 * The specification of a fleet, as monitors.
 *
 * <p>May import: core, primitives, {@code logic} beside it.
 */
@NullMarked
package org.starl.apps.fleet.spec;

import org.jspecify.annotations.NullMarked;
