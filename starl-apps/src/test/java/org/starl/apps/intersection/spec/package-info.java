/** The intersection's monitors on events written by hand. May import: core, primitives. */
@NullMarked
package org.starl.apps.intersection.spec;

import org.jspecify.annotations.NullMarked;
