/**
 * The trace of a robot that runs in real time, in its own process or on its own machine: the format of
 * {@code org.starl.trace}, each event flushed at once, with events of the process itself ({@link
 * org.starl.robot.trace.ProcessFact}): the clock of its times, and that it is alive.
 *
 * <p>Contract: a recorded event is flushed before it can have an effect on others, whenever the process
 * is killed. Events of the process itself are left out of merged traces.
 *
 * <p>May import: the JDK as far as Android API 26 has it, core, {@code org.starl.robot}.
 */
@NullMarked
package org.starl.robot.trace;

import org.jspecify.annotations.NullMarked;
