/**
 * Campaigns, sweeps and explorations on Apache Spark: {@code starl campaign --on spark}. A task makes
 * some neighbouring runs and its result is the row of each, so a task that is lost with its machine
 * is run again to the same rows. The driver puts all rows in order, and needs memory for those that
 * are early.
 *
 * <p>May import: the command line, and Spark. No other module imports this one.
 */
@NullMarked
package org.starl.spark;

import org.jspecify.annotations.NullMarked;
