/**
 * Fakes for core's own tests: a platform with a clock that is turned by hand. It promises no more
 * than the ports do. May import core.
 */
@NullMarked
package org.starl.testing;

import org.jspecify.annotations.NullMarked;
