/**
 * Draws the intersection: zones in the colour of the car that holds them, intended routes.
 *
 * <p>May import: core, primitives, sim, the app's {@code logic} and {@code spec}, {@code
 * java.awt}.
 */
@NullMarked
package org.starl.apps.intersection.view;

import org.jspecify.annotations.NullMarked;
