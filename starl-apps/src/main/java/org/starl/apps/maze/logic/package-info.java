/**
 * The program of the robots in a maze. A robot drives to goals among obstacles of which some are
 * hidden, learns from bumps, plans again, and answers for each goal that it has reached it or that
 * there is no way.
 *
 * <p><b>The contract.</b> R is the body's radius, m the margin ({@link
 * org.starl.apps.maze.logic.MazeTask#MARGIN_MM}).
 *
 * <ul>
 *   <li><b>Marks are sound.</b> A {@link org.starl.apps.maze.logic.Mark} is what a contact proves:
 *       no body of radius R + m fits with its centre in the mark. So no way of such a body crosses
 *       a mark, and no mark is ever removed.
 *   <li><b>No way</b> is answered only if the planner proves that map and marks leave no way from
 *       the robot's start for a body of radius R + m. As both are sound, there is none in the real
 *       world.
 *   <li><b>A way is found</b> if there is one for a body of radius R + m. Until then each drive
 *       ends with a contact. Its mark contains a disc around the position of the centre at the
 *       contact, of radius m': the margin less the position's error and the width of a contact.
 *       Later ways stay outside of it, and the robot strays less than m' from its way. So any two
 *       contacts are at least the difference apart, and only finitely many fit on a floor.
 *   <li><b>No robot blocks another for ever.</b> Robots stand at starts and goals only, unless they
 *       hold the blocks of the floor that they are in. The mutex grants all blocks of a request at
 *       once. A robot that needs more goes back to its resting place, releases all, and requests
 *       these and what it held: each time more, up to the whole floor. If each goal can be reached
 *       past the starts and goals of the others, no two robots ever wait for each other.
 *   <li><b>Robots share marks.</b> A mark is true for every robot with an equal body. A lost one
 *       costs another contact.
 * </ul>
 *
 * <p><b>Assumptions.</b> Obstacles do not move; all moving bodies on the floor belong to the group;
 * a fix's error bound is true; a closed bump sensor touches something. For a gap of 2 R to 2 (R +
 * m) either answer is right. A robot may get through such a gap and not back; then it answers that
 * it gave up, never that there is no way.
 *
 * <p>May import: core and primitives only.
 */
@NullMarked
package org.starl.apps.maze.logic;

import org.jspecify.annotations.NullMarked;
