/**
 * Units of time, in one place.
 *
 * <p>May import: the JDK.
 */
@NullMarked
package org.starl.time;

import org.jspecify.annotations.NullMarked;
