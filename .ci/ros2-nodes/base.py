"""A differential drive as a ROS 2 node that knows nothing of StarL: NAME/cmd_vel in; NAME/odom and NAME/pose (frame map) out, 20 times
a second. It stops 0.5 s after the last command.
   usage: base.py NAME X_M Y_M HEADING_RAD [FAULT]...
   silent: 6 s after the first command no more messages; stamps: then the poses' stamps are 10 s old for 1 s; odom-frame: poses are in
   the frame odom; scaled: after 100 mm of way the poses show half of what follows; best-effort: messages are offered best effort;
   killed: nothing, another process kills it."""
import math
import sys
import time
from contextlib import suppress

import rclpy
from geometry_msgs.msg import PoseStamped, Twist
from nav_msgs.msg import Odometry
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy

PERIOD_S = 0.05
ALONE_S = 0.5
FAULT_AFTER_S = 6


class Base(Node):
    def __init__(self, name, x, y, heading, faults):
        super().__init__(name + "_base")
        self.x, self.y, self.heading, self.faults = x, y, heading, faults
        self.v = self.w = 0.0
        self.first = self.commanded = self.origin = None
        self.start = x, y
        self.last = time.monotonic()
        qos = QoSProfile(depth=10)
        if "best-effort" in faults:
            qos.reliability = ReliabilityPolicy.BEST_EFFORT
        self.create_subscription(Twist, f"/{name}/cmd_vel", self.command, 10)
        self.odometry = self.create_publisher(Odometry, f"/{name}/odom", qos)
        self.pose = self.create_publisher(PoseStamped, f"/{name}/pose", qos)
        self.create_timer(PERIOD_S, self.tick)

    def command(self, twist):
        self.commanded = time.monotonic()
        if self.first is None:
            self.first = self.commanded
            print("fixes are taken: a command came", flush=True)
        self.v, self.w = twist.linear.x, twist.angular.z

    def tick(self):
        now = time.monotonic()
        if self.commanded is None or now - self.commanded > ALONE_S:
            self.v = self.w = 0.0
        dt, self.last = now - self.last, now
        self.x += self.v * math.cos(self.heading) * dt
        self.y += self.v * math.sin(self.heading) * dt
        self.heading += self.w * dt
        faulty = self.first is not None and now - self.first > FAULT_AFTER_S
        if "silent" in self.faults and faulty:
            return
        odometry, pose = Odometry(), PoseStamped()
        odometry.header.stamp = pose.header.stamp = self.get_clock().now().to_msg()
        odometry.header.frame_id = "odom"
        pose.header.frame_id = "odom" if "odom-frame" in self.faults else "map"
        if "stamps" in self.faults and faulty and now - self.first < FAULT_AFTER_S + 1:
            pose.header.stamp.sec -= 10
        odometry.twist.twist.linear.x, odometry.twist.twist.angular.z = self.v, self.w
        if self.origin is None and "scaled" in self.faults and math.dist(self.start, (self.x, self.y)) > 0.1:
            self.origin = self.x, self.y
        for place in (odometry.pose.pose, pose.pose):
            place.position.x, place.position.y = self.x, self.y
            if self.origin is not None and place is pose.pose:
                place.position.x, place.position.y = (self.x + self.origin[0]) / 2, (self.y + self.origin[1]) / 2
            place.orientation.z, place.orientation.w = math.sin(self.heading / 2), math.cos(self.heading / 2)
        self.odometry.publish(odometry)
        self.pose.publish(pose)


rclpy.init()
with suppress(ExternalShutdownException):  # the signal that ends it
    rclpy.spin(Base(sys.argv[1], *map(float, sys.argv[2:5]), sys.argv[5:]))
