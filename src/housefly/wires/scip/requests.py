"""Requests to a range finder: one line of text each."""

from __future__ import annotations

import re
from dataclasses import dataclass

from housefly.errors import WireError

PLAIN_REQUESTS = frozenset({"VV", "PP", "II", "BM", "QT", "RS"})
"""Version, parameters, state, laser on, laser off, reset."""
MAX_REQUEST = 64
"""Longest request accepted [bytes]; bounds the memory that a stranger can take."""
_NOTE = re.compile(r"[A-Za-z0-9 ._+@]{0,16}")
_ASK = re.compile(r"([A-Z]{2})(?:;(.*))?")
_MEASURE = re.compile(r"(MD|GD)(\d{4})(\d{4})(\d{2})(?:(\d)(\d{2}))?(?:;(.*))?")


@dataclass(frozen=True, slots=True)
class PlainRequest:
    """A request without numbers.

    Attributes:
        code: one of ``PLAIN_REQUESTS``.
        note: up to 16 characters that come back in the echo.
    """

    code: str
    note: str = ""


@dataclass(frozen=True, slots=True)
class MeasureRequest:
    """A request for distances in three characters each.

    Attributes:
        code: MD (measure and send ``count`` scans) or GD (send the newest).
        first, last: steps.
        cluster: number of neighbouring steps merged to their smallest distance; 0 counts as 1.
        skip: MD: scans left out after each that is sent, 0 to 9.
        count: MD: scans to send, 0 to 99; 0 means until told to stop.
        note: up to 16 characters that come back in the echo.
    """

    code: str
    first: int
    last: int
    cluster: int = 1
    skip: int = 0
    count: int = 0
    note: str = ""


ScipRequest = PlainRequest | MeasureRequest


def encode_request(request: ScipRequest) -> bytes:
    """Return the line of a request, line feed included; raises WireError for what does not fit."""
    if not _NOTE.fullmatch(request.note):
        raise WireError(
            f"{request.note!r} is no note: at most 16 letters, digits, spaces and . _ + @"
        )
    note = f";{request.note}" if request.note else ""
    text = request.code if isinstance(request, PlainRequest) else _numbers(request)
    return f"{text}{note}\n".encode("ascii")


def decode_request(line: bytes) -> ScipRequest:
    """Return the request in a line without its line end; raises WireError for anything else."""
    try:
        text = line.decode("ascii")
    except UnicodeDecodeError as error:
        raise WireError("a request is not ASCII") from error
    found = _MEASURE.fullmatch(text)
    if found:
        code, first, last, cluster, skip, count, note = found.groups(default="")
        if (code == "MD") != bool(skip):
            raise WireError(f"{code} with the wrong number of digits")
        return MeasureRequest(
            code,
            int(first),
            int(last),
            int(cluster),
            int(skip or 0),
            int(count or 0),
            _checked(note),
        )
    found = _ASK.fullmatch(text)
    if not found or found[1] not in PLAIN_REQUESTS:
        raise WireError(f"{text[:20]!r} is no request")
    return PlainRequest(found[1], _checked(found[2] or ""))


def _numbers(request: MeasureRequest) -> str:
    ranges = (
        (request.first, 9999),
        (request.last, 9999),
        (request.cluster, 99),
        (request.skip, 9),
        (request.count, 99),
    )
    if not all(0 <= value <= most for value, most in ranges):
        raise WireError(f"a number of {request} does not fit")
    steps = f"{request.code}{request.first:04}{request.last:04}{request.cluster:02}"
    return steps + (f"{request.skip}{request.count:02}" if request.code == "MD" else "")


def _checked(note: str) -> str:
    if not _NOTE.fullmatch(note):
        raise WireError("a note that is too long or holds forbidden characters")
    return note
