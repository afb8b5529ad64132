/**
 * Checks automata at small sizes: {@link org.starl.lang.check.Search} visits every state that can be
 * reached, breadth first, and evaluates the invariants in each. Of states that differ only in the names
 * of the elements of opaque types one is visited ({@link org.starl.lang.check.Symmetry}): the language
 * compares these elements and does nothing else with them. What is found is a {@link
 * org.starl.lang.check.Finding}, with a shortest run to it. Progress is asked of all fair runs through
 * the visited states ({@link org.starl.lang.check.Runs}); then no states count as one. A search is deterministic.
 *
 * <p>May import: {@code org.starl.lang.tree}, {@code org.starl.lang.eval}, {@code
 * org.starl.lang.verdict}.
 */
@NullMarked
package org.starl.lang.check;

import org.jspecify.annotations.NullMarked;
