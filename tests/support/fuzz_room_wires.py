"""Fuzz targets: tracking systems, scanners and small devices."""

from __future__ import annotations

import json
from collections.abc import Iterable

import numpy as np
from fuzz_target import DEEP, HUGE, FuzzTarget, pieces, split
from ros_scans import scan_cdr

from housefly.app.new_site.ros2_map import OCCUPANCY_GRID, occupancy_message
from housefly.bus.interfaces import type_store
from housefly.config.laser import LaserConfig
from housefly.errors import LinkError, RoomError, WireError
from housefly.messages import Pose, Sighting, TrackedFrame
from housefly.record import ros_messages
from housefly.record.ros_messages import about_z, header, pose_message
from housefly.room.occupancy_map import ros_map_of
from housefly.sensors.laser import scan_of
from housefly.sensors.ros2_scan import laser_scan_message
from housefly.tracking.bridge_lines import BridgeLines
from housefly.tracking.counts import FrameCounts
from housefly.tracking.natnet_frames import NatNetFrames
from housefly.tracking.ros2_lines import Ros2Lines
from housefly.tracking.tracking_messages import (
    TrackerStatus,
    TrackingMessageReader,
    encode_tracking_message,
)
from housefly.tracking.vicon_frames import ViconFrames
from housefly.tracking.vrpn_frames import VrpnFrames
from housefly.wires.devices import KINDS, Delivered, decode_reading, parse_topic
from housefly.wires.natnet import (
    CommandRequest,
    Connect,
    ModelDef,
    NatNetFrame,
    RigidBody,
    RigidBodyDescription,
    ServerInfo,
    decode_natnet,
    encode_natnet,
)
from housefly.wires.scip import (
    UST_10LX,
    MeasureRequest,
    PlainRequest,
    ScannerParameters,
    decode_measurement,
    decode_reply,
    decode_request,
    encode_reply,
    encode_request,
    measurement_reply,
)
from housefly.wires.scip.characters import checksum
from housefly.wires.vicon import (
    VICON_HEADER_SIZE,
    ApplicationInfo,
    FrameContents,
    FrameInfo,
    GlobalSegments,
    LatencyInfo,
    Segment,
    SegmentPose,
    StreamInfo,
    SubjectInfo,
    ViconPing,
    decode_packet,
    encode_packet,
    packet_length,
)
from housefly.wires.vrpn import (
    POSE_TYPE,
    SENDER_DESCRIPTION,
    TYPE_DESCRIPTION,
    TrackerPose,
    VrpnMessage,
    VrpnStream,
    decode_cookie,
    decode_lob,
    description_message,
    encode_cookie,
    encode_lob,
    encode_message,
    encode_pose,
)

_VERSIONS = ((2, 9), (3, 0), (3, 1), (4, 0), (4, 1), (4, 2))
_TURN = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
_STATES = ("state", "event", "availability")


def _natnet(data: bytes) -> None:
    """The first byte chooses the version; then a server's names and one of its frames."""
    version = _VERSIONS[data[0] % len(_VERSIONS)] if data else _VERSIONS[0]
    found = decode_natnet(data[1:], version)
    frames = NatNetFrames(1_000_000, 0.01, False, FrameCounts())
    if isinstance(found, ModelDef):
        frames.learn_names(found)
    if isinstance(found, NatNetFrame):
        frames.learn_names(
            ModelDef(tuple(RigidBodyDescription(b.identity, "a") for b in found.bodies))
        )
        for now in (10.0, 10.01):
            frames.read(found, now)


def _natnet_seeds() -> Iterable[bytes]:
    body = RigidBody(7, (1.0, 2.0, 3.0), (1.0, 0.0, 0.0, 0.0))
    for index, version in enumerate(_VERSIONS):
        for message in (
            NatNetFrame(1, (body, body), 5.0, 1000, 2000, 3000),
            ModelDef((RigidBodyDescription(7, "drone"), RigidBodyDescription(8, "chair"))),
        ):
            yield bytes([index]) + encode_natnet(message, version)
    info = ServerInfo("Motive", (3, 1, 0, 0), (4, 1, 0, 0), 10**7, 1511, True, "239.255.42.99")
    for message in (info, Connect((4, 1)), CommandRequest("Bitstream,4.1")):
        yield b"\x04" + encode_natnet(message, (4, 1))


