/** A race's logic, and racers with planted bugs. May import: core, primitives. */
@NullMarked
package org.starl.apps.race.logic;

import org.jspecify.annotations.NullMarked;
