"""Reads nav_msgs/Path messages from a rosbag2 folder with python3-rosbags and prints them as JSON."""
import json
import sys
from pathlib import Path

from rosbags.highlevel import AnyReader
from rosbags.typesys import Stores, get_typestore

messages = []
with AnyReader([Path(sys.argv[1])], default_typestore=get_typestore(Stores.ROS2_HUMBLE)) as bag:
    for connection, stamp, raw in bag.messages():
        message = bag.deserialize(raw, connection.msgtype)
        poses = [[p.pose.position.x, p.pose.position.y, p.pose.orientation.z, p.pose.orientation.w,
                  p.header.stamp.sec, p.header.stamp.nanosec] for p in message.poses]
        messages.append({'topic': connection.topic, 'stamp': stamp, 'frame': message.header.frame_id, 'poses': poses})
print(json.dumps(messages))
