/**
 * All states of a few participants that run a protocol's code.
 *
 * <p>Contract: {@link org.starl.primitives.exhaustive.StateSearch} visits each state that the
 * participants can reach within the bounds of a {@link
 * org.starl.primitives.exhaustive.StateSpace}, whatever the network does, and finds a shortest way to
 * a state that violates an invariant. The protocol's own code runs; nothing is a model of it. Its
 * state is what the protocol declares: two participants of equal text behave alike from then on.
 * Not covered: times (what a timer may do, it may do at any time), and what is beyond the bounds.
 *
 * <p>May import: the JDK.
 */
@NullMarked
package org.starl.primitives.exhaustive;

import org.jspecify.annotations.NullMarked;
