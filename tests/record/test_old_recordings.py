"""Recordings made by an older version (``data/README.md``) give the same outputs bit for bit."""

from __future__ import annotations

from pathlib import Path

import pytest

from housefly.app.replaying import recorded_site
from housefly.messages import Inputs, Outputs, Phase, SafetyMode
from housefly.pilot.assembly import make_pilot
from housefly.pilot.pilot import Pilot
from housefly.record.replay import read_steps, verify
from housefly.sites.loaded_site import open_site

DATA = Path(__file__).parent / "data"
RECORDINGS = {"default": 3676, "paper": 3345, "troubles": 3100}


class Noted:
    """A pilot whose outputs are kept."""

    def __init__(self, pilot: Pilot) -> None:
        self._pilot = pilot
        self.outputs: list[Outputs] = []

    def step(self, now: float, inputs: Inputs) -> Outputs:
        self.outputs.append(self._pilot.step(now, inputs))
        return self.outputs[-1]


@pytest.mark.parametrize("name", RECORDINGS)
def test_an_old_recording_is_replayed_bit_for_bit(name: str) -> None:
    recording = DATA / name / "flight.mcap"
    loaded = open_site(recorded_site(recording))
    noted = Noted(make_pilot(loaded.site, loaded.room, loaded.grid))
    result = verify(recording, lambda: noted)
    assert (result.steps, result.missing, result.difference) == (RECORDINGS[name], 0, None)
    for step, outputs in zip(read_steps(recording), noted.outputs, strict=True):
        assert repr(outputs) == repr(step.outputs), step.sequence


def test_what_the_old_recordings_hold() -> None:
    steps = list(read_steps(DATA / "troubles"))
    events = {event.code for step in steps for event in step.outputs.events}
    assert {"stopped", "tracking_old", "detour", "safety_clear", "grounded"} <= events
    assert {step.outputs.safety for step in steps} >= {SafetyMode.STOPPED, SafetyMode.HOLD}
    phases = {step.outputs.phase for step in steps}
    assert phases == set(Phase) - {Phase.LOOKING}
