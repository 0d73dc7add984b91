"""Two drones fly a service each in one room: they touch nothing, unless blind for each other."""

from __future__ import annotations

import pytest
from quick_flights import QUICK

from housefly.errors import ConfigError
from housefly.lab.lockstep.simulation import SETTLING_TIME, Simulation
from housefly.messages import EventCode, Order, OrderKind, PilotStep
from housefly.record.truth import COMPLETED
from housefly.sites.loaded_site import LoadedSite, load_site
from scores.fleet_flight import FlownService, fly_services_lockstep, without_others

DRONES = (
    {"name": "anna", "pad": (10.55, 1.25, 3.1416)},
    {"name": "bert", "pad": (8.05, 1.25, 0.0), "address": "127.0.0.2"},
)
ORDERS = {
    "anna": Order(OrderKind.SERVICE, "table", look_s=1.0),
    "bert": Order(OrderKind.SERVICE, "sofa", look_s=1.0),
}
"""Each flies past the pad of the other, there and back."""


def pair(**changes: object) -> LoadedSite:
    return load_site("bsen", hub__enabled=False, drones=DRONES, **QUICK, **changes)


@pytest.fixture(scope="module")
def flown() -> tuple[dict[str, FlownService], dict[str, list[EventCode]]]:
    told: dict[str, list[EventCode]] = {"anna": [], "bert": []}

    def note(drone: str, step: PilotStep) -> None:
        told[drone] += [event.code for event in step.outputs.events]

    return fly_services_lockstep(Simulation(pair()), ORDERS, on_step=note), told


def test_both_services_are_flown_and_nothing_is_touched(flown) -> None:
    services, _ = flown
    assert {name: one.outcome for name, one in services.items()} == dict.fromkeys(ORDERS, COMPLETED)
    assert all(one.contacts == () for one in services.values())
    assert min(one.nearest_drone for one in services.values()) > 0.5


def test_the_first_of_the_site_keeps_its_way_and_the_other_makes_way(flown) -> None:
    services, told = flown
    gives_way = {EventCode.MAKING_WAY, EventCode.WAY_BLOCKED, EventCode.DETOUR}
    assert gives_way & set(told["bert"])
    assert EventCode.MAKING_WAY not in told["anna"]
    assert services["anna"].duration < services["bert"].duration


@pytest.mark.interop
def test_blind_for_each_other_they_come_to_harm() -> None:
    simulation = Simulation(pair())
    services = fly_services_lockstep(simulation, ORDERS, hear=without_others(simulation))
    assert any(one.contacts or one.nearest_drone < 0.3 for one in services.values())


def test_one_that_is_lost_sight_of_in_the_air_is_told_of_and_its_place_kept_clear() -> None:
    simulation = Simulation(pair())
    blind, told = without_others(simulation), list[tuple[float, EventCode]]()
    place = ()
    while simulation.now < 9.0:
        simulation.advance()
        for name in simulation.drones:
            is_first = simulation.now < SETTLING_TIME + simulation.period
            orders = (Order(OrderKind.TAKE_OFF),) if is_first and simulation.now > 0.5 else ()
            if name == "anna" and not place and simulation.now > 8.0:
                place = simulation.world.drones["bert"].truth().pose.position[:2]
                orders = (Order(OrderKind.GO, goal=place),)
            inputs = simulation.inputs(*orders, drone=name)
            hides = name == "anna" and 6.5 < simulation.now < 8.5
            step = simulation.step(blind(name, inputs) if hides else inputs, name)
            told += [(step.now, event.code) for event in step.outputs.events if name == "anna"]
    codes = [code for _, code in told]
    lost = next(at for at, code in told if code is EventCode.DRONE_LOST)
    assert lost == pytest.approx(7.0, abs=0.2)
    assert EventCode.DRONE_SEEN in codes
    assert {EventCode.ORDER_REFUSED, EventCode.NO_WAY} & set(codes)


def test_a_fault_of_a_drone_that_the_site_does_not_have_is_refused() -> None:
    with pytest.raises(ConfigError, match="no drone called 'carl'"):
        Simulation(pair(faults=({"fault": "carl: mocap:off"},)))
