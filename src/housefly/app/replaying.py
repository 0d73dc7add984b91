"""Replays a recording with a fresh pilot."""

from __future__ import annotations

from pathlib import Path

from housefly.app.loaded_site import LoadedSite
from housefly.config.site import Site, site_from_file
from housefly.errors import RecordingError
from housefly.pilot.assembly import make_pilot
from housefly.record.replay import ReplayResult, verify


def recorded_site(recording: Path) -> Site:
    """Return the site recorded beside a flight; raises RecordingError when it is missing."""
    path = recording.parent / "site.json"
    if not path.is_file():
        raise RecordingError(f"{path} is missing: name the site with --site")
    return site_from_file(path)


def verify_recording(recording: Path, loaded: LoadedSite) -> ReplayResult:
    """Replay a recording and compare each command bit for bit."""
    return verify(recording, lambda: make_pilot(loaded.site, loaded.room, loaded.grid))
