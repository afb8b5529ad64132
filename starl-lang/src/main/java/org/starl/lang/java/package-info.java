/**
 * Makes Java of an automaton: {@link org.starl.lang.java.JavaSources} gives the text of its executable
 * form, {@code MutexAutomaton}, and of its actions, {@code MutexAction}, as {@code
 * org.starl.spec.automaton} has them, in the layout of google-java-format.
 *
 * <p>Opaque types are infinite, so quantifiers, comprehensions and maps are evaluated at the finitely
 * many values that a condition distinguishes, and once for all other values. A condition for which these
 * values cannot be found is an error of the source. Functions that no action needs are left out if
 * they cannot be evaluated; invariants are. A used automaton has a class of its own.
 *
 * <p>May import: {@code org.starl.lang.read}, {@code org.starl.lang.tree}.
 */
@NullMarked
package org.starl.lang.java;

import org.jspecify.annotations.NullMarked;
