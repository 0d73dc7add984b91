"""Gives a recording to a fresh pilot."""

from __future__ import annotations

from pathlib import Path

from housefly.app.premises import Premises
from housefly.config import Site, load_site
from housefly.errors import RecordingError
from housefly.pilot import Pilot
from housefly.record.replay import replay


def recorded_site(recording: Path) -> Site:
    """Return the site that was recorded beside a flight; raises RecordingError when it is not there."""
    path = recording.parent / "site.json"
    if not path.is_file():
        raise RecordingError(f"{path} is missing: name the site with --site")
    return load_site(path)


def verify_recording(recording: Path, premises: Premises) -> tuple[int, str]:
    """Replay a recording and compare each command bit for bit.

    Returns:
        The number of steps replayed, and "" or the first difference in words.
    """
    pilot = Pilot(premises.site, premises.room, premises.grid)
    count = 0
    for step in replay(recording):
        outputs = pilot.step(step.now, step.inputs)
        if outputs.command != step.outputs.command:
            return count, f"step {step.sequence} at {step.now:.3f} s: recorded {step.outputs.command}, replayed {outputs.command}"
        count += 1
    return count, ""
