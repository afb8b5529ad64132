/** Mazes drawn from the seed. May import: core, input, primitives, {@code logic} beside it. */
@NullMarked
package org.starl.apps.maze.robot;

import org.jspecify.annotations.NullMarked;
