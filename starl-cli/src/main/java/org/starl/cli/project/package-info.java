/**
 * Projects: {@code new} writes one of a user's own, which builds and passes its tests as it is; {@link
 * org.starl.cli.project.LauncherBuild} builds this one before {@code ./starl} runs a command.
 *
 * <p>May import: {@code org.starl.cli.command}; core.
 */
@NullMarked
package org.starl.cli.project;

import org.jspecify.annotations.NullMarked;
