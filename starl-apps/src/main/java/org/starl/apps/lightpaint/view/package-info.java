/**
 * Reads SVG drawings, draws painters, and writes what was painted.
 *
 * <p>May import: core, primitives, sim, {@code logic} and {@code spec} beside it, JSVG, {@code
 * java.awt}, {@code javax.imageio}, {@code javax.xml.stream}.
 */
@NullMarked
package org.starl.apps.lightpaint.view;

import org.jspecify.annotations.NullMarked;
