/**
 * The language server: an editor that speaks the Language Server Protocol shows the errors of a {@code
 * .starl} file while it is written, the type of a name under the pointer, and goes to its declaration.
 * The server reads the protocol from a stream and writes it to another; it touches no file but those that
 * an open one uses.
 *
 * <p>May import: {@code org.starl.lang.read}, {@code org.starl.lang.tree}, LSP4J.
 */
@NullMarked
package org.starl.lang.server;

import org.jspecify.annotations.NullMarked;
