/**
 * Random numbers that are equal on every JVM: one small generator, forked by name, with samplers
 * based on {@code StrictMath}.
 *
 * <p>May import: the JDK.
 */
@NullMarked
package org.starl.random;

import org.jspecify.annotations.NullMarked;
