/** Tests of light painting. May import: core, primitives, sim. */
@NullMarked
package org.starl.apps.lightpaint.view;

import org.jspecify.annotations.NullMarked;
