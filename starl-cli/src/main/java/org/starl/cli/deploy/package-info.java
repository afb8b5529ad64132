/**
 * The commands for real robots: {@code deploy} with its parts, {@code keygen} and {@code
 * simulated-create}. A deployment file is checked as a whole, and each error is one line, before a
 * robot moves.
 *
 * <p>May import: {@code org.starl.cli.command}, {@code org.starl.cli.request}, {@code
 * org.starl.cli.run}; all other modules.
 */
@NullMarked
package org.starl.cli.deploy;

import org.jspecify.annotations.NullMarked;
