/**
 * The task ledger: tasks are added, claimed, begun and finished, each exactly once, by robots that crash
 * and restart. {@link org.starl.primitives.ledger.TaskLedger} on a robot, {@link
 * org.starl.primitives.ledger.LedgerPrim} for its app; {@link org.starl.primitives.ledger.Allocation} says
 * which task a free robot claims.
 *
 * <p>All changes are entries of one log, a sequence of decrees of the {@link
 * org.starl.primitives.agreement.Synod}. An entry takes effect if the entries before it allow it, so that
 * no clock decides anything: a lease that runs out is an entry, too, and a slow robot whose claim has
 * ended learns so when it begins. The log is kept as its state: the tasks that are not finished, the
 * present program of each robot, and the last number of each source.
 *
 * <p>(a) <b>Safety</b>, under any loss, delay, duplication, reordering, partition, crash and restart, and
 * however wrong suspicions are:
 *
 * <ul>
 *   <li>{@code OneLog}: all robots apply the same entries at one number.
 *   <li>{@code BegunByOne}: a robot is told that it may do a task only if no other robot is told so,
 *       unless the application has reopened the task between the two.
 *   <li>{@code FinishedOnce}: a task is finished at most once, by the robot that has begun it.
 *   <li>{@code Kept}: a task that a robot was told is added stays, until it is finished.
 *   <li>{@code Told}: a robot is told that it has a claim, or that one has ended, only if the log says so;
 *       and it gives back no claim of another robot.
 * </ul>
 *
 * <p>(b) <b>Progress.</b> {@code Answered}: with message delay δ, a majority of the voters up and one
 * proposer, a call is DONE after 4δ, and other robots hear of it δ later; UNKNOWN not before its deadline. Calls that compete go into one
 * decree, or come after growing random pauses. {@code Freed}: the claim of a robot that crashes before it
 * begins ends a lease and half a second for each voter before the first live one later, then 4δ; at once
 * if its program starts again. So an open task is claimed while a majority and a robot that claims it are
 * up. ({@code Suspected}) No voter proposes that end while it has heard the robot within the lease;
 * ({@code Behind}) who hears a robot that asks for decrees sends the next one in the same step. A
 * begun task of a dead robot stays begun: {@code isSilent} tells it, and the application reopens it if
 * it can be done again. It costs 4V + N messages for V voters and N robots, and one message from each
 * robot to each voter with the beacon's period.
 *
 * <p>(c) <b>Assumptions.</b> Those of {@link org.starl.primitives.agreement}: the voters are fixed, and a
 * majority of them is up, or comes back with its storage. A ledger is of the robots of the deployment.
 *
 * <p>Every run of a ledger is a run of the theory {@code Ledger_decls}, whose safety is proved; {@link
 * org.starl.primitives.ledger.LedgerConformance} replays each run on its automaton.
 *
 * <p>May import: core, {@code org.starl.primitives}, its {@code agreement} and {@code suspicion}.
 */
@NullMarked
package org.starl.primitives.ledger;

import org.jspecify.annotations.NullMarked;
