/**
 * The Race App as a simulation, {@code starl run race}: its points, from a file or drawn, and the
 * story of a run.
 *
 * <p>May import: core, primitives, sim, {@code org.starl.apps}, {@code logic}, {@code spec} and
 * {@code view} beside it.
 */
@NullMarked
package org.starl.apps.race;

import org.jspecify.annotations.NullMarked;
