/**
 * The commands on one run: {@code run}, {@code record}, {@code replay}, {@code compare}, {@code
 * verify-determinism}, and {@code robot}, which is one robot of {@code run --processes}. A run goes to
 * files, a window or the terminal, with its verdict.
 *
 * <p>May import: {@code org.starl.cli.command}, {@code org.starl.cli.request}; all other modules.
 */
@NullMarked
package org.starl.cli.run;

import org.jspecify.annotations.NullMarked;
