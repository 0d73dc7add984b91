"""The report of a recording of ours, made again from what lies in its folder."""

from __future__ import annotations

import json
from pathlib import Path

from housefly.app.replaying import recorded_site
from housefly.bus.codec import from_cdr
from housefly.bus.interfaces import recorded_store
from housefly.errors import RecordingError, WireError
from housefly.messages import PlannedTrajectory
from housefly.record.mcap_reader import read_messages
from housefly.record.replay import read_steps
from housefly.record.report import write_report
from housefly.record.series import collect
from housefly.record.summary import Summary, summarize_flight
from housefly.record.truth import TRUTH_FILE, read_truth
from housefly.sites.loaded_site import open_site

_TRAJECTORY = "/housefly/trajectory"
_UNKNOWN = "not known: there is no summary.json beside it"


def rewrite_report(file: Path, out: Path) -> Summary:
    """Write the report of a recording anew, and return its numbers.

    Args:
        file: ``flight.mcap``; ``site.json`` lies beside it.
        out: of the HTML file.

    Raises:
        RecordingError: the recording or its site cannot be read.
        OSError: the report cannot be written.
    """
    loaded = open_site(recorded_site(file))
    site = loaded.site
    planned: list[PlannedTrajectory] = []
    pictures = 0
    for message in read_messages(file):
        pictures += message.topic == "/video"
        if message.topic == _TRAJECTORY:
            try:
                types = recorded_store(message.type_name, message.schema)
                planned.append(from_cdr(PlannedTrajectory, message.data, types))
            except WireError as error:
                raise RecordingError(f"{file} is damaged: {error}") from error
    flight = collect(read_steps(file), site.tracking.body, planned)
    summary = summarize_flight(
        flight,
        _outcome(file.with_name("summary.json")),
        site,
        loaded.room,
        loaded.grid,
        truth=read_truth(file.with_name(TRUTH_FILE)),
        video_frames=pictures,
    )
    write_report(out, flight, summary, site, loaded.room, loaded.grid)
    return summary


def _outcome(summary: Path) -> str:
    try:
        return str(json.loads(summary.read_text(encoding="utf-8"))["outcome"])
    except (OSError, ValueError, KeyError, TypeError):
        return _UNKNOWN
