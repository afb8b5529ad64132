/**
 * Registration (paper, section 4.3): who takes part, as numbered views that all agree on. {@link
 * org.starl.primitives.registration.Registration} is both the app's interface {@link
 * org.starl.primitives.registration.RegPrim} and the {@link
 * org.starl.primitives.membership.Membership} that Mutex reads.
 *
 * <p>View n + 1 is decided by one instance of the {@link org.starl.primitives.agreement.Synod} among
 * fixed acceptors, from a proposal that is always derived from the decided view n. Who wants a
 * change, the joiner or the leaver itself, proposes it. View 0 is empty, unless the deployment gives
 * a first view.
 *
 * <p>(a) <b>Safety</b>, under any loss, delay, duplication, reordering, partition, crash and restart:
 *
 * <ul>
 *   <li>{@code Agreement}: equal view numbers of one instance mean equal lists, always. The paper's
 *       "time stamps within d of each other" does not carry the intersection, since a newcomer might
 *       then never ask a car that is still crossing; {@code ts} is therefore the view number.
 *   <li>{@code Keeps} (inclusion): a list holds every id of the lists before it that has neither asked
 *       to leave nor been confined, by the word of somebody who is free in the list before and in this
 *       one. Who is confined to sections stays in the list as a ghost of these, which only shrinks.
 *   <li>{@code Fresh}: an id enters at most once; having left, it never comes back.
 *   <li>{@code Soundness}: an id stands in a list only if its robot invoked {@code do_register} under
 *       it.
 * </ul>
 *
 * <p>{@link org.starl.primitives.registration.RegistrationConformance} takes each run through the
 * automaton of the theory {@code Registration_decls}, of which this is proved.
 *
 * <p>Every attempt has an id of its own, which no other attempt ever uses. An attempt that is given
 * up may still be completed by others: its id then stands in a list, requests nothing, and is taken
 * out again by its own robot.
 *
 * <p>(b) <b>Progress.</b> With message delay δ and a majority of acceptors in reach, a join alone takes
 * 6δ (learn the latest number 2, prepare 2, accept 2; 4δ where the number is known), and others hear
 * of it δ later; it costs 6A + |view| messages for A acceptors. k changes at once take about (4k +
 * 2)δ at worst; wishes ride on prepare messages, so that one view usually serves several. A call that
 * meets its deadline is told {@code failed}. A view is spread by reliable messages; who misses it all
 * the same asks the acceptors: registered robots one of them every few seconds, and all of them when
 * a rumour of a newer view is not followed by the view. If that is in vain as well, its proposer may
 * have gone after the decision: then registered robots complete that view themselves. So who leaves
 * and is gone before anybody knows is forgotten within seconds, as long as a majority of acceptors is
 * in reach.
 *
 * <p><b>Crash, restart, wrong suspicion.</b> A registration by itself suspects nobody: a crashed id
 * stays in the lists until the {@link org.starl.primitives.mutex} over it, which waits for that id,
 * proposes its confinement, or its own robot's next start says where its body is ({@link
 * org.starl.primitives.membership.Membership#standsIn}). A robot that was confined while it lived sees
 * {@code rList} null, and may call {@code do_register} at once; {@code unregister} is then right too,
 * and ends once no list mentions it. A restarted robot is another id, and registers anew.
 *
 * <p><b>Beside the theory.</b> One view may serve several changes: those of its proposer, and wishes
 * that others sent along. It is as if they were made one view each, of which nobody ever learned the
 * ones between; only that who vouches in one of them may not leave or be confined by another, so that
 * it is free before and after. What does not fit is left to the next view. A ghost keeps the number of
 * the view that admitted it, for those who may vouch for less of it later.
 *
 * <p>(c) <b>Assumptions.</b> Those of {@link org.starl.primitives.agreement}. Acceptors are by default
 * all robots of the deployment, on open roads a few fixed roadside units; each must construct the
 * registration to serve, whether it takes part or not. One mutex stands on a registration, and is
 * asked before a robot unregisters. A list has room for about 40 ids; beyond that, {@code do_register}
 * fails.
 *
 * <p>May import: core, {@code org.starl.primitives}, its {@code agreement} and {@code membership}.
 */
@NullMarked
package org.starl.primitives.registration;

import org.jspecify.annotations.NullMarked;
