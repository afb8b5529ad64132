/** Robots as processes. */
@NullMarked
package org.starl.launch;

import org.jspecify.annotations.NullMarked;
