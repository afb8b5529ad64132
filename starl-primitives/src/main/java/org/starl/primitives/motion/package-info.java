/**
 * Motion control (paper, sections 2, 4.1 and 5.1): {@code gotopoint(t, A)}, {@code do_move(t, A)},
 * {@code motionflag}. The motion automaton in {@code org.starl.motion} drives; {@code Detour} plans
 * its way around A and the known obstacles.
 *
 * <p>Safety, checked by {@link org.starl.primitives.motion.MotionSpec}:
 *
 * <ul>
 *   <li>{@code avoids}: from {@code do_move(t, A)} to the next command no part of the true body is
 *       in A, if none was in A at the call, or could enter A before the wheels react.
 *   <li>{@code told}: {@code motionflag} is DONE only if the true position is within goal radius
 *       plus error bound of t, and the estimated position is within that bound of the true one. It
 *       is DONE or FAIL at the latest {@code longestMs(distance)} after the call, or after a way of
 *       that length is planned (at most four times), even if wheels
 *       are stuck or slow, or positions are lost. After FAIL and {@code motion_stop} the body stands,
 *       from {@code reactionMs} on, until the next command.
 * </ul>
 *
 * <p>Progress: {@code arrives}: it is DONE, not FAIL, if the way is free: A is not near the
 * straight line to t, the body touches nothing, positions arrive, and no fault is active in the
 * run. If A or a known obstacle is in the way, a way around them is planned when the motion
 * begins, and anew where A still holds the body up, or it has left its way after a bump. It fails
 * with {@code NO_WAY} if there is none with room for the body, the error bound of its position and
 * a third of the goal radius on each side.
 *
 * <p>{@link org.starl.primitives.motion.MotionConformance} replays each run on the automaton whose
 * {@code avoids} and {@code told} are proved.
 *
 * <p>Envelope. The robot's {@link org.starl.body.MotionParameters} are true: the radius of its
 * body; {@code speedError}, the largest excess of its speed, including its clock's drift (it may be
 * slower, or stop, at any time); {@code reactionMs}, the time until a command has effect, including
 * late steps, the transfer to the wheels and braking. Fixes may be late or missing, and their
 * errors are at most as stated. A fix that contradicts all others may be wrong, except the first
 * after a start and fixes that confirm each other for half a minute. Anything may stop the body,
 * and it may slide along an object that closes a bump sensor. So the free space shrinks by the
 * radius, by the fix's error, by the distance driven since the fix, and by the distance that the
 * wheels may drive before the next command has effect.
 *
 * <p>Outside the envelope: a person pushes or carries the robot, or wheels turn without a command.
 *
 * <p>May import: core, {@code org.starl.primitives}.
 */
@NullMarked
package org.starl.primitives.motion;

import org.jspecify.annotations.NullMarked;
