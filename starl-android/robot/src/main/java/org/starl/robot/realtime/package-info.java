/**
 * A robot's strand, timers and clock in real time, for phones and any other JVM: one thread runs the
 * strand's pieces as they fall due, and the app has a second one that runs only while the first
 * waits for it. So at most one piece runs at a time, as in the simulator; the same contract tests
 * hold both to it.
 *
 * <p>Safety functions that must not wait for a strand (watchdog, bump stop) do not belong here.
 *
 * <p>May import: the JDK as far as Android API 26 has it, {@code org.starl.platform}.
 */
@NullMarked
package org.starl.robot.realtime;

import org.jspecify.annotations.NullMarked;
