/**
 * The commands on many runs: {@code campaign}, {@code sweep}, {@code explore}, {@code merge}, {@code
 * ci} and {@code mutants}. The work of one command can be divided into shards, in any processes; their
 * rows, merged, give what one process prints. A bad run is told with its replay line, and can be shrunk.
 *
 * <p>May import: {@code org.starl.cli.command}, {@code org.starl.cli.request}, {@code
 * org.starl.cli.run}, {@code org.starl.cli.report}, {@code org.starl.cli.mutants}; all other modules.
 */
@NullMarked
package org.starl.cli.campaign;

import org.jspecify.annotations.NullMarked;
