/** Whole races. May import: core, primitives, sim. */
@NullMarked
package org.starl.apps.race;

import org.jspecify.annotations.NullMarked;
