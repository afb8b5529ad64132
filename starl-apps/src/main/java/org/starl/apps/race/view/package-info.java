/**
 * Draws a race: the points, their winners, and where each robot drives.
 *
 * <p>May import: core, primitives, sim, the app's {@code logic} and {@code spec}, {@code java.awt}.
 */
@NullMarked
package org.starl.apps.race.view;

import org.jspecify.annotations.NullMarked;
