"""NatNet, the protocol of OptiTrack's Motive: pure codec of versions 3 and 4, both sides."""

from housefly.wires.natnet.buffer import NAME_FIELD_SIZE, NatNetVersion
from housefly.wires.natnet.frame import NatNetFrame, RigidBody
from housefly.wires.natnet.handshake import (
    CommandRequest,
    CommandResponse,
    Connect,
    Disconnect,
    Discovery,
    EchoRequest,
    EchoResponse,
    KeepAlive,
    NatNetMessage,
    RequestModelDef,
    ServerInfo,
    Unrecognized,
)
from housefly.wires.natnet.message import MAX_BODY, decode_natnet, encode_natnet
from housefly.wires.natnet.model import ModelDef, RigidBodyDescription

__all__ = [
    "MAX_BODY",
    "NAME_FIELD_SIZE",
    "CommandRequest",
    "CommandResponse",
    "Connect",
    "Disconnect",
    "Discovery",
    "EchoRequest",
    "EchoResponse",
    "KeepAlive",
    "ModelDef",
    "NatNetFrame",
    "NatNetMessage",
    "NatNetVersion",
    "RequestModelDef",
    "RigidBody",
    "RigidBodyDescription",
    "ServerInfo",
    "Unrecognized",
    "decode_natnet",
    "encode_natnet",
]
