/**
 * What comes of asking whether an automaton is as it should be: one {@link
 * org.starl.lang.verdict.Verdict} for all tools that ask.
 *
 * <p>May import: nothing.
 */
@NullMarked
package org.starl.lang.verdict;

import org.jspecify.annotations.NullMarked;
