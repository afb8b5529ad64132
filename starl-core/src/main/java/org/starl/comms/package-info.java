/**
 * Messages of the logic layer (paper, section 5.1): typed channels over a robot's {@link
 * org.starl.platform.Radio}, a versioned wire format (documented in {@code docs/wire-format.md}),
 * and reliable unicast. An invalid datagram is counted and dropped; it never causes an exception in
 * an app.
 *
 * <p>May import: {@code org.starl} ids, {@code org.starl.platform}, {@code org.starl.session}, {@code
 * org.starl.shape}, {@code org.starl.time}, {@code org.starl.trace}.
 */
@NullMarked
package org.starl.comms;

import org.jspecify.annotations.NullMarked;
