/**
 * What happened in a run: events, and the documented lines that store them (one JSON object a line,
 * a header first). Monitors, viewers and recorders see a run through these events only, so that a
 * recorded run serves them as well as a live one.
 *
 * <p>May import: {@code org.starl} ids, {@code org.starl.geometry}, {@code
 * org.starl.platform}, {@code org.starl.random}.
 */
@NullMarked
package org.starl.trace;

import org.jspecify.annotations.NullMarked;
