/**
 * What people type, read with care: quantities with their units, near matches of a misspelt name,
 * and the one line that a mistake is told in.
 *
 * <p>Contract: what cannot be read raises {@link org.starl.input.BadInput}, whose message is one
 * line that names the value and what was expected; nothing is guessed.
 *
 * <p>May import: the JDK alone.
 */
@NullMarked
package org.starl.input;

import org.jspecify.annotations.NullMarked;
