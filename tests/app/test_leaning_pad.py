"""A pad that leans: taken off from as long as that can be held, refused beyond, on the truth."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, degrees, hypot, radians, sin

import pytest

from housefly.lab.lockstep.simulation import Simulation
from housefly.messages import Order, OrderKind, Phase
from housefly.pilot.behavior import preflight
from housefly.pilot.behavior.preflight import TILT_ON_PAD_MAX
from housefly.sites.loaded_site import load_site


@dataclass(frozen=True, slots=True)
class TakeOff:
    """How a take-off went: said, phase at the end, how far aside [m], and how high [m]."""

    said: tuple[str, ...]
    phase: Phase
    aside: float
    height: float


def take_off(lean: float) -> TakeOff:
    """Take off from a floor that leans by so much [rad], and wait."""
    loaded = load_site("bsen", hub__enabled=False, twin__video=False)
    simulation, (x, y) = Simulation(loaded), loaded.room.home
    physics = simulation.world._physics
    floor = physics.model.geom("floor").id
    physics.model.geom_pos[floor] = (x, y, 0.0)
    physics.model.geom_quat[floor] = (cos(lean / 2), 0.0, sin(lean / 2), 0.0)
    physics.model.geom_sameframe[floor] = 0
    said: list[str] = []
    for n in range(1100):
        simulation.advance()
        orders = (Order(OrderKind.TAKE_OFF),) if n == 120 else ()
        step = simulation.step(simulation.inputs(*orders))
        said += [event.text for event in step.outputs.events]
        if n == 119:
            x, y, _ = simulation.world.truth().pose.position
        if n > 200 and step.outputs.phase is Phase.IDLE:
            break
    at = simulation.world.truth().pose.position
    return TakeOff(tuple(said), step.outputs.phase, hypot(at[0] - x, at[1] - y), at[2])


def test_from_a_pad_that_leans_by_what_is_allowed_it_takes_off_straight() -> None:
    flown = take_off(TILT_ON_PAD_MAX - radians(0.5))
    assert flown.phase is Phase.HOLDING and flown.height > 0.9
    assert flown.aside < 0.15


def test_one_that_leans_more_is_refused_with_what_to_do() -> None:
    flown = take_off(radians(10.0))
    assert flown.phase is Phase.IDLE and flown.height < 0.1
    refused = [text for text in flown.said if "refused" in text]
    assert len(refused) == 1
    limit = f"at most {degrees(TILT_ON_PAD_MAX):.0f} deg"
    assert "leans: 10 deg" in refused[0] and limit in refused[0] and "level" in refused[0]


def test_without_that_refusal_it_slides_off_its_pad(monkeypatch: pytest.MonkeyPatch) -> None:
    """The negative control, at what was allowed before."""
    monkeypatch.setattr(preflight, "TILT_ON_PAD_MAX", radians(12.0))
    flown = take_off(radians(10.0))
    assert any("blown" in text for text in flown.said)
