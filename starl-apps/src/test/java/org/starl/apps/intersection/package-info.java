/** Whole runs of the intersection. May import: core, primitives, sim. */
@NullMarked
package org.starl.apps.intersection;

import org.jspecify.annotations.NullMarked;
