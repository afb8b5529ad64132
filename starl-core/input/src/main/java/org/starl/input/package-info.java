/**
 * Reading documents that people write. {@link org.starl.input.DocumentReader} makes a tree of {@link
 * org.starl.input.Node}s with line numbers from YAML; {@link org.starl.input.Section} reads the tree
 * against {@link org.starl.input.Field}s, the description from which the JSON schemas come too.
 * Each error is one line: file, line, key, value, what was expected.
 *
 * <p>May import: the JDK as far as Android API 26 has it, Jackson's core and YAML parser (no data
 * binding).
 */
@NullMarked
package org.starl.input;

import org.jspecify.annotations.NullMarked;
