/**
 * Draws a fleet: lanes, places, loads and the robots' ways.
 *
 * <p>May import: core, primitives, sim, the app's {@code logic}, {@code java.awt}.
 */
@NullMarked
package org.starl.apps.fleet.view;

import org.jspecify.annotations.NullMarked;
