/**
 * The crash detector of the primitives: {@link org.starl.primitives.suspicion.Suspicion}. It judges by
 * silence: a participant that is needed is suspected when nothing has come from it for a given time, not
 * even an acknowledgement.
 *
 * <p>(a) <b>Safety.</b> None. A suspicion may be wrong at any time, in both directions: a slow or
 * disconnected participant is suspected while it lives, and a crashed one is not suspected until its
 * silence has lasted. A user must be safe for every answer; only its progress may depend on them.
 *
 * <p>(b) <b>Progress.</b> A needed participant that is silent from some moment on is suspected from
 * {@code silenceNs} after that moment, as long as it is silent. A participant that is heard at least every
 * {@code silenceNs} while needed is never suspected. So once messages arrive within δ, and each needed
 * participant is asked and answers within less than {@code silenceNs} - 2δ, exactly the crashed
 * participants are suspected (an eventually perfect detector; Chandra, Toueg, "Unreliable failure
 * detectors for reliable distributed systems", Journal of the ACM 43(2), 1996).
 *
 * <p>(c) <b>Assumptions.</b> For (b) only: the clock runs faster than real time by no more than the
 * remaining slack, and the user repeats its messages to a needed participant until it answers.
 *
 * <p>May import: core.
 */
@NullMarked
package org.starl.primitives.suspicion;

import org.jspecify.annotations.NullMarked;
