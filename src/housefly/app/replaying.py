"""Replays a recording with a fresh pilot."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from housefly.config.site import Site, site_from_tree
from housefly.config.toml import read_toml
from housefly.errors import RecordingError
from housefly.pilot.assembly import make_pilot
from housefly.record.replay import ReplayResult, verify
from housefly.sites.loaded_site import LoadedSite

_DEFAULTS_BEFORE_THE_KEY: Mapping[tuple[str, str], Any] = {
    ("map", "planner"): "grid",
    ("estimation", "disturbance_wander"): 0.2,
    ("estimation", "lift_wander"): 0.0,
    ("estimation", "delay_deviation"): 0.0,
    ("estimation", "aims_upwind"): False,
    ("estimation", "mistrust"): 0.0,
    ("limits", "climb_command_max"): 0.0,
    ("limits", "landing_height"): 0.45,
    ("limits", "landing_lead"): 0.0,
}
"""What was flown by releases that did not write these keys into their recordings."""


def recorded_site(recording: Path) -> Site:
    """Return the site recorded beside a flight; raises RecordingError when it is missing."""
    path = recording.parent / "site.json"
    if not path.is_file():
        raise RecordingError(f"{path} is missing: name the site with --site")
    return site_from_tree(_with_defaults_then(read_toml(path, "site file")), str(path))


def _with_defaults_then(tree: dict[str, Any]) -> dict[str, Any]:
    """Return a recorded site with what its release flew where it has no key for it yet."""
    for (table, key), value in _DEFAULTS_BEFORE_THE_KEY.items():
        section = tree.setdefault(table, {})
        if isinstance(section, dict):
            section.setdefault(key, value)
    return tree


def verify_recording(recording: Path, loaded: LoadedSite) -> ReplayResult:
    """Replay a recording and compare each command bit for bit."""
    return verify(recording, lambda: make_pilot(loaded.site, loaded.room, loaded.grid))
