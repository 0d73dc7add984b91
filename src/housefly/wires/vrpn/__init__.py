"""VRPN 07.35, the protocol that most tracking systems can speak: pure codec, both sides of the
wire.
"""

from housefly.wires.vrpn.handshake import (
    COOKIE_SIZE,
    MAJOR,
    decode_cookie,
    decode_lob,
    encode_cookie,
    encode_lob,
)
from housefly.wires.vrpn.message import (
    DISCONNECT,
    HEADER_SIZE,
    LOG_DESCRIPTION,
    MAX_MESSAGE,
    SENDER_DESCRIPTION,
    TYPE_DESCRIPTION,
    UDP_DESCRIPTION,
    Message,
    MessageStream,
    encode_message,
)
from housefly.wires.vrpn.tracker import (
    MAX_NAME,
    MAX_NUMBERS,
    PING,
    PONG,
    POSE,
    Names,
    TrackerPose,
    decode_pose,
    describe,
    encode_pose,
)

__all__ = [
    "COOKIE_SIZE",
    "DISCONNECT",
    "HEADER_SIZE",
    "LOG_DESCRIPTION",
    "MAJOR",
    "MAX_MESSAGE",
    "MAX_NAME",
    "MAX_NUMBERS",
    "PING",
    "PONG",
    "POSE",
    "SENDER_DESCRIPTION",
    "TYPE_DESCRIPTION",
    "UDP_DESCRIPTION",
    "Message",
    "MessageStream",
    "Names",
    "TrackerPose",
    "decode_cookie",
    "decode_lob",
    "decode_pose",
    "describe",
    "encode_cookie",
    "encode_lob",
    "encode_message",
    "encode_pose",
]
