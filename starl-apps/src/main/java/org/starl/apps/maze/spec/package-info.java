/**
 * What the robots of a maze owe, judged by the true bodies and the true obstacles: {@link
 * org.starl.apps.maze.spec.MazeSpec}.
 *
 * <p>May import: core, primitives, {@code logic} beside it.
 */
@NullMarked
package org.starl.apps.maze.spec;

import org.jspecify.annotations.NullMarked;
