"""Vicon DataStream (the CGStream protocol of Vicon Tracker): pure codec, both sides of the wire."""

from housefly.wires.vicon.frame import (
    ROOT,
    ApplicationInfo,
    Contents,
    FrameInfo,
    GlobalSegments,
    LatencyInfo,
    Segment,
    SegmentPose,
    StreamInfo,
    SubjectInfo,
)
from housefly.wires.vicon.handshake import Item, ObjectEnums, Ping, RequestFrame, RequestNextFrame
from housefly.wires.vicon.packet import (
    HEADER_SIZE,
    MAX_PACKET,
    decode_packet,
    encode_packet,
    packet_length,
)
from housefly.wires.vicon.rotation import matrix_from_quaternion, quaternion_from_matrix

TICKS_PER_SECOND = 135_000_000
"""Unit of ``StreamInfo.period_ticks``."""

__all__ = [
    "HEADER_SIZE",
    "MAX_PACKET",
    "ROOT",
    "TICKS_PER_SECOND",
    "ApplicationInfo",
    "Contents",
    "FrameInfo",
    "GlobalSegments",
    "Item",
    "LatencyInfo",
    "ObjectEnums",
    "Ping",
    "RequestFrame",
    "RequestNextFrame",
    "Segment",
    "SegmentPose",
    "StreamInfo",
    "SubjectInfo",
    "decode_packet",
    "encode_packet",
    "matrix_from_quaternion",
    "packet_length",
    "quaternion_from_matrix",
]
