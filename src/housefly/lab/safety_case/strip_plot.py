"""One dot per flight: when a person was told, by phase; unsafe flights stand out."""

from __future__ import annotations

from collections.abc import Sequence
from math import log10

from housefly.lab.safety_case.fault_phase import FaultPhase
from housefly.lab.safety_case.trial import TrialResult

_WIDTH, _HEIGHT = 180.0, 34.0
_FIRST, _LAST = 0.05, 60.0
"""Times at the left and right edge [s]; the scale is logarithmic."""


def strip_plot(results: Sequence[TrialResult]) -> str:
    """Return an SVG: a row of dots per phase, from 0.05 s to a minute; ✕ is unsafe."""
    lines = "".join(
        f'<line x1="{_x(at):.1f}" x2="{_x(at):.1f}" y1="0" y2="{_HEIGHT}" stroke="var(--line)"/>'
        for at in (0.1, 0.5, 1.0, 10.0)
    )
    dots = "".join(_dot(result) for result in sorted(results, key=lambda r: r.unsafe))
    title = "seconds until a person was told, one row per phase; lines at 0.1, 0.5, 1 and 10 s"
    return (
        f'<svg class="strip" viewBox="0 0 {_WIDTH:g} {_HEIGHT:g}" role="img" aria-label="{title}">'
        f"<title>{title}</title>{lines}{dots}</svg>"
    )


def _x(seconds: float) -> float:
    kept = min(max(seconds, _FIRST), _LAST)
    return 3.0 + (_WIDTH - 6.0) * log10(kept / _FIRST) / log10(_LAST / _FIRST)


def _dot(result: TrialResult) -> str:
    row = list(FaultPhase).index(result.phase)
    y = (row + 0.5) * _HEIGHT / len(FaultPhase)
    x = _x(_LAST if result.told_after is None else result.told_after)
    if result.unsafe:
        return (
            f'<path d="M{x - 2:.1f} {y - 2:.1f}l4 4m0-4l-4 4" stroke="var(--fault)"'
            ' stroke-width="1.5" fill="none"/>'
        )
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="1.4" fill="var(--accent)" opacity="0.6"/>'
