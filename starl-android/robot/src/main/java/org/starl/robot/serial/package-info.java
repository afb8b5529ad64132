/**
 * Serial lines as {@link org.starl.robot.create.ByteLink}s: real ports, and Linux pseudo terminals
 * at whose other end programs find a serial port where there is none.
 *
 * <p>Contract: what a port does wrong is an {@link java.io.IOException} of the call that notices it;
 * closing ends reads and writes that wait.
 *
 * <p>May import: the JDK as far as Android API 26 has it, jSerialComm, {@code
 * org.starl.robot.create}.
 */
@NullMarked
package org.starl.robot.serial;

import org.jspecify.annotations.NullMarked;
