/**
 * StarL on a phone that rides on a robot (paper, section 5.1): {@link
 * org.starl.android.app.MainActivity} shows the robot and takes the user's orders, {@link
 * org.starl.android.app.RobotService} runs it in the foreground, screen on or off, and {@link
 * org.starl.android.app.Robot}, which does not depend on Android, is the robot: an app's logic over
 * strand, radio, storage, positioning and chassis of the real platform. {@link
 * org.starl.android.app.WheelsService} guards its wheels in a process of its own, which has the link to
 * them.
 *
 * <p>Contract: the chassis driver, below all of this, stops the wheels; an emergency stop goes straight
 * to it, from any thread, and holds until the user releases it. A lost link, network or permission is
 * shown, and used again when it is back. Whatever ends the robot (stop, a bug, a violation of one of
 * its own lemmas, the service's end)
 * stops the wheels first and releases every lock.
 *
 * <p>Threads: the service and the activity run on Android's main thread, which never waits for the
 * robot; robots are opened and closed on another thread.
 *
 * <p>May import: {@code android}, core, primitives, {@code org.starl.robot}, {@code
 * org.starl.apps.AppFactory} and its parts. The only package that imports {@code android}.
 */
@NullMarked
package org.starl.android.app;

import org.jspecify.annotations.NullMarked;
