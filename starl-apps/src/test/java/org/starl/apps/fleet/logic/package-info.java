/** Sections and ways. May import: core, primitives. */
@NullMarked
package org.starl.apps.fleet.logic;

import org.jspecify.annotations.NullMarked;
