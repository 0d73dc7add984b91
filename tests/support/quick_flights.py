"""Rates at which flights of the tests cost half: for whatever does not judge the shipped rates."""

from __future__ import annotations

from typing import Any

QUICK: dict[str, Any] = {"control__rate_hz": 50, "twin__mocap_rate_hz": 25}
"""Half the steps of the pilot and a quarter of the tracking: half the time, the same flight."""
