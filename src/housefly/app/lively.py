"""What makes the demo lively, as changes of a site."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from housefly import sites


def lively_changes() -> dict[str, Any]:
    """Return what makes the demo lively: people, their things and devices, and what sees people.

    The scanners look at 0.85 m: over the headboard of the bed and the backs of chairs, at standing,
    sitting and small people, while the drone flies above.
    """
    z = 0.85
    return {
        "hub__things": str(Path(sites.__file__).with_name("bsen_things.toml")),
        "twin__scene": "bsen",
        "mqtt__broker": "127.0.0.1",
        "mqtt__start": True,
        "mqtt__port": 0,
        "lasers": [
            {"name": "laser-1", "x": 5.5, "y": 0.85, "z": z, "yaw": 1.2},
            {"name": "laser-2", "address": "127.0.0.2", "x": 13.9, "y": 3.3, "z": z, "yaw": -2.6},
            {"name": "laser-3", "address": "127.0.0.3", "x": 0.3, "y": 4.9, "z": z, "yaw": -0.2},
        ],
    }
