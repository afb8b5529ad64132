/**
 * The logic layer's motion and positioning (paper, sections 4.1 and 5.1): {@code plat.moat}, which
 * brings a robot to a target, and {@code gvh.gps}, which knows where it is.
 *
 * <p>Motion control: (a) safety: the body is always outside the region to avoid; (b) progress: {@code
 * motionflag} is DONE only within the goal radius of the target by the robot's own position, hence
 * within goal radius plus error bound in truth, and FAIL, wheels stopped, where it cannot get there:
 * a bump, no fix, no progress, the region in the way. Both rest on fixes whose error bounds are
 * true, and on a body that runs along the commanded arcs, no faster and at most {@code reactionMs}
 * late; it may be held up, and while a bump sensor is closed it may slide. Nobody pushes it.
 *
 * <p>All that decides is pure and knows no port: {@link org.starl.motion.MotionAutomaton} (two
 * styles), {@code MotionRun} (what doubts it), {@code AvoidGuard}, {@code ProgressWatch}, {@code
 * PositionFilter}. {@link org.starl.motion.MotionControl} and {@link org.starl.motion.Gps} join them
 * to the ports.
 *
 * <p>May import: {@code org.starl} (gvh and value types), {@code org.starl.geometry}, {@code
 * org.starl.platform}, {@code org.starl.random}.
 */
@NullMarked
package org.starl.motion;

import org.jspecify.annotations.NullMarked;
