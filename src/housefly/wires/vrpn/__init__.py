"""VRPN 07.35, the protocol that most tracking systems can speak: pure codec, both sides of the
wire.
"""

from housefly.wires.vrpn.handshake import (
    COOKIE_SIZE,
    MAJOR_VERSION,
    decode_cookie,
    decode_lob,
    encode_cookie,
    encode_lob,
)
from housefly.wires.vrpn.message import (
    DISCONNECT,
    LOG_DESCRIPTION,
    MAX_MESSAGE,
    SENDER_DESCRIPTION,
    TYPE_DESCRIPTION,
    UDP_DESCRIPTION,
    VRPN_HEADER_SIZE,
    VrpnMessage,
    VrpnStream,
    encode_message,
)
from housefly.wires.vrpn.tracker import (
    MAX_NAME,
    MAX_NUMBERS,
    PING_TYPE,
    PONG_TYPE,
    POSE_TYPE,
    TrackerPose,
    VrpnNames,
    decode_pose,
    description_message,
    encode_pose,
)

__all__ = [
    "COOKIE_SIZE",
    "DISCONNECT",
    "LOG_DESCRIPTION",
    "MAJOR_VERSION",
    "MAX_MESSAGE",
    "MAX_NAME",
    "MAX_NUMBERS",
    "PING_TYPE",
    "PONG_TYPE",
    "POSE_TYPE",
    "SENDER_DESCRIPTION",
    "TYPE_DESCRIPTION",
    "UDP_DESCRIPTION",
    "VRPN_HEADER_SIZE",
    "TrackerPose",
    "VrpnMessage",
    "VrpnNames",
    "VrpnStream",
    "decode_cookie",
    "decode_lob",
    "decode_pose",
    "description_message",
    "encode_cookie",
    "encode_lob",
    "encode_message",
    "encode_pose",
]
