/**
 * The smallest app, as a simulation.
 *
 * <p>May import: core, primitives, sim, {@code org.starl.apps}, {@code logic} and {@code view}
 * beside it.
 */
@NullMarked
package org.starl.apps.hello;

import org.jspecify.annotations.NullMarked;
