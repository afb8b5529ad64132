/**
 * What the primitives know of who takes part: numbered {@link
 * org.starl.primitives.membership.View}s, behind the small interface {@link
 * org.starl.primitives.membership.Membership} that Registration implements and Mutex reads.
 *
 * <p>May import: core.
 */
@NullMarked
package org.starl.primitives.membership;

import org.jspecify.annotations.NullMarked;
