/**
 * Serial lines as {@link org.starl.robot.create.ByteLink}s: real ports, and pseudo terminals, which
 * other programs open as virtual serial ports.
 *
 * <p>Contract: an error of a port is an {@link java.io.IOException} of the call that notices it;
 * closing ends waiting reads and writes.
 *
 * <p>May import: the JDK as far as Android API 26 has it, jSerialComm, {@code
 * org.starl.robot.create}.
 */
@NullMarked
package org.starl.robot.serial;

import org.jspecify.annotations.NullMarked;
