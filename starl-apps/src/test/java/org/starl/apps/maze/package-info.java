/** Whole mazes. May import: core, primitives, sim. */
@NullMarked
package org.starl.apps.maze;

import org.jspecify.annotations.NullMarked;
