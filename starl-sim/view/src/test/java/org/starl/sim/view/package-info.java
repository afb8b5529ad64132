/** Tests of the window: its model, and its components painted in memory, all without a screen. */
@NullMarked
package org.starl.sim.view;

import org.jspecify.annotations.NullMarked;
