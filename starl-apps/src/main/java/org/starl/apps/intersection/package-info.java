/**
 * The intersection as a simulation: its scenarios, its cars' coming and going, its specifications
 * ({@code traffic_safety}, {@code traffic_progress}, {@code Inv_list_crit}) and the story of a run.
 *
 * <p>May import: core, primitives, sim, {@code org.starl.apps}, {@code logic}, {@code spec} and
 * {@code view} beside it.
 */
@NullMarked
package org.starl.apps.intersection;

import org.jspecify.annotations.NullMarked;
