"""One turn of a scanning range finder."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Scan:
    """One distance per beam.

    Attributes:
        source: name of the scanner.
        captured_at: when it measured [s, our monotonic clock].
        received_at: when we received it [s].
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
