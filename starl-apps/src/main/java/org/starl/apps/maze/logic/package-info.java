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
 *   <li><b>Robots share the floor by tubes</b> ({@code org.starl.primitives.paths}). A robot drives
 *       each piece of its way in a reach tube and gives the tube back part by part, each when its
 *       whole body is certainly in the next one. Ways keep clear of the starts and goals of all
 *       other robots, so a robot at rest blocks no other. A robot that is held up elsewhere gives
 *       back its tube but for the disc that it stands in, and after a while drives to a random
 *       place on its trail. So two robots that wait for each other part in the end, with
 *       probability one; no bound is proven.
 *   <li><b>Robots share marks.</b> A mark is true for every robot with an equal body.
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
