/**
 * The results of a campaign, as one page for a browser: self-contained, readable without its
 * script, and the same byte by byte for the same campaign. All text that is not this package's own is
 * escaped.
 *
 * <p>May import: core, {@code org.starl.sim}, {@code org.starl.primitives}, {@code org.starl.apps};
 * no other part of the command line.
 */
@NullMarked
package org.starl.cli.report;

import org.jspecify.annotations.NullMarked;
