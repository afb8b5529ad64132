"""Receives what StarL shows of a robot, with the types of RViz.   usage: display.py NAME"""
import json
import sys
from contextlib import suppress

import rclpy
from nav_msgs.msg import Path
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import String
from visualization_msgs.msg import MarkerArray

seen = {}


def take(kind):
    def took(message):
        if kind == "events":
            assert json.loads(message.data)["robot"] == sys.argv[1]
        elif kind == "path":
            assert message.header.frame_id == "map" and message.poses
        else:
            body, text = message.markers
            assert abs(body.scale.x - 0.33) < 1e-9 and text.text.startswith(sys.argv[1]), message
        if kind not in seen:
            seen[kind] = message
            if len(seen) == 3:
                print("seen:", *sorted(seen), flush=True)
                print(seen["markers"].markers[1].text.replace("\n", "; ")[:150], flush=True)
    return took


rclpy.init()
node = rclpy.create_node("display")
for kind, type_ in (("events", String), ("path", Path), ("markers", MarkerArray)):
    node.create_subscription(type_, f"/{sys.argv[1]}/starl/{kind}", take(kind), 10)
print("subscribed", flush=True)
with suppress(ExternalShutdownException):  # the signal that ends it
    rclpy.spin(node)
