/**
 * Randomness that is the same on every JVM: one small generator, forked by name, with samplers over
 * {@code StrictMath}. Imports the JDK only.
 */
@NullMarked
package org.starl.random;

import org.jspecify.annotations.NullMarked;
