/** The intersection's floor plan. May import: core. */
@NullMarked
package org.starl.apps.intersection.logic;

import org.jspecify.annotations.NullMarked;
