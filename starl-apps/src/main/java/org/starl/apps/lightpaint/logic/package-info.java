/**
 * What a painter runs: the app, strokes, and their assignment.
 *
 * <p>May import: core and primitives only.
 */
@NullMarked
package org.starl.apps.lightpaint.logic;

import org.jspecify.annotations.NullMarked;
