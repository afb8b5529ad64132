/** Tests of pages and other files that show a run. */
@NullMarked
package org.starl.sim.view.page;

import org.jspecify.annotations.NullMarked;
