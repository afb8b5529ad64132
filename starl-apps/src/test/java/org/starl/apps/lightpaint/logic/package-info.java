/** Tests of light painting. May import: core, primitives, sim. */
@NullMarked
package org.starl.apps.lightpaint.logic;

import org.jspecify.annotations.NullMarked;
