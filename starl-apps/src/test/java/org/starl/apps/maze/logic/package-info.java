/** What robots of a maze know. May import: core, primitives. */
@NullMarked
package org.starl.apps.maze.logic;

import org.jspecify.annotations.NullMarked;
