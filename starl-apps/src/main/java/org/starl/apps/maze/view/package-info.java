/**
 * The drawing of a maze.
 *
 * <p>May import: core, {@code org.starl.sim.record}, {@code logic} beside it, {@code java.awt}.
 */
@NullMarked
package org.starl.apps.maze.view;

import org.jspecify.annotations.NullMarked;
