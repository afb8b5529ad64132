/**
 * The parts of the gvh that belong to no layer above (paper, section 2): {@link
 * org.starl.gvh.GvhVariable}, a variable that one owner writes and everybody on the robot reads,
 * and {@code gvh.log} and {@code gvh.trace}. Strand only.
 *
 * <p>May import: {@code org.starl.id}, {@code org.starl.platform}, {@code org.starl.shape},
 * {@code org.starl.trace}.
 */
@NullMarked
package org.starl.gvh;

import org.jspecify.annotations.NullMarked;
