/**
 * Leader election (paper, section 4.4): {@link org.starl.primitives.election.Election} on a robot,
 * {@link org.starl.primitives.election.ElectionPrim} for its app.
 *
 * <p>Elections of one instance are numbered: terms 1, 2, 3, ... Each term is decided by one decree of
 * the {@link org.starl.primitives.agreement.Synod}, in which all participants vote. The two
 * implementations that the paper names are {@linkplain
 * org.starl.primitives.election.ElectionStrategy strategies}: they choose whom to propose and when,
 * and decide nothing. A new term begins when the leader is suspected of having crashed, or its robot
 * is back as another incarnation.
 *
 * <p>(a) <b>Safety</b>, under any loss, delay, duplication, reordering, partition, crash and restart:
 *
 * <ul>
 *   <li>{@code Agreement}: equal terms of one instance mean equal leaders, always. The paper's "start
 *       election within d time of each other" becomes "in the same term"; those who start within two
 *       message delays of each other, with nobody suspected, meet in one term.
 *   <li>{@code Soundness}: {@code Leader} is c in term t only if c stood for election in t, which
 *       nobody does who has not called {@code do_election}.
 * </ul>
 *
 * <p>(b) <b>Progress.</b> With message delay δ, a majority of participants up and suspicion that is
 * right:
 *
 * <ul>
 *   <li>{@code Elected}: all who take part come to the same live leader. From {@code do_election}: 2δ
 *       to hear of each other, 4δ to decide, δ to tell; 6δ more (Bully: 8δ) for each candidate that
 *       crashes meanwhile and was to propose. From a leader's crash: its silence Ts before that, and
 *       once more if the one elected in its place is dead as well. It costs N² candidacies, 4N
 *       messages to decide, N to tell; then one broadcast every heartbeat.
 *   <li>{@code Told}: whatever happens, {@code Leader} is null for no longer than the deadline; then
 *       it is fail, until the app calls {@code do_election} again, or the term is decided after all,
 *       or another one begins.
 * </ul>
 *
 * <p>What is not promised: that there is one leader at any moment. One that was wrongly suspected, or
 * is cut off, goes on in its term until it hears of a later one. Whatever a leader commands should
 * carry its term; what one robot alone may do belongs under a mutex.
 *
 * <p>(c) <b>Assumptions.</b> Those of {@link org.starl.primitives.agreement}, participants being the
 * acceptors. Each participant must construct the election to vote, whether it takes part or not. A
 * robot that votes only, or has restarted and not yet called {@code do_election}, learns who leads,
 * suspects nobody, and is never elected.
 *
 * <p>The handlers realise the actions of the theory {@code Election_agreement}, every run of which is
 * one of {@code Election_decls}; {@link org.starl.primitives.election.ElectionConformance} takes each
 * run through the automaton of the latter, of which safety is proved. A call after a fail works for
 * the same term again: were it to begin the next one, short deadlines could end each other's
 * elections for ever.
 *
 * <p>May import: core, {@code org.starl.primitives}, its {@code agreement} and {@code suspicion}.
 */
@NullMarked
package org.starl.primitives.election;

import org.jspecify.annotations.NullMarked;
