/**
 * Authenticated and encrypted datagrams between two robots. A {@link org.starl.session.Session} is
 * for one start of one robot's program with one start of another's: both contribute a fresh {@link
 * org.starl.session.Nonce} to its keys. So a datagram that was recorded in another run, or before a
 * restart of either robot, is never accepted, even if the robots' keys are the same.
 *
 * <p>A robot gets its sessions from its platform ({@link org.starl.session.Sessions}). How real
 * robots exchange their nonces is in docs/security.md; simulated robots know each other's starts
 * ({@link org.starl.session.KnownStarts}).
 *
 * <p>May import: {@code org.starl.id}.
 */
@NullMarked
package org.starl.session;

import org.jspecify.annotations.NullMarked;
