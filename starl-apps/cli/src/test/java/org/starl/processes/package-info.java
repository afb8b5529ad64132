/** Robots as processes. */
@NullMarked
package org.starl.processes;

import org.jspecify.annotations.NullMarked;
