/**
 * The logic layer's messages (paper, section 5.1): typed channels over a robot's {@link
 * org.starl.platform.Radio}, a versioned wire format (documented in {@code docs/wire-format.md}), and
 * reliable unicast. A bad or foreign datagram is counted and dropped, never thrown through an app.
 *
 * <p>May import: {@code org.starl} ids, {@code org.starl.platform}, {@code org.starl.trace}.
 */
@NullMarked
package org.starl.comms;

import org.jspecify.annotations.NullMarked;
