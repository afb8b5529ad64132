/**
 * The specification of a maze, checked against true bodies and true obstacles: {@link
 * org.starl.apps.maze.spec.MazeSpec}.
 *
 * <p>May import: core, primitives, {@code logic} beside it.
 */
@NullMarked
package org.starl.apps.maze.spec;

import org.jspecify.annotations.NullMarked;