def _vicon(data: bytes) -> None:
    packet_length(data[:VICON_HEADER_SIZE])
    frames = ViconFrames(0.01, FrameCounts())
    for now in (10.0, 10.01):
        frames.read(decode_packet(data[VICON_HEADER_SIZE:]), now)


def _vicon_seeds() -> Iterable[bytes]:
    contents = FrameContents(((1, 1), (5, 1)), frozenset({2}))
    static = (StreamInfo(1_350_000), ApplicationInfo(), SubjectInfo(1, "a", (Segment(3, "a"),)))
    segment = SegmentPose(3, (1000.0, 2000.0, 3000.0), _TURN)
    seen = (FrameInfo(7), LatencyInfo((("a", 0.01),)), GlobalSegments(1, (segment,)))
    for items in ((contents, *static), (contents, *static, *seen), seen, (ViconPing(5),)):
        yield encode_packet(items)


def _vrpn(data: bytes) -> None:
    """The first byte says how long the pieces are."""
    for read in (decode_cookie, decode_lob):
        try:
            read(data)
        except WireError:
            continue
    stream, frames = VrpnStream(), VrpnFrames(0.01, False, FrameCounts())
    for piece in pieces(data[1:], 1 + (data[0] if data else 0)):
        frames.read(stream.feed(piece), 10.0)


def _vrpn_seeds() -> Iterable[bytes]:
    pose = encode_pose(TrackerPose(0, (1.0, 2.0, 3.0), (1.0, 0.0, 0.0, 0.0)))
    told = (
        description_message(SENDER_DESCRIPTION, 0, "drone"),
        description_message(TYPE_DESCRIPTION, 1, POSE_TYPE),
        VrpnMessage(1, 0, 5_000_000, pose),
        VrpnMessage(1, 0, 5_010_000, pose),
    )
    yield b"\xff" + b"".join(map(encode_message, told))
    yield encode_cookie()
    yield encode_lob("127.0.0.1", 3883)


def _checked(data: bytes) -> bytes:
    """Return a reply in which all checksums are right: a mutator would not find them."""
    echo, *lines = data.decode("ascii", errors="replace").replace("\ufffd", "0").split("\n")
    return "\n".join([echo, *(x and x[:-1] + checksum(x[:-1]) for x in lines)]).encode("ascii")


def _scip(data: bytes) -> None:
    for block in (data, _checked(data)):
        try:
            reply = decode_reply(block)
            scan = decode_measurement(reply)
            if scan is not None:
                scan_of(scan.ranges, UST_10LX, LaserConfig(name="a"), 10.0, 10.0)
            _ = ScannerParameters.of(reply).first_angle
        except WireError:
            continue


def _scip_seeds() -> Iterable[bytes]:
    yield encode_reply(measurement_reply(MeasureRequest("MD", 10, 50, 1, 0, 3), 1234, (77,) * 41))
    yield encode_reply(measurement_reply(MeasureRequest("GD", 10, 20, 3), 4321, (9000,) * 4))
    yield encode_reply(UST_10LX.reply())


def _scip_request_seeds() -> Iterable[bytes]:
    for request in (PlainRequest("PP", "note"), MeasureRequest("MD", 0, 1080, 1, 2, 3, "a")):
        yield encode_request(request)[:-1]


def _device(data: bytes) -> None:
    """First the topic, then the payload."""
    topic, payload = split(data)
    address, channel = parse_topic(topic.decode("utf-8", errors="replace"))
    for retained in (False, True):
        decode_reading(Delivered(address, channel, payload, 1.7e9, retained))


def _device_seeds() -> Iterable[bytes]:
    items = [{"tag": "cup", "weight": 0.2, "x": 0.1, "y": 0.2}]
    persons = [{"id": "a", "x": 1.0, "y": 2.0}]
    values = {
        "time": 1.7e9, "battery": 0.5, "items": items, "load": 20.0, "open": True, "event": "put",
        "tag": "cup", "weight": 0.3, "persons": persons, "occupied": True, "motion": True,
    }  # fmt: skip
    for kind in KINDS:
        for channel in _STATES[:2]:
            yield f"housefly/bsen/{kind}/a-1/{channel}\n{json.dumps(values)}".encode()
    yield b"housefly/bsen/bed/a/availability\nonline"
    yield b'housefly/bsen/bed/a/state\n{"load":' + HUGE + b"}"
    yield b"housefly/bsen/bed/a/state\n" + DEEP


