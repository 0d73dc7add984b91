"""What a scanning range finder saw in one turn."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Scan:
    """One distance for each beam.

    Attributes:
        source: name of the scanner.
        captured_at: when it looked [s, our monotonic clock].
        received_at: when we heard of it [s].
        first_angle: of the first beam [rad], counter-clockwise from the scanner's front.
        step: from beam to beam [rad].
        ranges: distances [m]; infinite where nothing came back.
    """

    source: str
    captured_at: float
    received_at: float
    first_angle: float
    step: float
    ranges: tuple[float, ...]
