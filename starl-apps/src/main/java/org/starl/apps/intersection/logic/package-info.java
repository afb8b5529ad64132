/**
 * The automatic intersection of the paper's section 3: cars register, ask for all their zones at
 * once, cross, and give each zone back as they leave it.
 *
 * <p>{@link org.starl.apps.intersection.logic.IntersectionApp} is Figure 4; {@link
 * org.starl.apps.intersection.logic.IcpProgram} is Figure 3; {@link
 * org.starl.apps.intersection.logic.Crossing} is Figure 2: zones, arms and the twelve routes. The
 * same classes run in the simulator and on robots.
 *
 * <p>May import: core and primitives only.
 */
@NullMarked
package org.starl.apps.intersection.logic;

import org.jspecify.annotations.NullMarked;
