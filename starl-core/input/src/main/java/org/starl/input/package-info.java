/**
 * Reads users' input: quantities with their units, whole files, and suggestions for misspelt names.
 *
 * <p>Contract: input that cannot be read raises {@link org.starl.input.BadInput}, whose message is
 * one line that names the value and what was expected; nothing is guessed.
 *
 * <p>May import: the JDK alone.
 */
@NullMarked
package org.starl.input;

import org.jspecify.annotations.NullMarked;
