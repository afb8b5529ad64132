/**
 * What a search owes, as monitors over the trace.
 *
 * <ul>
 *   <li>{@code found}: who says that it has found a thing has it in range and sight of its true body,
 *       and the thing is where it says.
 *   <li>{@code nothing}: "nothing there" is said only when every cell of every room, as far as a robot
 *       can see it from anywhere, was in range and sight of a true body whose program ran.
 *   <li>{@code gave_up}: a room is given up only if robots that are down bar some of it from all that
 *       are up, by the tubes that they hold, or no robot can get in.
 *   <li>{@code agreed}: all robots that end have one answer.
 *   <li>{@code assigned}: no room stays with a robot that is down, within a bound.
 *   <li>{@code ended}: every robot that is up ends with an answer, within a bound.
 * </ul>
 *
 * <p>The first four are safety, whatever the world does. The bounds are owed while no fault but crashes
 * is under way and a majority of the robots is up.
 *
 * <p>May import: core, the primitive {@code paths}, {@code logic} beside it.
 */
@NullMarked
package org.starl.apps.search.spec;

import org.jspecify.annotations.NullMarked;
