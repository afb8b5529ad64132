/**
 * Distributed search as a simulation, {@code starl run search}: houses from the original StarL's
 * files or generated, the robots' simulated sensors, and the story of a run.
 *
 * <p>May import: core, primitives, sim, {@code org.starl.apps}, {@code logic}, {@code spec} and
 * {@code view} beside it.
 */
@NullMarked
package org.starl.apps.search;

import org.jspecify.annotations.NullMarked;
