/**
 * The fleet on robots: its parameters, the built-in map, and deliveries drawn from the seed.
 *
 * <p>May import: core, input, primitives, {@code logic} beside it, {@code org.starl.apps}.
 */
@NullMarked
package org.starl.apps.fleet.robot;

import org.jspecify.annotations.NullMarked;
