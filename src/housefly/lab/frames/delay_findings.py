"""What is wrong with the delay of tracking."""

from __future__ import annotations

from housefly.config.tracking import TrackingConfig
from housefly.lab.frames.corrections import late_mend
from housefly.lab.frames.findings import FrameFault, FrameFinding

LAG_ALLOWED = 0.1
"""Longest delay of tracking that is right [s]."""
EARLY_ALLOWED = 0.25
"""Reports of a drone come later than this only over a bad link [s]."""


def lag_findings(
    lag: float | None, tracking: TrackingConfig, mended: dict[str, float | str]
) -> list[FrameFinding]:
    """Return what is wrong with a delay [s], None when it was not measured."""
    if lag is None or -EARLY_ALLOWED <= lag <= LAG_ALLOWED:
        return []
    if lag > 0.0:
        words = (
            f"Tracking sees a turn {lag:.2f} s after the drone feels it, and says that its poses"
            " are fresh"
        )
        return [FrameFinding(FrameFault.LATE, words, late_mend(lag, tracking, mended))]
    return [
        FrameFinding(
            FrameFault.EARLY,
            f"The drone tells of a turn {-lag:.2f} s after tracking sees it",
            "its radio link is slow, or tracking.latency is set too long: go nearer with the"
            " computer, choose a free Wi-Fi channel, and check again",
        )
    ]
