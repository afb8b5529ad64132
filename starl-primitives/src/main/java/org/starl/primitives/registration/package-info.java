/**
 * Registration (paper, section 4.3): the participants, as numbered views that all robots agree on.
 * {@link org.starl.primitives.registration.Registration} is both the app's interface {@link
 * org.starl.primitives.registration.RegPrim} and the {@link
 * org.starl.primitives.membership.Membership} that Mutex reads.
 *
 * <p>View n + 1 is decided by one instance of the {@link org.starl.primitives.agreement.Synod} among
 * fixed acceptors, from a proposal that is always derived from the decided view n. A robot that wants to
 * join, leave or confine proposes the change itself. View 0 is empty, unless the deployment gives a first
 * view.
 *
 * <p>(a) <b>Safety</b>, under any loss, delay, duplication, reordering, partition, crash and restart:
 *
 * <ul>
 *   <li>{@code Agreement}: equal view numbers of one instance mean equal lists, always. The paper's
 *       "time stamps within d of each other" is not enough for the intersection: a newcomer might never
 *       ask a car that is still crossing. So {@code ts} is the view number.
 *   <li>{@code Keeps} (inclusion): a list contains every id of the lists before it that has neither asked
 *       to leave nor been confined. A confinement needs a fencer that is free in the list before and in
 *       this one. A confined id stays in the list as a ghost of its sections, which can only shrink.
 *   <li>{@code Fresh}: an id enters at most once; after it has left, it never comes back.
 *   <li>{@code Soundness}: an id is in a list only if its robot called {@code do_register} under it.
 * </ul>
 *
 * <p>{@link org.starl.primitives.registration.RegistrationConformance} replays each run on the automaton
 * of the theory {@code Registration_decls}, of which this is proved.
 *
 * <p>Every attempt to register has its own id, which no other attempt ever uses. Other robots may still
 * complete an attempt that was given up: its id is then in a list, requests nothing, and its own robot
 * removes it again.
 *
 * <p>(b) <b>Progress.</b> With message delay δ and a majority of acceptors in reach, a single join takes
 * 6δ (learn the latest number 2, prepare 2, accept 2; 4δ where the number is known), and others hear of it
 * δ later; it costs 6A + |view| messages for A acceptors. k simultaneous changes take about (4k + 2)δ at
 * worst; wishes in prepare messages let one view usually serve several. A robot that is no acceptor
 * and not listed hears of views only as answers: each view that is decided while it pauses costs it
 * another pause. A call that meets its deadline reports {@code failed}, and none does so sooner.
 * A view is spread by reliable messages ({@code Informed}): who decides
 * it sends it in the same step to all acceptors, and to all robots that it or the view before lists; a
 * robot that leaves stays until all of these have the latest view that it has decided, or for 5 s ({@code
 * Stays}). A robot that misses a view asks the acceptors: registered robots ask one of them every few seconds, and
 * all of them when a rumour of a newer view is not followed by that view. If that does not help, its
 * proposer may have gone after the decision: then registered robots complete the view themselves. So a
 * robot that leaves, and is gone before any other robot knows, is forgotten within seconds, while a
 * majority of acceptors is in reach.
 *
 * <p><b>Crash, restart, wrong suspicion.</b> Registration itself suspects no robot. A crashed id stays in
 * the lists until the {@link org.starl.primitives.mutex} over it, which waits for that id, proposes its
 * confinement, or until the robot's next start declares where its body is ({@link
 * org.starl.primitives.membership.Membership#standsIn}). A robot that was confined while it lived sees
 * {@code rList} null, and may call {@code do_register} at once. It may also call {@code unregister}, which
 * ends once no list mentions it. A restarted robot has another id, and registers again.
 *
 * <p><b>Beside the theory.</b> One view may serve several changes: its proposer's, and wishes of others.
 * This equals a series of views with one change each, where no robot learns those between; but a fencer of
 * one change may not leave or be confined by another, so that it is free before and after. A change that
 * does not fit is left to the next view. A ghost keeps the number of the view that admitted it, for
 * fencers that may later bound it more tightly.
 *
 * <p>(c) <b>Assumptions.</b> Those of {@link org.starl.primitives.agreement}. Acceptors are by default
 * all robots of the deployment, on open roads a few fixed roadside units; each must construct the
 * registration to serve, whether it registers or not. One mutex uses a registration, and is asked before a
 * robot unregisters. A list has room for about 40 ids; beyond that, {@code do_register} waits until one
 * leaves, and asks the acceptors for newer views meanwhile.
 *
 * <p>May import: core, {@code org.starl.primitives}, its {@code agreement} and {@code membership}.
 */
@NullMarked
package org.starl.primitives.registration;

import org.jspecify.annotations.NullMarked;
