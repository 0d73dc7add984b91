"""Vicon DataStream (the CGStream protocol of Vicon Tracker): pure codec, both sides of the wire."""

from housefly.wires.vicon.frame import (
    ROOT_SEGMENT,
    ApplicationInfo,
    FrameContents,
    FrameInfo,
    GlobalSegments,
    LatencyInfo,
    Segment,
    SegmentPose,
    StreamInfo,
    SubjectInfo,
)
from housefly.wires.vicon.handshake import (
    ObjectEnums,
    RequestFrame,
    RequestNextFrame,
    ViconObject,
    ViconPing,
)
from housefly.wires.vicon.packet import (
    MAX_PACKET,
    VICON_HEADER_SIZE,
    decode_packet,
    encode_packet,
    packet_length,
)
from housefly.wires.vicon.rotation import matrix_from_quaternion, quaternion_from_matrix

TICKS_PER_SECOND = 135_000_000
"""Unit of ``StreamInfo.period_ticks``."""

__all__ = [
    "MAX_PACKET",
    "ROOT_SEGMENT",
    "TICKS_PER_SECOND",
    "VICON_HEADER_SIZE",
    "ApplicationInfo",
    "FrameContents",
    "FrameInfo",
    "GlobalSegments",
    "LatencyInfo",
    "ObjectEnums",
    "RequestFrame",
    "RequestNextFrame",
    "Segment",
    "SegmentPose",
    "StreamInfo",
    "SubjectInfo",
    "ViconObject",
    "ViconPing",
    "decode_packet",
    "encode_packet",
    "matrix_from_quaternion",
    "packet_length",
    "quaternion_from_matrix",
]
