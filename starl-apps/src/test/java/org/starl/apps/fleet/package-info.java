/** Whole runs of fleets. May import: core, primitives, sim. */
@NullMarked
package org.starl.apps.fleet;

import org.jspecify.annotations.NullMarked;
