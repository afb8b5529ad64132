/**
 * Leader election (paper, section 4.4): {@link org.starl.primitives.election.Election} on a robot,
 * {@link org.starl.primitives.election.ElectionPrim} for its app.
 *
 * <p>The elections of one instance are numbered: terms 1, 2, 3, ... Each term is decided by one decree
 * of the {@link org.starl.primitives.agreement.Synod}, in which all participants vote. The paper's two
 * implementations are {@linkplain org.starl.primitives.election.ElectionStrategy strategies}: they choose
 * the candidate to propose, and when, and decide nothing. A new term begins when the leader is suspected
 * of having crashed, or its robot is back as another incarnation.
 *
 * <p>(a) <b>Safety</b>, under any loss, delay, duplication, reordering, partition, crash and restart:
 *
 * <ul>
 *   <li>{@code Agreement}: equal terms of one instance mean equal leaders, always. The paper's "start
 *       election within d time of each other" becomes "in the same term"; robots that start within two
 *       message delays of each other, while none is suspected, are in one term.
 *   <li>{@code Soundness}: {@code Leader} is c in term t only if c stood for election in t, after a call
 *       of {@code do_election}.
 * </ul>
 *
 * <p>(b) <b>Progress.</b> With message delay δ, a majority of participants up and correct suspicion:
 *
 * <ul>
 *   <li>{@code Elected}: all candidates come to know one live leader. From {@code do_election}: 2δ to
 *       hear of each other, 4δ to decide, δ to tell; 6δ more (Bully: 8δ) for each candidate that crashes
 *       meanwhile and was to propose. From a leader's crash: its silence Ts before that, and once more if
 *       the new leader is dead as well. It costs N² candidacies, 4N messages to decide, N to tell; then
 *       one broadcast every heartbeat.
 *   <li>{@code Told}: in every case, {@code Leader} is null for no longer than the deadline. Then it is
 *       fail, until the app calls {@code do_election} again, the term is decided, or another one begins.
 *       It is not fail any sooner.
 *   <li>{@code Suspected}: a robot stands against the leader that it knows only after Ts without a message
 *       of it, or once it has heard of the leader's restart.
 *   <li>{@code Behind}: a robot that hears another one of an earlier term, or a candidate of a term whose
 *       leader it knows, tells it in the same step.
 *   <li>{@code Says}: a robot that stands, decides a term, or learns that it leads broadcasts that in the same
 *       step; candidates and leaders repeat it.
 * </ul>
 *
 * <p>Not promised: that there is one leader at any moment. A leader that was wrongly suspected, or is
 * disconnected, continues in its term until it hears of a later one. A leader's commands should carry
 * its term; an action that only one robot may do at a time needs a mutex.
 *
 * <p>(c) <b>Assumptions.</b> Those of {@link org.starl.primitives.agreement}; the participants are the
 * acceptors. Each participant must construct the election to vote, whether it is a candidate or not. A
 * robot that only votes, or has restarted and not yet called {@code do_election}, learns the leader,
 * suspects no robot, and is never elected.
 *
 * <p>The handlers are the actions of the theory {@code Election_agreement}. Every run of that theory is a
 * run of {@code Election_decls}, whose safety is proved; {@link
 * org.starl.primitives.election.ElectionConformance} replays each run on its automaton. A call after a
 * fail works for the same term again: if it began the next term, short deadlines could end each other's
 * elections for ever.
 *
 * <p>May import: core, {@code org.starl.primitives}, its {@code agreement} and {@code suspicion}.
 */
@NullMarked
package org.starl.primitives.election;

import org.jspecify.annotations.NullMarked;
