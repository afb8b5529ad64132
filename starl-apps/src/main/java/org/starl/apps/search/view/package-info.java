/**
 * How a search is drawn.
 *
 * <p>May import: core, {@code org.starl.sim.record}, {@code logic} and {@code spec} beside it, the
 * desktop.
 */
@NullMarked
package org.starl.apps.search.view;

import org.jspecify.annotations.NullMarked;
