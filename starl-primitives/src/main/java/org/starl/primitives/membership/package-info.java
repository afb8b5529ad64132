/**
 * Participants and their changes: numbered {@link org.starl.primitives.membership.View}s, and the {@link
 * org.starl.primitives.membership.Confinement} of participants that seem to have crashed. Registration
 * implements the interface {@link org.starl.primitives.membership.Membership}, Mutex reads it.
 *
 * <p>May import: core.
 */
@NullMarked
package org.starl.primitives.membership;

import org.jspecify.annotations.NullMarked;
