/**
 * Immutable plane geometry: millimetres, radians counter-clockwise from the x axis, y upwards. All
 * functions are exact or use {@code StrictMath}: equal inputs give equal bits on every JVM.
 *
 * <p>May import: the JDK, {@code org.starl.time}.
 */
@NullMarked
package org.starl.geometry;

import org.jspecify.annotations.NullMarked;
