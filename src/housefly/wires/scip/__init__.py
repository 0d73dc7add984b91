"""SCIP 2.2, the protocol of Hokuyo's scanning range finders: pure encode and decode.

Requests are lines of text, replies are blocks of checked lines that end with an empty one. Facts
and sources: docs/wires.md.
"""

from housefly.wires.scip.parameters import URG_04LX, UST_10LX, Parameters
from housefly.wires.scip.replies import (
    Measurement,
    Reply,
    decode_reply,
    encode_reply,
    measurement_of,
    measurement_reply,
)
from housefly.wires.scip.requests import Ask, Measure, Request, decode_request, encode_request

__all__ = [
    "URG_04LX",
    "UST_10LX",
    "Ask",
    "Measure",
    "Measurement",
    "Parameters",
    "Reply",
    "Request",
    "decode_reply",
    "decode_request",
    "encode_reply",
    "encode_request",
    "measurement_of",
    "measurement_reply",
]
