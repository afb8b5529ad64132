"""Prints what the natnet package makes of a server: version, descriptions, three frames.

Arguments: command port, data port, group ("-" for unicast).
"""
import sys
import time

from natnet import NatNetClient

command_port, data_port, group = int(sys.argv[1]), int(sys.argv[2]), sys.argv[3]
descriptions = []
frames = []

client = NatNetClient(
    server_ip_address="127.0.0.1",
    local_ip_address="127.0.0.1",
    multicast_address="239.255.42.99" if group == "-" else group,
    command_port=command_port,
    data_port=data_port,
    use_multicast=group != "-",
)
client.on_data_description_received_event.handlers.append(descriptions.append)
client.on_data_frame_received_event.handlers.append(frames.append)

with client:
    info = client.server_info
    print("server", info.application_name, info.nat_net_protocol_version.truncate(2))
    deadline = time.monotonic() + 20
    while (len(frames) < 3 or not descriptions) and time.monotonic() < deadline:
        if not descriptions:
            client.request_modeldef()
        client.update_sync()
        time.sleep(0.02)

assert descriptions and len(frames) >= 3, "descriptions %d, frames %d" % (len(descriptions), len(frames))
for marker_set in descriptions[0].marker_sets:
    print("marker set", marker_set.name, *marker_set.marker_names)
for body in descriptions[0].rigid_bodies:
    print("description", body.id_num, body.name, *[marker.name for marker in body.markers])
for frame in frames[:3]:
    for body in frame.rigid_bodies:
        numbers = ["%.3f" % each for each in body.pos + body.rot + (body.marker_error,)]
        print("body", body.id_num, *numbers, body.tracking_valid)
    markers = frame.labeled_markers
    print("markers", len(markers), sorted({marker.model_id for marker in markers}))
    suffix = frame.suffix
    assert suffix.stamp_camera_mid_exposure <= suffix.stamp_data_received <= suffix.stamp_transmit, suffix
    assert not suffix.is_recording, suffix
numbers = [frame.prefix.frame_number for frame in frames]
assert numbers == sorted(set(numbers)), numbers
