/**
 * Randomness that is the same on every JVM: one small generator, forked by name, with samplers over
 * {@code StrictMath}.
 *
 * <p>May import: the JDK.
 */
@NullMarked
package org.starl.random;

import org.jspecify.annotations.NullMarked;
