"""Whom nothing but the drone's own sonar shows is not landed on, scored on the truth."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from housefly.geometry import distance
from housefly.lab.lockstep.service import fly_lockstep
from housefly.messages import Order, OrderKind, PilotStep
from housefly.record.truth import TrueFlight, read_truth
from housefly.sites.loaded_site import load_site

SERVICE = Order(OrderKind.SERVICE, place="table", look_s=1.0)
CHILD = 0.9
"""Height of the child of row F44 [m]."""


@dataclass(frozen=True, slots=True)
class CrowdedPad:
    """How a service ended whose pad a child stands on.

    Attributes:
        outcome: of the service, in words.
        told: codes of all events.
        truth: its true course.
        pad: where the child stands [m].
    """

    outcome: str
    told: frozenset[str]
    truth: TrueFlight
    pad: tuple[float, float]


@pytest.fixture(scope="module", params=[1, pytest.param(3, marks=pytest.mark.interop)])
def flown(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> CrowdedPad:
    """A service without scanners, to whose pad a child comes meanwhile."""
    file: Path = tmp_path_factory.mktemp("child") / "truth.jsonl"
    loaded = load_site(
        "bsen",
        hub__enabled=False,
        twin__video=False,
        twin__seed=1 + request.param,
        control__rate_hz=50,
        twin__mocap_rate_hz=50,
        faults=[{"fault": "F44/child@8s"}],
    )
    told: set[str] = set()

    def hear(step: PilotStep) -> None:
        told.update(event.code for event in step.outputs.events)

    outcome = fly_lockstep(loaded, SERVICE, hear, truth_file=file)
    truth = read_truth(file)
    assert truth is not None
    return CrowdedPad(outcome, frozenset(told), truth, loaded.room.home)


@pytest.mark.slow
def test_a_child_on_the_pad_that_only_the_sonar_shows_is_not_touched(flown: CrowdedPad) -> None:
    assert flown.truth.contacts == ()
    assert np.nanmin(flown.truth.person) > 0.1
    assert "landing_blocked" in flown.told


@pytest.mark.slow
def test_the_drone_lands_beside_a_child_that_only_the_sonar_shows(flown: CrowdedPad) -> None:
    x, y, z = flown.truth.position[-1].tolist()
    assert "grounded" in flown.told
    assert z < CHILD / 2
    assert distance((x, y), flown.pad) > 0.5


@pytest.mark.slow
def test_a_child_below_is_not_taken_for_late_poses(flown: CrowdedPad) -> None:
    assert flown.told.isdisjoint({"tracking_late", "tracking_slow"})


@pytest.mark.slow
def test_the_drone_does_not_wait_above_a_childs_head(flown: CrowdedPad) -> None:
    away = np.hypot(*(flown.truth.position[:, :2] - np.array(flown.pad)).T)
    above = (away < 0.3) & (flown.truth.position[:, 2] > CHILD) & (flown.truth.time > 18.0)
    assert 0.5 < above.sum() * np.diff(flown.truth.time).mean() < 4.5
