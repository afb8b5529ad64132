/**
 * Reads SVG drawings, draws painters, and writes what was painted.
 *
 * <p>May import: core, primitives, sim, {@code logic} and {@code spec} beside it, Apache Batik, {@code
 * java.awt}, {@code javax.imageio}, {@code org.xml.sax}, {@code org.w3c}.
 */
@NullMarked
package org.starl.apps.lightpaint.view;

import org.jspecify.annotations.NullMarked;
