/**
 * What a painter runs: strokes, who paints which, and the app.
 *
 * <p>May import: core and primitives only.
 */
@NullMarked
package org.starl.apps.lightpaint.logic;

import org.jspecify.annotations.NullMarked;
