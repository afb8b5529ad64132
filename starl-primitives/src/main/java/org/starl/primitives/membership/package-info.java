/**
 * What the primitives know of who takes part: numbered {@link
 * org.starl.primitives.membership.View}s, and the {@link
 * org.starl.primitives.membership.Confinement} of those that seem to have crashed, behind the small
 * interface {@link org.starl.primitives.membership.Membership} that Registration implements and
 * Mutex reads.
 *
 * <p>May import: core.
 */
@NullMarked
package org.starl.primitives.membership;

import org.jspecify.annotations.NullMarked;
