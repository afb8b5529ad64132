/** Tests of robots on ROS 2 without ROS: bytes of real nodes, and nodes of this library. */
@NullMarked
package org.starl.ros2;

import org.jspecify.annotations.NullMarked;
