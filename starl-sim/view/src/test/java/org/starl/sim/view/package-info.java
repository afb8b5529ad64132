/** Tests of the window's model, and of its components painted in memory, without a screen. */
@NullMarked
package org.starl.sim.view;

import org.jspecify.annotations.NullMarked;