def _bridge(data: bytes) -> None:
    lines = BridgeLines(0.01, False, FrameCounts())
    for line in data.split(b"\n")[:8]:
        lines.read(line, 10.0)


def _bridge_seeds() -> Iterable[bytes]:
    yield b'{"bodies": {"a": [1, 2, 3, 1, 0, 0, 0]}}'
    yield b'{"problem": "gone"}'
    yield b'{"bodies": {"a": [' + HUGE + b", 2, 3, 1, 0, 0, 0]}}"
    yield b'{"bodies": ' + DEEP


def _ros2(data: bytes) -> None:
    lines = Ros2Lines(0.01, False, FrameCounts())
    for line in data.split(b"\n")[:8]:
        lines.read(line, 10.0)


def _ros2_seeds() -> Iterable[bytes]:
    yield b'{"body": "a", "stamp": 1, "pose": [1, 2, 3, 1, 0, 0, 0]}'
    yield b'{"topics": ["/a/pose"]}'
    yield b'{"problem": "gone"}'
    yield b'{"body": "a", "stamp": ' + HUGE + b', "pose": [1, 2, 3, 1, 0, 0, 0]}'
    yield b'{"topics": ' + DEEP


def _ros2_scan(data: bytes) -> None:
    scan = laser_scan_message(data)
    assert scan.step > 0.0 and len(scan.ranges) > 1 and not np.isnan(scan.ranges).any()


def _ros2_scan_seeds() -> Iterable[bytes]:
    yield scan_cdr()
    yield scan_cdr(ranges=(float("nan"), float("inf"), -float("inf"), 0.0, 2.0))
    yield scan_cdr(angle_min=0.5, angle_max=-0.5, angle_increment=-0.25)


def _ros2_map(data: bytes) -> None:
    ros_map_of(occupancy_message(data, "ros2:/map"), "ros2:/map")


def _ros2_map_seeds() -> Iterable[bytes]:
    stamp = ros_messages.message("builtin_interfaces/msg/Time", 1, 0)
    values = np.array([0, 100, -1, 50, 0, 0], np.int8)
    for yaw in (0.0, 1.0):
        place = pose_message((-1.0, 2.0, 0.0), about_z(yaw))
        info = ros_messages.message("nav_msgs/msg/MapMetaData", stamp, 0.05, 3, 2, place)
        told = ros_messages.message(OCCUPANCY_GRID, header(1.0, "map"), info, values)
        yield bytes(type_store().serialize_cdr(told, OCCUPANCY_GRID))


def _sightings(data: bytes) -> None:
    reader = TrackingMessageReader()
    for piece in pieces(data[1:], 1 + (data[0] if data else 0)):
        reader.feed(piece)


def _sighting_seeds() -> Iterable[bytes]:
    frame = TrackedFrame((Sighting("ardrone", Pose((1.0, 2.0, 3.0)), 4.0, 5.0),))
    for message in (frame, TrackedFrame(()), TrackerStatus(False, "silent")):
        yield b"\xff" + encode_tracking_message(message)


ROOM_WIRES: dict[str, FuzzTarget] = {
    "natnet": FuzzTarget(_natnet, _natnet_seeds, (WireError,)),
    "vicon": FuzzTarget(_vicon, _vicon_seeds, (WireError,)),
    "vrpn": FuzzTarget(_vrpn, _vrpn_seeds, (WireError,)),
    "mocap_bridge": FuzzTarget(
        _bridge,
        _bridge_seeds,
        (WireError, LinkError),
        2048,
        (b'"bodies"', b"1e309", b"NaN", b"-Infinity"),
    ),
    "ros2_line": FuzzTarget(
        _ros2,
        _ros2_seeds,
        (WireError, LinkError),
        2048,
        (b'"stamp"', b"1e309", b"NaN", b"-Infinity"),
    ),
    "ros2_scan": FuzzTarget(_ros2_scan, _ros2_scan_seeds, (WireError,), 1024),
    "ros2_map": FuzzTarget(_ros2_map, _ros2_map_seeds, (RoomError,), 1024),
    "sightings": FuzzTarget(_sightings, _sighting_seeds, (WireError,), words=(b"HFt1",)),
    "scip_reply": FuzzTarget(_scip, _scip_seeds),
    "scip_request": FuzzTarget(decode_request, _scip_request_seeds, (WireError,), 64),
    "mqtt": FuzzTarget(_device, _device_seeds, (WireError,), words=(b"housefly/", b"NaN", b"1e99")),
}
