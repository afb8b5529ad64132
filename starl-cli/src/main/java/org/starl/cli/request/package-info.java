/**
 * Which run a user asks for: an app with its parameters and settings, a seed. A request is read from
 * options, a scenario file, a deployment file or the header of a trace, and can be written as the
 * command line that makes the run again.
 *
 * <p>May import: {@code org.starl.cli.command}; all other modules.
 */
@NullMarked
package org.starl.cli.request;

import org.jspecify.annotations.NullMarked;
