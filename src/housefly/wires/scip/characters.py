"""Numbers as printable characters, and checksums: six bits each, from "0" (0x30) on.

The manual's examples: 1234 is "CB", 5432 is "1Dh", 16000000 is "m2@0".
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from housefly.errors import WireError

_BASE = 0x30
_BLOCK = 64
"""Data characters a line carries."""


def encode_number(value: int, width: int) -> str:
    """Return a number in ``width`` characters, most significant first; raises WireError."""
    if not 0 <= value < 1 << (6 * width):
        raise WireError(f"{value} does not fit into {width} characters")
    return "".join(
        chr(_BASE + ((value >> shift) & 0x3F)) for shift in range(6 * (width - 1), -1, -6)
    )


def decode_number(text: str) -> int:
    """Return the number that characters encode; raises WireError for one outside "0" to "o"."""
    value = 0
    for character in text:
        six = ord(character) - _BASE
        if not 0 <= six < 64:
            raise WireError(f"{character!r} is no SCIP digit")
        value = value << 6 | six
    return value


def checksum(text: str) -> str:
    """Return the checksum character of a text: the lower six bits of the sum of its bytes."""
    return chr(_BASE + (sum(text.encode("ascii")) & 0x3F))


def strip_checksum(line: str) -> str:
    """Return a line without its checksum character; raises WireError on a mismatch."""
    if len(line) < 2 or checksum(line[:-1]) != line[-1]:
        raise WireError(f"the checksum of {line[:80]!r} is wrong")
    return line[:-1]


def encode_lines(values: Sequence[int], width: int) -> list[str]:
    """Return numbers as lines of at most 64 characters with a checksum each; raises WireError."""
    numbers = np.fromiter(values, np.int64, len(values))
    misfits = numbers[(numbers < 0) | (numbers >= 1 << (6 * width))]
    if misfits.size:
        raise WireError(f"{misfits[0]} does not fit into {width} characters")
    characters = (numbers[:, None] >> _shifts(width) & 0x3F) + _BASE
    text = characters.astype(np.uint8).tobytes().decode("ascii")
    return [
        text[at : at + _BLOCK] + checksum(text[at : at + _BLOCK])
        for at in range(0, len(text), _BLOCK)
    ]


def decode_lines(lines: Sequence[str], width: int) -> tuple[int, ...]:
    """Return the numbers in checked lines of data; raises WireError."""
    text = "".join(strip_checksum(line) for line in lines)
    if len(text) % width:
        raise WireError(f"{len(text)} characters of data are no multiple of {width}")
    digits = np.frombuffer(text.encode("ascii"), np.uint8).astype(np.int64) - _BASE
    wrong = np.flatnonzero((digits < 0) | (digits > 0x3F))
    if wrong.size:
        raise WireError(f"{text[wrong[0]]!r} is no SCIP digit")
    return tuple((digits.reshape(-1, width) << _shifts(width)).sum(axis=1).tolist())


def _shifts(width: int) -> NDArray[np.int64]:
    """Return how far the digits of a number are shifted, the most significant first."""
    return np.arange(6 * (width - 1), -1, -6, dtype=np.int64)
