/**
 * The maze as a simulation: its floors (drawn, the original StarL's files, grid maps), its robots'
 * places, its specifications and the report of a run.
 *
 * <p>May import: core, primitives, sim, {@code org.starl.apps}, {@code logic}, {@code spec} and
 * {@code view} beside it.
 */
@NullMarked
package org.starl.apps.maze;

import org.jspecify.annotations.NullMarked;
