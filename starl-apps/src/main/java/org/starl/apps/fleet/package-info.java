/**
 * The fleet as a simulation: its map, its deliveries, its specification and the report of a run.
 *
 * <p>May import: core, primitives, sim, {@code org.starl.apps}, {@code files}, {@code logic}, {@code robot},
 * {@code spec} and {@code view} beside it.
 */
@NullMarked
package org.starl.apps.fleet;

import org.jspecify.annotations.NullMarked;
