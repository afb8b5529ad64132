/**
 * Mutual exclusion on sets of sections (paper, section 4.5), by Ricart and Agrawala's algorithm
 * among participants that come and go. {@link org.starl.primitives.mutex.MutexPrim} is what an app
 * uses, {@link org.starl.primitives.mutex.M_Mutex} the algorithm on a robot, {@code MutexProtocol}
 * the algorithm by itself, {@link org.starl.primitives.mutex.MutexSpec} this contract as monitors
 * over the trace; {@link org.starl.primitives.mutex.MutexConformance} takes each run through the
 * automaton of the theory {@code Mutex_decls}, of which safety is proved.
 *
 * <p><b>The contract.</b> Let delta be a time within which a message that is repeated until it is
 * answered arrives, N how many participants a process needs consent of, itself included.
 *
 * <ul>
 *   <li>(a) <b>Safety</b> ({@code Exclusive}; the paper's {@code Inv_mux_safety}): what two
 *       participants have access to is disjoint, always. All of a request is granted at the same
 *       time; sections are given back one by one or together.
 *   <li>(b) <b>Progress</b> ({@code Served}): if every holder releases within d1, a request has
 *       access within {@code d2 = (N - 1)(d1 + 2 delta) + 2 delta}, plus one turn for each newcomer
 *       that joined before it could hear of the request. Nobody starves: requests go first in the
 *       order of their logical times. Otherwise {@code failed} tells, at the latest at the
 *       deadline.
 *   <li>(c) <b>Non-interference</b> ({@code NonInterference}): while nobody holds, or waits with
 *       priority for, a section of a request, it has access within {@code d3 = 2 delta}. So
 *       requests with no section in common never wait for each other. That nobody <em>holds</em> a
 *       section, as the paper has it, is not enough: k holds A; j waits for {A, B}; i asks for B
 *       later than j, and waits for j, though nobody holds B.
 * </ul>
 *
 * <p>An uncontended request costs 2 (N - 1) messages and 2 delta; a release N - 1 messages. With no
 * loss delta is the longest delay; with loss, that and as many waits of {@link
 * org.starl.primitives.mutex.MutexTimes} as messages are lost in a row.
 *
 * <p><b>Envelope.</b> Safety holds under every loss, delay, duplication, reordering and partition,
 * whenever robots crash and restart, and whoever is taken for crashed, rightly or not; it depends
 * on no clock. Messages are not forged (a message in another robot's name is dropped). Where
 * participants come and go it rests on the views of {@link
 * org.starl.primitives.membership.Membership}: equal numbers are equal lists, a list holds
 * everybody admitted before who has neither left nor been confined, nobody who is out is admitted
 * again, and nobody leaves who is not idle. Then of any two participants with open requests one
 * needs the other's consent ({@code Connected}), and consent is a promise to come later ({@code
 * Promise}).
 *
 * <p><b>Crash: confinement.</b> Whoever waits for f and hears nothing of it for Ts asks all for a
 * <em>fence</em>: the vow never to grant f anything again, and the part of f's newest request that
 * f may still hold by the fencer's consent. Only one has a say without whom f cannot enter: who is
 * listed wherever f is (as old as f or older), or was asked by f. What the fences have in common
 * bounds what f holds and ever will ({@code Kept}); a view confines f to that. Those who learn it
 * need f's answer no more; requests that meet the rest fail as {@code OCCUPIED}, soon, lest those
 * behind them wait as well; all others go on. Why it takes a view: two that suspect each other may
 * both vow, but views are in order, and f may do without its fencer only by a view that lists f and
 * not the fencer. A fence counts only while its fencer is listed. The ghost shrinks as fencers know
 * better, when f says itself that it is done, and by the own word of its robot's next start ({@code
 * standsIn}). Who was taken for crashed wrongly is told ({@code FENCED} or {@code REMOVED}), keeps
 * what it holds until it releases it, and registers anew.
 *
 * <p>After a crash, a request that waited for the dead one has access after Ts + 9 delta more, if a
 * majority of the registration's acceptors is in reach and no ghost is in its way.
 *
 * <p><b>Beside the theory.</b> {@code Noted}: who keeps an answer back says so to one who asks
 * again, which takes the place of the link's acknowledgement, and grants nothing. Who sees a ghost
 * smaller than the view has it vows and proposes at once, unasked. Who is a ghost in the latest
 * view is granted nothing, which is as if the grant were lost. An id that has retired keeps its
 * vows.
 *
 * <p><b>What it does not do.</b> Where all who had a say over a dead one have gone too (it was
 * alone, or the others left), nobody knows what it holds: requests that need it fail at their
 * deadline until its robot starts anew and says where it stands. A closed group gives nobody up,
 * for the same reason. Requesting in one instance while holding in another can deadlock, which the
 * deadline ends: make it one instance, or request in the same order everywhere. One mutex stands on
 * one registration.
 *
 * <p>May import: core, {@code org.starl.primitives}, its {@code membership} and {@code suspicion}.
 */
@NullMarked
package org.starl.primitives.mutex;

import org.jspecify.annotations.NullMarked;
