/**
 * Robots whose base is a ROS 2 node: speeds out, odometry, contacts and poses in, over DDS.
 *
 * <p>Contract: lengths in messages are metres, here mm; angles are radians, counter-clockwise (REP 103). A
 * position is a pose in a frame that does not drift (REP 105), with its covariance as error bound. The
 * wheels turn only while a node receives the speeds, odometry comes, the program repeats its commands, and
 * fixes arrive. The speeds are sent by a guard, a process of its own, which stops the wheels when the
 * program has ended or is frozen. No bytes from the network make a reader fail or allocate more than a
 * multiple of their length.
 *
 * <p>Not promised: a base that receives nothing any more must stop by itself.
 *
 * <p>May import: the JDK, core, {@code org.starl.robot}, and as the only package the DDS library.
 */
@NullMarked
package org.starl.ros2;

import org.jspecify.annotations.NullMarked;
