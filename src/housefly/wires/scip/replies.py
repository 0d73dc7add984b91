"""What a range finder answers: the echo of the request, a status, and lines of data, each with a
checksum, then an empty line.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from housefly.errors import WireError
from housefly.wires.scip.characters import (
    checked,
    checksum,
    data_lines,
    decoded,
    encoded,
    values_of,
)
from housefly.wires.scip.requests import Measure, decode_request, encode_request

DONE, SCAN = "00", "99"
"""Status of a request that was obeyed, and of a scan that MD asked for earlier."""
STAMP_PERIOD = 1 << 24
"""The sensor's clock starts anew after so many milliseconds: about four hours and 40 minutes."""
WIDTH = 3
"""Characters of one distance."""
LONGEST = 16 * 1024
"""No reply is longer [bytes]: 1081 steps of three characters are about 3.4 kB."""


@dataclass(frozen=True, slots=True)
class Reply:
    """One reply.

    Attributes:
        echo: the request as it came back, without its line end.
        status: two characters; ``DONE`` and ``SCAN`` are good, others say what is wrong.
        lines: what follows, each still with its checksum.
    """

    echo: str
    status: str
    lines: tuple[str, ...] = ()

    @property
    def is_good(self) -> bool:
        """Whether the sensor did what was asked."""
        return self.status in (DONE, SCAN)


@dataclass(frozen=True, slots=True)
class Measurement:
    """One scan.

    Attributes:
        request: what it answers; for MD its count is the number of scans still to come.
        stamp: the sensor's clock [ms], 24 bits.
        ranges: one number for each step from first to last [mm]; below the sensor's DMIN they are
            error codes.
    """

    request: Measure
    stamp: int
    ranges: tuple[int, ...]


def encode_reply(reply: Reply) -> bytes:
    """Return the bytes of a reply, empty line included."""
    lines = (reply.echo, reply.status + checksum(reply.status), *reply.lines, "", "")
    return "\n".join(lines).encode("ascii")


def decode_reply(data: bytes) -> Reply:
    """Return the reply in one block of lines, which ends with an empty one; raises WireError for
    anything else.

    The lines' own checksums are checked where they are read (``Parameters``, ``measurement_of``),
    for not every line has one.
    """
    try:
        text = data.decode("ascii")
    except UnicodeDecodeError as error:
        raise WireError("a reply is not ASCII") from error
    if len(text) > LONGEST or not text.endswith("\n\n"):
        raise WireError("a reply that is too long or does not end")
    echo, *rest = text[:-2].split("\n")
    if not rest:
        raise WireError("a reply without a status")
    status = checked(rest[0])
    if len(status) != 2:
        raise WireError(f"{status[:8]!r} is no status")
    return Reply(echo, status, tuple(rest[1:]))


def measurement_reply(request: Measure, stamp: int, ranges: tuple[int, ...]) -> Reply:
    """Return the reply that carries a scan."""
    clock = encoded(stamp % STAMP_PERIOD, 4)
    status = SCAN if request.code == "MD" else DONE
    return Reply(_echo(request), status, (clock + checksum(clock), *data_lines(ranges, WIDTH)))


def measurement_of(reply: Reply) -> Measurement | None:
    """Return the scan that a reply carries, None when it carries none; raises WireError for a
    damaged one.
    """
    if reply.echo[:2] not in ("MD", "GD") or not reply.lines:
        return None
    request = decode_request(reply.echo.encode("ascii"))
    if not isinstance(request, Measure):
        raise WireError(f"{reply.echo[:20]!r} carries no scan")
    clock = checked(reply.lines[0])
    if len(clock) != 4:
        raise WireError(f"{clock[:8]!r} is no time")
    ranges = values_of(reply.lines[1:], WIDTH)
    wanted = -(-(request.last - request.first + 1) // max(request.cluster, 1))
    if request.last < request.first or len(ranges) != wanted:
        raise WireError(f"{len(ranges)} distances where {wanted} belong")
    return Measurement(request, decoded(clock), ranges)


def remaining(request: Measure, count: int) -> Measure:
    """Return a request as the echo of a scan has it: with the number of scans still to come."""
    return replace(request, count=count)


def _echo(request: Measure) -> str:
    return encode_request(request).decode("ascii").removesuffix("\n")
