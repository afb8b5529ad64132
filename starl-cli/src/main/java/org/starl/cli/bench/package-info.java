/**
 * {@code bench}: the workloads of the primitives, the viewer's speed, and the table of all apps on
 * the inputs of a folder.
 *
 * <p>May import: {@code org.starl.cli.command}, {@code org.starl.cli.request}; all other modules.
 */
@NullMarked
package org.starl.cli.bench;

import org.jspecify.annotations.NullMarked;
