/**
 * The trace that a robot leaves which runs in real time, in a process or on a machine of its own: as
 * {@code org.starl.trace} writes it, each event out as it happens, and with it what the process says of
 * itself ({@link org.starl.robot.trace.Word}): which clock its times are on, and whether it lives.
 *
 * <p>Contract: an event that was recorded is out before anybody can know of it, whenever the process is
 * killed. What a process says of itself stays out of merged traces.
 *
 * <p>May import: the JDK as far as Android API 26 has it, core, {@code org.starl.robot}.
 */
@NullMarked
package org.starl.robot.trace;

import org.jspecify.annotations.NullMarked;
