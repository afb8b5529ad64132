/**
 * A robot's body as values: what its wheels are told, what its bump sensors say, and the parameters
 * by which it moves. Immutable. Millimetres, seconds, radians counter-clockwise.
 *
 * <p>May import: {@code org.starl.geometry}.
 */
@NullMarked
package org.starl.body;

import org.jspecify.annotations.NullMarked;
