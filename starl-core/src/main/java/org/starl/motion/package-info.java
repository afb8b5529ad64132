/**
 * Motion control and positioning of the logic layer (paper, sections 4.1 and 5.1): {@code
 * plat.moat} drives a robot to a target, {@code gvh.gps} estimates its location.
 *
 * <p>Motion control: (a) safety: the body is always outside the region to avoid; (b) progress:
 * {@code motionflag} becomes DONE only if the estimated position is within the goal radius of the
 * target, so the true one is within goal radius plus error bound; it becomes FAIL, with stopped
 * wheels, if the robot cannot reach the target: bump, no fix, fixes that contradict the commands, uncertain position, no progress, too
 * slow, or the region in the way. One of the two happens within {@link
 * org.starl.body.MotionParameters#longestMs}.
 *
 * <p>Assumptions: fixes with correct error bounds, at any time, and fixes so wrong that they
 * contradict the others, except the first fix and fixes that agree with each other for half a
 * minute; a body that executes between 0 and {@code 1 + speedError} times the command, at most
 * {@code reactionMs} late; while a bump sensor is closed it may slide. Nothing pushes it. A region
 * that appears nearer to a moving body than its stopping distance within {@code reactionMs} is not
 * covered.
 *
 * <p>All decisions are pure and use no port: {@link org.starl.motion.MotionAutomaton} (two styles),
 * {@code MotionRun} (its safety checks), {@code AvoidGuard}, {@code ProgressWatch}, {@code
 * PositionFilter}. {@link org.starl.motion.MotionController} and {@link org.starl.motion.Gps} connect
 * them to the ports.
 *
 * <p>May import: {@code org.starl} ids, {@code org.starl.body}, {@code org.starl.geometry}, {@code
 * org.starl.gvh}, {@code org.starl.platform}, {@code org.starl.random}, {@code org.starl.shape},
 * {@code org.starl.time}, {@code org.starl.trace}.
 */
@NullMarked
package org.starl.motion;

import org.jspecify.annotations.NullMarked;
