/**
 * The specification of a search, as monitors over the trace.
 *
 * <ul>
 *   <li>{@code found}: a robot that announces a thing has it in range and sight of its true body,
 *       and the thing is where the robot says.
 *   <li>{@code nothing}: "nothing there" is announced only when every cell of every room that a
 *       robot can see from anywhere was in range and sight of a true body whose program ran.
 *   <li>{@code gave_up}: a room is given up only if the tubes of robots that are down bar some of
 *       it from all robots that are up, or no robot can enter.
 *   <li>{@code agreed}: all robots that end have one answer.
 *   <li>{@code assigned}: no room stays with a robot that is down, within a bound.
 *   <li>{@code ended}: every robot that is up ends with an answer, within a bound.
 * </ul>
 *
 * <p>The first four are safety and hold under all faults. The bounds are owed while no fault but
 * crashes is active and a majority of the robots is up.
 *
 * <p>May import: core, the primitive {@code paths}, {@code logic} beside it.
 */
@NullMarked
package org.starl.apps.search.spec;

import org.jspecify.annotations.NullMarked;
