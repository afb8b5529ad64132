/**
 * Who seems to have crashed: {@link org.starl.primitives.suspicion.Suspicion}, the one crash
 * detector of the primitives. It judges by silence: nothing has come from a participant for a stated
 * time, not even an acknowledgement, while something is needed of it.
 *
 * <p>(a) <b>Safety.</b> It promises none. A suspicion may be wrong at any time, in both directions:
 * a slow or cut-off participant is suspected while it lives, and a crashed one is not until its
 * silence has lasted. Whoever uses it must be safe whatever it says, and may let progress alone
 * depend on it.
 *
 * <p>(b) <b>Progress.</b> Whoever is needed, and says nothing from some moment on, is suspected from
 * {@code silenceNs} after that moment for as long as it says nothing. Whoever is heard at least every
 * {@code silenceNs} while it is needed is never suspected. So, once messages arrive within δ and who
 * is needed is asked and answers within less than {@code silenceNs} - 2δ, suspicion is right: it
 * holds for the crashed, and for nobody else (an eventually perfect detector; Chandra, Toueg,
 * "Unreliable failure detectors for reliable distributed systems", Journal of the ACM 43(2), 1996).
 *
 * <p>(c) <b>Assumptions.</b> For (b) only: the clock does not run faster than real time by more than
 * the slack that is left, and its user sends to whom it needs until it is answered.
 *
 * <p>May import: core.
 */
@NullMarked
package org.starl.primitives.suspicion;

import org.jspecify.annotations.NullMarked;
