/**
 * Barrier synchronisation (in the paper's list of primitives, section 4): {@link
 * org.starl.primitives.barrier.Barrier} on a robot, {@link org.starl.primitives.barrier.BarrierPrim}
 * for its app. Reusable: generations 1, 2, 3, ...
 *
 * <p>The outcome of each generation is decided once, by one decree of the {@link
 * org.starl.primitives.agreement.Synod}: passed, or failed with the missing members, which are members
 * of no later generation. A waiting robot that sees the end of its generation proposes it. A waiting
 * robot asks the absent members, and gives up those that do not answer, or, at a deadline, all that have
 * not arrived.
 *
 * <p>(a) <b>Safety</b>, under any loss, delay, duplication, reordering, partition, crash and restart,
 * and however wrong suspicions are:
 *
 * <ul>
 *   <li>{@code NoEarly}: if generation g is passed, all its members have arrived in g. An arrival counts
 *       for its own generation, and is kept if it comes early.
 *   <li>{@code Uniform}: for one generation, no robot is told passed while another is told failed, and
 *       all that are told failed are told the same missing members. A missing member that lives is told
 *       excluded.
 * </ul>
 *
 * <p>(b) <b>Progress</b>, {@code NotHung}. With message delay δ and a majority of the members' robots up:
 * from the last arrival, δ + 4δ + δ. A member that crashes delays the others by its silence Ts and then
 * 5δ, and by 6δ more if it crashes after it has arrived and was to propose. A live member that does not
 * come delays them until the deadline. In every case a waiting robot is told an outcome within two
 * deadlines: at worst {@code unknown}, without a majority. To arrive again then means to go on waiting for
 * the same generation. No robot is told so sooner, and ({@code Suspected}) none proposes, before the
 * deadline, to exclude a member that it has heard within Ts. ({@code Behind}) Who hears a member that
 * is behind tells it in the same step, and asks one that is ahead. It costs N² arrivals and answers,
 * 4N messages to decide, N to tell.
 *
 * <p>(c) <b>Assumptions.</b> Those of {@link org.starl.primitives.agreement}; the robots of the members
 * of generation 1 are the acceptors of all generations. Each must construct the barrier to vote, and its
 * program must run until the other members have been told. A restarted robot is another participant: it
 * is no member, is told excluded, and still votes. At most 83 members.
 *
 * <p>The handlers are the actions of the theory {@code Barrier_agreement}. Every run of that theory is a
 * run of {@code Barrier_decls}, whose safety is proved; {@link
 * org.starl.primitives.barrier.BarrierConformance} replays each run on its automaton. A decree also holds
 * the outcomes of all earlier generations, so that a robot that was behind misses none.
 *
 * <p>May import: core, {@code org.starl.primitives}, its {@code agreement}, {@code membership} and
 * {@code suspicion}.
 */
@NullMarked
package org.starl.primitives.barrier;

import org.jspecify.annotations.NullMarked;
