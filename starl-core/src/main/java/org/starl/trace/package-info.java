/**
 * The events of a run, and the lines that store them (one JSON object per line, a header first).
 * Monitors, viewers and recorders observe a run only through these events, so they work on a
 * recorded run as on a live one. Facts, values of variables and messages in events are typed; a
 * {@link org.starl.trace.Vocabulary} lets a reader make the same values of the lines.
 *
 * <p>May import: {@code org.starl} ids, {@code org.starl.geometry}, {@code org.starl.random}, {@code
 * org.starl.shape}.
 */
@NullMarked
package org.starl.trace;

import org.jspecify.annotations.NullMarked;
