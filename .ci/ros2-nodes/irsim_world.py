"""The simulator ir-sim with a differential drive for each robot, each behind topics of its own: NAME/cmd_vel (TwistStamped) in;
NAME/odom, NAME/amcl_pose (frame map, with a covariance) and NAME/contact (Bool) out, 20 times a second; a late turn of the
machine is made up for, so that the world's time is the clock's. A robot that stands at the end of its way is taken off the
road: another one may come to the same place.
   usage: irsim_world.py [NAME X_M Y_M HEADING_RAD]..."""
import math
import sys
import tempfile
import time
from contextlib import suppress

import irsim
import numpy
import rclpy
from geometry_msgs.msg import PoseWithCovarianceStamped, TwistStamped
from nav_msgs.msg import Odometry
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import Bool

PERIOD_S = 0.05
ALONE_S = 0.5
SIGMA_M, SIGMA_RAD = 0.003, 0.005
# The end of a way is so far from the middle of the crossing; starts are nearer, and no robot waits so far out.
MIDDLE_M, END_M, STANDS_S = 2.5, 1.7, 2

names = sys.argv[1::4]
states = [[float(number) for number in sys.argv[i:i + 3]] for i in range(2, len(sys.argv), 4)]
with tempfile.NamedTemporaryFile("w", suffix=".yaml", delete=False) as file:
    file.write(f"""world: {{height: 6, width: 6, step_time: {PERIOD_S}, collision_mode: 'stop'}}
robot:
  - number: {len(names)}
    distribution: {{name: 'manual'}}
    kinematics: {{name: 'diff'}}
    shape: {{name: 'circle', radius: 0.165}}
    state: {states}
    goal: {[[9, 9, 0]] * len(names)}
    vel_min: [-0.5, -4]
    vel_max: [0.5, 4]
    acce: [10, 100]
""")
world = irsim.make(file.name, display=False)
rclpy.init()
node = rclpy.create_node("irsim")
speeds = [numpy.zeros((2, 1)) for _ in names]
commanded = [0.0] * len(names)
hit = [False] * len(names)
gone = [False] * len(names)
stepped = time.monotonic()
moved = [stepped] * len(names)


def commands(i):
    def take(message):
        speeds[i] = numpy.array([[message.twist.linear.x], [message.twist.angular.z]])
        commanded[i] = time.monotonic()
    return take


ends = []
for i, name in enumerate(names):
    node.create_subscription(TwistStamped, f"/{name}/cmd_vel", commands(i), 10)
    ends.append((node.create_publisher(Odometry, f"/{name}/odom", 10),
                 node.create_publisher(PoseWithCovarianceStamped, f"/{name}/amcl_pose", 10),
                 node.create_publisher(Bool, f"/{name}/contact", 10)))


def tick():
    global stepped
    now = time.monotonic()
    if now - stepped < PERIOD_S:
        return
    while now - stepped >= PERIOD_S:
        world.step([speed if stepped - at < ALONE_S else numpy.zeros((2, 1)) for speed, at in zip(speeds, commanded)])
        stepped += PERIOD_S
    stamp = (node.get_clock().now() - Duration(seconds=now - stepped)).to_msg()
    for i, (robot, (odometry_out, pose_out, contact_out)) in enumerate(zip(world.robot_list, ends)):
        x, y, heading = (float(value) for value in robot.state[:3, 0])
        odometry, pose = Odometry(), PoseWithCovarianceStamped()
        odometry.header.stamp = pose.header.stamp = stamp
        odometry.header.frame_id, pose.header.frame_id = "odom", "map"
        odometry.twist.twist.linear.x, odometry.twist.twist.angular.z = (float(value) for value in robot.velocity[:2, 0])
        pose.pose.pose.position.x, pose.pose.pose.position.y = x, y
        pose.pose.pose.orientation.z, pose.pose.pose.orientation.w = math.sin(heading / 2), math.cos(heading / 2)
        pose.pose.covariance[0] = pose.pose.covariance[7] = SIGMA_M ** 2
        pose.pose.covariance[35] = SIGMA_RAD ** 2
        odometry.pose.pose = pose.pose.pose
        odometry_out.publish(odometry)
        pose_out.publish(pose)
        contact_out.publish(Bool(data=bool(robot.collision)))
        moved[i] = stepped if abs(robot.velocity[0, 0]) >= 0.001 else moved[i]
        if stepped - moved[i] > STANDS_S and math.hypot(x - MIDDLE_M, y - MIDDLE_M) > END_M and not gone[i]:
            gone[i] = True
            robot.set_state([5.7, 0.5 + i, 0])
        if robot.collision and not hit[i]:
            hit[i] = True
            print("collision of", names[i], "at", x, y, flush=True)


node.create_timer(PERIOD_S / 5, tick)
print("ready", flush=True)
with suppress(ExternalShutdownException):  # the signal that ends it
    rclpy.spin(node)
