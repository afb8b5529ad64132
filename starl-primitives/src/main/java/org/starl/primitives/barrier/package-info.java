/**
 * Barrier synchronisation (the paper names it among StarL's primitives, section 4): {@link
 * org.starl.primitives.barrier.Barrier} on a robot, {@link org.starl.primitives.barrier.BarrierPrim}
 * for its app. Reusable: generations 1, 2, 3, ...
 *
 * <p>The outcome of each generation is decided once, by one decree of the {@link
 * org.starl.primitives.agreement.Synod}: passed, or broken by the absence of some. Those are members
 * of no later generation. Whoever waits and sees the end of its generation proposes it; who waits
 * asks those who are not there yet, and leaves out who does not answer, or, at a deadline, who has
 * not arrived.
 *
 * <p>(a) <b>Safety</b>, under any loss, delay, duplication, reordering, partition, crash and restart,
 * however wrong suspicions are:
 *
 * <ul>
 *   <li>{@code NoEarly}: passed in generation g means that all members of g have arrived in g. An
 *       arrival counts for its own generation, and is kept if it comes early.
 *   <li>{@code Uniform}: nobody is told passed where another one is told failed for the same
 *       generation, and all who are told failed are told the same ones missing. Who is missing, if it
 *       lives, is told excluded.
 * </ul>
 *
 * <p>(b) <b>Progress</b>, {@code NotHung}. With message delay δ and a majority of the members' robots
 * up: from the last arrival, δ + 4δ + δ. A member that crashes costs the others its silence Ts and
 * then 5δ, and so does, for 6δ more, each that crashes after it has arrived and was to propose. A
 * member that lives and does not come costs them the deadline. Whatever happens, who waits is told
 * something within two deadlines: at worst {@code unknown}, for want of a majority, and then to arrive
 * again is to wait on for the same generation. It costs N² arrivals and answers, 4N messages to
 * decide, N to tell.
 *
 * <p>(c) <b>Assumptions.</b> Those of {@link org.starl.primitives.agreement}; the robots of the
 * members of generation 1 are the acceptors, for all generations. Each must construct the barrier to
 * vote, and its program must stay for others' sake until they have been told as well. A restarted
 * robot is another participant, hence no member, and is told excluded; it goes on voting. At most 83
 * members.
 *
 * <p>The handlers realise the actions of the theory {@code Barrier_agreement}, every run of which is
 * one of {@code Barrier_decls}; {@link org.starl.primitives.barrier.BarrierConformance} takes each run
 * through the automaton of the latter, of which safety is proved. A decree holds the outcomes of all generations before it as well, so that who was
 * behind misses none.
 *
 * <p>May import: core, {@code org.starl.primitives}, its {@code agreement}, {@code membership} and
 * {@code suspicion}.
 */
@NullMarked
package org.starl.primitives.barrier;

import org.jspecify.annotations.NullMarked;
