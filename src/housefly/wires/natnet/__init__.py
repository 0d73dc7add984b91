"""NatNet, the protocol of OptiTrack's Motive: pure codec of versions 3 and 4, both sides of the
wire.
"""

from housefly.wires.natnet.buffer import MAX_NAME, Version
from housefly.wires.natnet.frame import Frame, RigidBody
from housefly.wires.natnet.handshake import (
    Connect,
    Disconnect,
    Item,
    KeepAlive,
    Request,
    RequestModelDef,
    Response,
    ServerInfo,
    Unrecognized,
)
from housefly.wires.natnet.message import MAX_BODY, decode_message, encode_message
from housefly.wires.natnet.model import ModelDef, RigidBodyDescription

__all__ = [
    "MAX_BODY",
    "MAX_NAME",
    "Connect",
    "Disconnect",
    "Frame",
    "Item",
    "KeepAlive",
    "ModelDef",
    "Request",
    "RequestModelDef",
    "Response",
    "RigidBody",
    "RigidBodyDescription",
    "ServerInfo",
    "Unrecognized",
    "Version",
    "decode_message",
    "encode_message",
]
