/**
 * Draws programs: {@link org.starl.lang.picture.ProgramPicture} gives an SVG file of the locations and
 * branches. Equal programs give equal files.
 *
 * <p>May import: {@code org.starl.lang.tree}.
 */
@NullMarked
package org.starl.lang.picture;

import org.jspecify.annotations.NullMarked;
