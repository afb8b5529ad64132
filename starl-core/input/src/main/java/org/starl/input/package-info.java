/**
 * Reads users' input: quantities with their units, whole files, YAML and JSON documents, and
 * suggestions for misspelt names. {@link org.starl.input.DocumentReader} makes a tree of {@link
 * org.starl.input.Node}s with line numbers; {@link org.starl.input.Section} reads the tree against
 * {@link org.starl.input.Field}s, the description from which the JSON schemas come too.
 *
 * <p>Contract: input that cannot be read raises {@link org.starl.input.BadInput}, whose message is
 * one line that names the file and line, the value and the expected form; nothing is guessed.
 *
 * <p>May import: the JDK as far as Android API 26 has it, Jackson's core and YAML parser (no data
 * binding).
 */
@NullMarked
package org.starl.input;

import org.jspecify.annotations.NullMarked;
