"""Replies of a range finder: echo, status and data lines with checksums, then an empty line."""

from __future__ import annotations

from dataclasses import dataclass, replace

from housefly.errors import WireError
from housefly.wires.scip.characters import (
    checksum,
    decode_lines,
    decode_number,
    encode_lines,
    encode_number,
    strip_checksum,
)
from housefly.wires.scip.requests import MeasureRequest, decode_request, encode_request

STATUS_DONE, _STATUS_SCAN = "00", "99"
"""Status of a request that was obeyed, and of a later scan of MD."""
STAMP_PERIOD = 1 << 24
"""The sensor's clock wraps after this [ms]: about four hours and 40 minutes."""
_RANGE_WIDTH = 3
"""Characters of one distance."""
MAX_REPLY = 16 * 1024
"""Longest reply accepted [bytes]; 1081 steps of three characters take about 3.4 kB."""


@dataclass(frozen=True, slots=True)
class ScipReply:
    """One reply.

    Attributes:
        echo: the request as it came back, without its line end.
        status: two characters; see ``is_good``.
        lines: what follows, each still with its checksum.
    """

    echo: str
    status: str
    lines: tuple[str, ...] = ()

    @property
    def is_good(self) -> bool:
        """Whether the sensor did what was asked."""
        return self.status in (STATUS_DONE, _STATUS_SCAN)


@dataclass(frozen=True, slots=True)
class ScipScan:
    """One scan.

    Attributes:
        request: what it answers; for MD its count is the number of scans still to come.
        stamp: the sensor's clock [ms], 24 bits.
        ranges: one number for each step from first to last [mm]; below the sensor's DMIN they are
            error codes.
    """

    request: MeasureRequest
    stamp: int
    ranges: tuple[int, ...]


def encode_reply(reply: ScipReply) -> bytes:
    """Return the bytes of a reply, empty line included."""
    lines = (reply.echo, reply.status + checksum(reply.status), *reply.lines, "", "")
    return "\n".join(lines).encode("ascii")


def decode_reply(data: bytes) -> ScipReply:
    """Return the reply in a block of lines that ends with an empty one; raises WireError.

    The checksums of the lines are checked by their readers, because not every line has one.
    """
    try:
        text = data.decode("ascii")
    except UnicodeDecodeError as error:
        raise WireError("a reply is not ASCII") from error
    if len(text) > MAX_REPLY or not text.endswith("\n\n"):
        raise WireError("a reply that is too long or does not end")
    echo, *rest = text[:-2].split("\n")
    if not rest:
        raise WireError("a reply without a status")
    status = strip_checksum(rest[0])
    if len(status) != 2:
        raise WireError(f"{status[:8]!r} is no status")
    return ScipReply(echo, status, tuple(rest[1:]))


def older_scip(block: bytes) -> str:
    """Return the version of SCIP before 2.0 that a reply shows, "" when it shows none.

    Before 2.0 the status is one character without a checksum, and the reply to ``V`` names the
    protocol ("PROT:").
    """
    lines = block.decode("ascii", errors="replace").split("\n")
    named = next((line[5:] for line in lines if line.startswith("PROT:")), "")
    protocol = named.split(";")[0].strip()[:40]
    if protocol and "SCIP 2" not in protocol and "SCIP2" not in protocol:
        return protocol
    has_short_status = len(lines) > 2 and len(lines[1]) == 1 and lines[1].isalnum()
    return "SCIP 1.x" if has_short_status and not protocol else ""


def measurement_reply(request: MeasureRequest, stamp: int, ranges: tuple[int, ...]) -> ScipReply:
    """Return the reply that carries a scan."""
    clock = encode_number(stamp % STAMP_PERIOD, 4)
    status = _STATUS_SCAN if request.code == "MD" else STATUS_DONE
    return ScipReply(
        _echo(request), status, (clock + checksum(clock), *encode_lines(ranges, _RANGE_WIDTH))
    )


def decode_measurement(reply: ScipReply) -> ScipScan | None:
    """Return the scan in a reply, None when there is none; raises WireError for a damaged one."""
    if reply.echo[:2] not in ("MD", "GD") or not reply.lines:
        return None
    request = decode_request(reply.echo.encode("ascii"))
    if not isinstance(request, MeasureRequest):
        raise WireError(f"{reply.echo[:20]!r} carries no scan")
    clock = strip_checksum(reply.lines[0])
    if len(clock) != 4:
        raise WireError(f"{clock[:8]!r} is no time")
    ranges = decode_lines(reply.lines[1:], _RANGE_WIDTH)
    wanted = -(-(request.last - request.first + 1) // max(request.cluster, 1))
    if request.last < request.first or len(ranges) != wanted:
        raise WireError(f"{len(ranges)} distances where {wanted} belong")
    return ScipScan(request, decode_number(clock), ranges)


def remaining(request: MeasureRequest, count: int) -> MeasureRequest:
    """Return a request as the echo of a scan has it: with the number of scans still to come."""
    return replace(request, count=count)


def _echo(request: MeasureRequest) -> str:
    return encode_request(request).decode("ascii").removesuffix("\n")
