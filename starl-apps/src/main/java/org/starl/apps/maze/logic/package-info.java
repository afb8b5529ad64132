/**
 * What runs on the robots of a maze: drive to goals among obstacles of which some are hidden, learn
 * from bumps, plan again, and say of each goal that it was reached or that there is no way.
 *
 * <p><b>The contract.</b> R is the body's radius, m the margin ({@link
 * org.starl.apps.maze.logic.Errand#MARGIN_MM}).
 *
 * <ul>
 *   <li><b>Sound.</b> A {@link org.starl.apps.maze.logic.Mark} is what a contact proves: no body of
 *       radius R + m fits where the mark keeps the centre out. So a way for such a body crosses no
 *       mark, and no mark ever has to be taken back.
 *   <li><b>No way</b> is said only if the planner proves, from the robot's start, that map and marks
 *       leave no way for a body of radius R + m. As both are sound, there is none in the real world.
 *   <li><b>A way is found</b> whenever there is one for a body of radius R + m. Until it is found
 *       each drive ends in a contact, whose mark has a disc of radius m', the margin without the
 *       position's error and the width of a contact, around where the centre stood. The next way
 *       stays out of that, and the robot strays from its way by less than m'. So all contacts are
 *       apart by at least the difference, and a floor has room for so many only.
 *   <li><b>Nobody is in the way for ever.</b> Robots stand at starts and goals only, unless they hold
 *       the blocks of the floor that they are in (the mutex grants all of them at once). Who needs
 *       more goes back to where it last stood, gives all back, and asks for the whole floor. Where
 *       each goal can be reached past the starts and goals of the others, no two ever wait for each
 *       other.
 * </ul>
 *
 * <p><b>What it assumes.</b> Obstacles stand still; whoever moves on the floor is one of the group; a
 * fix's error bound is true; a closed bump sensor has something before it. Between R and R + m it may
 * be either answer. Where a gap is so narrow, a robot may squeeze through it and not get back: then it
 * says that it gave up, never that there is no way.
 *
 * <p>May import: core and primitives only.
 */
@NullMarked
package org.starl.apps.maze.logic;

import org.jspecify.annotations.NullMarked;
