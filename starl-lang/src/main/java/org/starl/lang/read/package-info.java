/**
 * Reads {@code .starl} files: {@link org.starl.lang.read.SourceReader} gives checked trees, or {@link
 * org.starl.lang.read.SourceErrors} with every error found: file, line, column, what was found, and what
 * was expected. The meaning of the language is in {@code docs/language.md}. A program becomes an
 * automaton here, so that what works on automata need not know programs.
 *
 * <p>May import: {@code org.starl.input}, {@code org.starl.lang.tree}, ANTLR's runtime.
 */
@NullMarked
package org.starl.lang.read;

import org.jspecify.annotations.NullMarked;
