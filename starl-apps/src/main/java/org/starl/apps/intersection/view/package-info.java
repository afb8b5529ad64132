/**
 * How the intersection is drawn: zones and who holds them, intended routes.
 *
 * <p>May import: core, primitives, sim, the app's {@code logic} and {@code spec}, {@code
 * java.awt}.
 */
@NullMarked
package org.starl.apps.intersection.view;

import org.jspecify.annotations.NullMarked;
