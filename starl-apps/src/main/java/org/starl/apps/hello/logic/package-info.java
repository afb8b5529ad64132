/**
 * The smallest app: drive one metre to the right and stop.
 *
 * <p>May import: core and primitives only.
 */
@NullMarked
package org.starl.apps.hello.logic;

import org.jspecify.annotations.NullMarked;
