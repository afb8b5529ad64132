/**
 * Motion control (paper, sections 4.1 and 5.1): {@code gotopoint}, {@code do_move(t, A)}, {@code
 * motionflag}. How it is done is the motion automaton's, {@code org.starl.motion}.
 *
 * <p>Safety, checked by {@link org.starl.primitives.motion.MotionSpec}:
 *
 * <ul>
 *   <li>{@code avoids}: from {@code do_move(t, A)} to the next command no part of the true body is
 *       in A, if none was at the call nor could have got there before the wheels took notice.
 *   <li>{@code told}: {@code motionflag} is DONE only if the true position is within goal radius
 *       plus error bound of t, and the position that it rests on within that bound of the true one.
 *       It is DONE or FAIL {@code longestMs(distance)} after the call at the latest, wheels stuck
 *       or slow, positions lost, or whatever.
 * </ul>
 *
 * <p>Progress: {@code arrives}: it is DONE, not FAIL, if nothing is in the way: A is not near the
 * straight line to t, nothing is bumped into, positions come, and no fault is at work on the run.
 *
 * <p>{@link org.starl.primitives.motion.MotionConformance} takes each run through the automaton of
 * which {@code avoids} and {@code told} are proved.
 *
 * <p>Envelope. The robot is told the truth of itself by its {@link
 * org.starl.body.MotionParameters}: the radius of its body; {@code speedError}, by which it drives
 * or turns too fast (too slowly, or not at all, it may whenever it likes), its clock's drift
 * included; {@code reactionMs}, within which a command is in effect: late steps, the way to the
 * wheels and braking included. Fixes come or do not, late or in time, off by no more than they say;
 * those that contradict all others may lie, except the first after a start and those that confirm
 * each other for half a minute. The body may be held up by anything, and slide along what closes a
 * bump sensor. What shrinks the room is thus the radius, the fix's error and the way driven since
 * it was measured, and what the wheels may do before the next command is in effect.
 *
 * <p>Beyond the envelope: somebody who pushes or carries the robot, wheels that turn untold.
 *
 * <p>May import: core, {@code org.starl.primitives}.
 */
@NullMarked
package org.starl.primitives.motion;

import org.jspecify.annotations.NullMarked;
