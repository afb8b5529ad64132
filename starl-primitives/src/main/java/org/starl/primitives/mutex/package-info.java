/**
 * Mutual exclusion on sets of sections (paper, section 4.5), by Ricart and Agrawala's algorithm among
 * participants that come and go. {@link org.starl.primitives.mutex.MutexPrim} is what an app uses,
 * {@link org.starl.primitives.mutex.M_Mutex} the algorithm on a robot, {@code MutexProtocol} the
 * algorithm by itself, {@link org.starl.primitives.mutex.MutexSpec} this contract as monitors over
 * the trace.
 *
 * <p><b>The contract.</b> Let delta be a time within which a message that is repeated until it is
 * answered arrives, N how many participants a process needs consent of, itself included.
 *
 * <ul>
 *   <li>(a) <b>Safety</b> ({@code Exclusive}; the paper's {@code Inv_mux_safety}): what two
 *       participants have access to is disjoint, always. All of a request is granted at the same
 *       time; sections are given back one by one or together.
 *   <li>(b) <b>Progress</b> ({@code Served}): if every holder releases within d1, a request has access
 *       within {@code d2 = (N - 1)(d1 + 2 delta) + 2 delta}, plus one turn for each newcomer that
 *       joined before it could hear of the request. Nobody starves: requests go first in the order
 *       of their logical times. Otherwise {@code failed} tells, at the latest at the deadline.
 *   <li>(c) <b>Non-interference</b> ({@code NonInterference}): while nobody holds, or waits with
 *       priority for, a section of a request, it has access within {@code d3 = 2 delta}. So requests
 *       with no section in common never wait for each other. That nobody <em>holds</em> a section, as
 *       the paper has it, is not enough: k holds A; j waits for {A, B}; i asks for B later than j,
 *       and waits for j, though nobody holds B.
 * </ul>
 *
 * <p>An uncontended request costs 2 (N - 1) messages and 2 delta; a release N - 1 messages. With no
 * loss delta is the longest delay; with loss, that and as many waits of {@link
 * org.starl.primitives.mutex.MutexTimes} as messages are lost in a row.
 *
 * <p><b>Envelope.</b> Safety holds under every loss, delay, duplication, reordering and partition,
 * and whenever robots crash and restart; it depends on no clock. Messages are not forged (a message
 * in another robot's name is dropped). Where participants come and go it rests on the views of {@link
 * org.starl.primitives.membership.Membership}: equal numbers are equal lists, a list holds everybody
 * admitted before who has not left, nobody who left is admitted again, and nobody leaves who is not
 * idle. Then of any two participants with open requests one needs the other's consent ({@code
 * Connected}), and consent is a promise to come later ({@code Promise}).
 *
 * <p><b>What it does not do.</b> A robot that crashes does not consent to anything, and keeps what it
 * held: requests that need its consent fail at their deadline until a view is without it, also those
 * with other sections. Requesting in one instance while holding in another can deadlock, which
 * the deadline ends: make it one instance, or request in the same order everywhere.
 *
 * <p>May import: core, {@code org.starl.primitives}, {@code org.starl.primitives.membership}.
 */
@NullMarked
package org.starl.primitives.mutex;

import org.jspecify.annotations.NullMarked;
