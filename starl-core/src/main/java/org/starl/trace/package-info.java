/**
 * The events of a run, and the lines that store them (one JSON object per line, a header first).
 * Monitors, viewers and recorders observe a run only through these events, so they work on a
 * recorded run as on a live one.
 *
 * <p>May import: {@code org.starl} ids, {@code org.starl.geometry}, {@code org.starl.platform},
 * {@code org.starl.random}.
 */
@NullMarked
package org.starl.trace;

import org.jspecify.annotations.NullMarked;
