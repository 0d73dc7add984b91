"""QR codes of addresses: for the terminal, and as a drawing for the page."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.errors import MissingPartError

_QUIET = 4
"""The light margin that ISO/IEC 18004 asks for [modules]."""
_HALVES = {(True, True): "█", (True, False): "▀", (False, True): "▄", (False, False): " "}
"""Two modules, one above the other, as one letter; the light ones are inked."""


@dataclass(frozen=True, slots=True)
class QrView:
    """A QR code as a drawing: its edge [modules], margin included, and the path of its dark parts.

    The path is of SVG, one unit a module.
    """

    size: int
    path: str


def qr_view(text: str) -> QrView:
    """Return the QR code of a text as a drawing; raises MissingPartError without ``lan``."""
    rows = _modules(text)
    parts = [
        f"M{x} {y}h{length}v1h-{length}z" for y, row in enumerate(rows) for x, length in _runs(row)
    ]
    return QrView(len(rows), "".join(parts))


def qr_lines(text: str) -> tuple[str, ...]:
    """Return the QR code of a text as lines for a terminal, white ink on black.

    Raises MissingPartError without the extra ``lan``.
    """
    rows = [[not dark for dark in row] for row in _modules(text)]
    if len(rows) % 2:
        rows.append([True] * len(rows))
    return tuple(
        "".join(_HALVES[pair] for pair in zip(upper, lower, strict=True))
        for upper, lower in zip(rows[::2], rows[1::2], strict=True)
    )


def _modules(text: str) -> list[list[bool]]:
    try:
        import segno
    except ImportError as error:
        raise MissingPartError("segno", "pip install 'housefly[lan]'") from error
    code = segno.make_qr(text, error="m", boost_error=False)
    return [[bool(cell) for cell in row] for row in code.matrix_iter(border=_QUIET)]


def _runs(row: list[bool]) -> list[tuple[int, int]]:
    """Return where dark modules begin in a row, and how many they are."""
    found: list[tuple[int, int]] = []
    for x, dark in enumerate(row):
        if dark and found and sum(found[-1]) == x:
            found[-1] = (found[-1][0], found[-1][1] + 1)
        elif dark:
            found.append((x, 1))
    return found
