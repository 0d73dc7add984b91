"""A Crazyflie flies the visitor service by each form of setpoints that its site may choose."""

from __future__ import annotations

from math import dist

import pytest

from housefly.lab.lockstep.service import fly_lockstep
from housefly.messages import Action, Order, OrderKind, Phase, PilotStep, PositionSetpoint
from housefly.sites.loaded_site import load_site
from housefly.twin.crazyflie.firmware import CrazyflieFirmware
from housefly.twin.world import SimulatedWorld
from housefly.wires.crazyflie.setpoints import FullState, GenericSetpoint, Place

pytestmark = pytest.mark.slow


@pytest.mark.parametrize(
    ("form", "given"),
    [
        ("position", Place),
        pytest.param("trajectory", FullState, marks=pytest.mark.interop),
    ],
)
def test_by_places_and_by_full_states_it_completes_the_service_near_its_path_and_touches_nothing(
    form: str, given: type[GenericSetpoint], monkeypatch: pytest.MonkeyPatch
) -> None:
    loaded = load_site("bsen", drone__kind="crazyflie", drone__steered_by=form, twin__video=False)
    worlds: list[SimulatedWorld] = []
    errors: list[float] = []
    asked: set[type] = set()
    flown: set[type] = set()
    give = CrazyflieFirmware.give

    def heard(self: CrazyflieFirmware, setpoint: GenericSetpoint) -> None:
        flown.add(type(setpoint))
        give(self, setpoint)

    monkeypatch.setattr(CrazyflieFirmware, "give", heard)

    def on_step(step: PilotStep) -> None:
        outputs = step.outputs
        if outputs.command.action is Action.FLY:
            asked.add(type(outputs.command.asked))
        if outputs.reference and outputs.phase is Phase.OUTBOUND:
            place = worlds[0].truth().pose.position
            errors.append(dist(place[:2], outputs.reference.position[:2]))

    order = Order(OrderKind.SERVICE, "entrance")
    assert fly_lockstep(loaded, order, on_step, on_world=worlds.append) == "completed"
    assert (sum(error * error for error in errors) / len(errors)) ** 0.5 < 0.05
    assert asked == {PositionSetpoint} and given in flown
    assert not flown & ({Place, FullState} - {given, Place})
    assert worlds[0].contact_log == ()
