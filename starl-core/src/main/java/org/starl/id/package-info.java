/**
 * Names of robots and of their processes: immutable values. The lowest layer.
 *
 * <p>May import: the JDK.
 */
@NullMarked
package org.starl.id;

import org.jspecify.annotations.NullMarked;
