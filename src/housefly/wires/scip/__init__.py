"""SCIP 2.2, the protocol of Hokuyo's scanning range finders: pure encode and decode.

Requests are lines of text, replies are blocks of checked lines that end with an empty one. Facts
and sources: docs/wires.md.
"""

from housefly.wires.scip.parameters import URG_04LX, UST_10LX, ScannerParameters
from housefly.wires.scip.replies import (
    ScipReply,
    ScipScan,
    decode_measurement,
    decode_reply,
    encode_reply,
    measurement_reply,
    older_scip,
)
from housefly.wires.scip.requests import (
    MeasureRequest,
    PlainRequest,
    ScipRequest,
    decode_request,
    encode_request,
)

__all__ = [
    "URG_04LX",
    "UST_10LX",
    "MeasureRequest",
    "PlainRequest",
    "ScannerParameters",
    "ScipReply",
    "ScipRequest",
    "ScipScan",
    "decode_measurement",
    "decode_reply",
    "decode_request",
    "encode_reply",
    "encode_request",
    "measurement_reply",
    "older_scip",
]
