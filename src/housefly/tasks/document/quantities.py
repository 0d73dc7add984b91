"""Times and lengths as people write them: ``20 s``, ``2 min``, ``1.5 m``."""

from __future__ import annotations

import re
from math import isfinite

UNITS: dict[str, dict[str, float]] = {
    "s": {"ms": 0.001, "s": 1.0, "sec": 1.0, "min": 60.0, "h": 3600.0, "d": 86400.0},
    "m": {"mm": 0.001, "cm": 0.01, "m": 1.0},
    "deg": {"deg": 1.0},
    "%": {"%": 1.0},
}
"""What may be written for each unit, and how much of it that is."""
_WRITTEN = re.compile(r"\s*([-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d{1,3})?)\s*([A-Za-z%]*)\s*")


def quantity_of(value: str | float | bool, unit: str) -> float | None:
    """Return a number in a unit, from a number or from text that names its unit; None if neither.

    Args:
        value: a number counts as in ``unit`` already.
        unit: a key of UNITS, any other word, or "" for a plain number.
    """
    if isinstance(value, bool):
        return None
    if isinstance(value, str):
        match = _WRITTEN.fullmatch(value)
        factors = {"": 1.0, **UNITS.get(unit, {unit: 1.0})}
        if match is None or match[2] not in factors:
            return None
        return _finite(float(match[1]) * factors[match[2]])
    return _finite(float(value))


def quantity_words(value: float, unit: str) -> str:
    """Return a number with its unit."""
    return f"{value:g} {unit}".strip()


def _finite(number: float) -> float | None:
    return number if isfinite(number) else None
