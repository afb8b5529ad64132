/**
 * How a race is drawn: points, who has won them, who drives where.
 *
 * <p>May import: core, primitives, sim, the app's {@code logic} and {@code spec}, {@code
 * java.awt}.
 */
@NullMarked
package org.starl.apps.race.view;

import org.jspecify.annotations.NullMarked;
