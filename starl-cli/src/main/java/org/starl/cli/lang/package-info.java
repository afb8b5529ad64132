/**
 * The commands on sources in StarL's language: {@code check}, {@code prove}, {@code compile} and
 * {@code language-server}. An error is one line with its place in the source.
 *
 * <p>May import: {@code org.starl.cli.command}; {@code org.starl.lang}.
 */
@NullMarked
package org.starl.cli.lang;

import org.jspecify.annotations.NullMarked;
