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
    digits = np.empty((len(numbers), width), np.uint8)
    for column, shift in enumerate(range(6 * (width - 1), -1, -6)):
        digits[:, column] = (numbers >> shift & 0x3F) + _BASE
    characters = digits.ravel()
    text, starts = characters.tobytes().decode("ascii"), range(0, characters.size, _BLOCK)
    sums = _checksums(characters, np.asarray(starts)).tobytes().decode("ascii")
    return [text[at : at + _BLOCK] + told for at, told in zip(starts, sums, strict=True)]


def decode_lines(lines: Sequence[str], width: int) -> tuple[int, ...]:
    """Return the numbers in checked lines of data; raises WireError."""
    data = _checked_data(lines)
    if len(data) % width:
        raise WireError(f"{len(data)} characters of data are no multiple of {width}")
    digits = data.astype(np.int64) - _BASE
    wrong = np.flatnonzero((digits < 0) | (digits > 0x3F))
    if wrong.size:
        raise WireError(f"{chr(data[wrong[0]])!r} is no SCIP digit")
    numbers = np.zeros(len(digits) // width, np.int64)
    for column in range(width):
        numbers = numbers << 6 | digits[column::width]
    return tuple(numbers.tolist())


def _checked_data(lines: Sequence[str]) -> NDArray[np.uint8]:
    """Return the characters of lines without their checksums; raises WireError on a mismatch."""
    lengths = np.fromiter(map(len, lines), np.intp, len(lines))
    if not lengths.size or lengths.min() < 2:
        return np.frombuffer("".join(map(strip_checksum, lines)).encode("ascii"), np.uint8)
    whole = np.frombuffer("".join(lines).encode("ascii"), np.uint8)
    is_data, ends = np.ones(whole.size, np.bool_), np.cumsum(lengths)
    is_data[ends - 1] = False
    told = whole[ends - 1]
    found = _checksums(np.where(is_data, whole, np.uint8(0)), ends - lengths)
    for wrong in np.flatnonzero(found != told)[:1]:
        strip_checksum(lines[wrong])
    return whole[is_data]


def _checksums(characters: NDArray[np.uint8], starts: NDArray[np.intp]) -> NDArray[np.uint8]:
    """Return the checksum characters of texts that stand one after the other from these on."""
    if not starts.size:
        return np.empty(0, np.uint8)
    sums = np.add.reduceat(characters, starts, dtype=np.int64)
    return ((sums & 0x3F) + _BASE).astype(np.uint8)
