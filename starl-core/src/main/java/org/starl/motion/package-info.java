/**
 * The logic layer's motion and positioning (paper, sections 4.1 and 5.1): {@code plat.moat}, which
 * brings a robot to a target, and {@code gvh.gps}, which knows where it is.
 *
 * <p>Motion control: (a) safety: the body is always outside the region to avoid; (b) progress: {@code
 * motionflag} is DONE only within the goal radius of the target by the robot's own position, hence
 * within goal radius plus error bound in truth, and FAIL, wheels stopped, where it cannot get there:
 * a bump, no fix, no certain position, no progress, too slow, the region in the way. It is one of the
 * two within {@link org.starl.body.MotionParameters#longestMs}.
 *
 * <p>Envelope: fixes whose error bounds are true, whenever they come, and any that are so far off
 * that they contradict the others, except the first and those that confirm each other for half a
 * minute; a body that does from none to {@code 1 + speedError} times of what is commanded, at most
 * {@code reactionMs} late; while a bump sensor is closed it may slide. Nobody pushes it. A region
 * that begins nearer to a body in motion than that stops within {@code reactionMs} is beyond it.
 *
 * <p>All that decides is pure and knows no port: {@link org.starl.motion.MotionAutomaton} (two
 * styles), {@code MotionRun} (what doubts it), {@code AvoidGuard}, {@code ProgressWatch}, {@code
 * PositionFilter}. {@link org.starl.motion.MotionControl} and {@link org.starl.motion.Gps} join them
 * to the ports.
 *
 * <p>May import: {@code org.starl.body}, {@code org.starl.geometry}, {@code org.starl.gvh}, {@code
 * org.starl.platform}, {@code org.starl.random}.
 */
@NullMarked
package org.starl.motion;

import org.jspecify.annotations.NullMarked;
