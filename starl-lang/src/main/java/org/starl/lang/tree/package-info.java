/**
 * A source after reading: automata, programs and primitives, with every name resolved and every type checked. All that is made
 * of a source is made of these trees. They are immutable, and print nothing.
 *
 * <p>May import: nothing of StarL.
 */
@NullMarked
package org.starl.lang.tree;

import org.jspecify.annotations.NullMarked;
