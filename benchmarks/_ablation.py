"""What a flight owes to each part of estimation and control: each left out once.

Changes are keys of the site file with two underscores for the dot, as ``load_site`` takes them.
Base it on whatever else is flown: ``load_site("bsen", **base | change)``.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

LEFT_OUT: Mapping[str, Mapping[str, Any]] = {
    "feed-forward": {"control__feed_forward": 0.0},
    "delay compensation": {"estimation__delay_compensated": False},
    "delay found in flight": {"estimation__delay_deviation": 0.0},
    "disturbance state": {
        "estimation__disturbance_wander": 0.0,
        "estimation__lift_wander": 0.0,
    },
    "gain schedule": {"estimation__mistrust": 0.0},
    "landing held to 0.3 m": {
        "limits__landing_height": 0.45,
        "limits__landing_lead": 0.0,
        "estimation__aims_upwind": False,
    },
}
"""What switches each part off."""


def ablations() -> dict[str, dict[str, Any]]:
    """Return the changes of the site by name: none, and each part left out."""
    shipped: dict[str, dict[str, Any]] = {"as shipped": {}}
    return shipped | {f"without {name}": dict(change) for name, change in LEFT_OUT.items()}
