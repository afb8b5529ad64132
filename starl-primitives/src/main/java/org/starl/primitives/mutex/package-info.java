/**
 * Mutual exclusion on sets of sections (paper, section 4.5), by Ricart and Agrawala's algorithm among
 * participants that come and go.
 *
 * <p>May import: core, {@code org.starl.primitives}, {@code org.starl.primitives.membership}.
 */
@NullMarked
package org.starl.primitives.mutex;

import org.jspecify.annotations.NullMarked;
