/**
 * StarL on a phone that rides on a robot (paper, section 5.1): {@link
 * org.starl.android.app.MainActivity} shows the robot and takes a person's orders, {@link
 * org.starl.android.app.RobotService} holds it in the foreground, screen on or off, and {@link
 * org.starl.android.app.Robot}, which knows nothing of Android, is the robot: an app's logic over
 * strand, radio, storage, positioning and chassis of the real platform.
 *
 * <p>Contract: the wheels are the chassis driver's to stop, below all of this; an emergency stop goes
 * straight to it, from any thread, and holds until a person takes it back. A link, a network or a
 * permission that is lost is shown, and taken up again when it is back. Whatever ends the robot
 * (stop, a bug, the service's end) stops the wheels first and gives every lock back.
 *
 * <p>What runs where: the service and the activity on Android's main thread, which never waits for
 * the robot; a robot is opened and closed on a thread of its own.
 *
 * <p>May import: {@code android}, core, primitives, {@code org.starl.robot}, apps' {@code logic}
 * packages. The only package that imports {@code android}.
 */
@NullMarked
package org.starl.android.app;

import org.jspecify.annotations.NullMarked;
