"""Several drones in one simulated room: each flies by itself, and they can touch each other."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import pytest

from housefly.config.site import Site, changed
from housefly.errors import ConfigError, WireError
from housefly.messages.stick import Stick
from housefly.room.model import Room
from housefly.twin.contracts import FlightState, TwinDrone
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.hands import CarryOrder
from housefly.twin.simulated_drone import SimulatedDrone
from housefly.twin.solids import SolidKind
from housefly.twin.world import SimulatedWorld

MakeRoom = Callable[..., Room]
DRONES = (
    {"name": "anna", "pad": (2.0, 2.5, 0.0)},
    {"name": "bert", "address": "127.0.0.2", "pad": (5.0, 2.5, 0.0), "hull_length": 0.4},
)
PAIR = changed(Site(), drones=DRONES, twin__mocap_noise=0.0)


@dataclass
class Pair:
    """Two drones whose clients are kept alive."""

    world: SimulatedWorld

    @property
    def anna(self) -> SimulatedDrone:
        return self.world.drones["anna"]

    @property
    def bert(self) -> SimulatedDrone:
        return self.world.drones["bert"]

    def wait(self, seconds: float) -> Iterator[float]:
        for _ in range(round(seconds / 0.01)):
            self.anna.keep_alive()
            self.bert.keep_alive()
            self.world.advance(0.01)
            yield self.world.now


@pytest.fixture
def pair(make_room: MakeRoom) -> Pair:
    return Pair(SimulatedWorld(PAIR, make_room()))


def test_each_obeys_its_own_commands_and_tracking_shows_both(pair: Pair) -> None:
    is_drone: TwinDrone = pair.bert
    is_drone.request_take_off()
    for _ in pair.wait(6.0):
        pass
    assert pair.anna.onboard().flight is FlightState.LANDED
    assert pair.bert.onboard().flight is FlightState.HOVERING
    seen = dict(pair.world.mocap_frames()[-1].bodies)
    assert list(seen)[:2] == ["anna", "bert"]
    for drone in (pair.anna, pair.bert):
        pose = seen[drone.name]
        assert pose is not None
        assert pose.position == pytest.approx(drone.truth().pose.position, abs=0.02)
    assert pair.world.first is pair.anna
    assert pair.anna.clearance().drone == pair.bert.clearance().drone
    assert pair.anna.contact_log == pair.bert.contact_log == ()


def test_drones_that_meet_push_each_other_and_each_names_the_other(pair: Pair) -> None:
    pair.anna.hover((2.0, 2.5, 1.2), 0.0)
    pair.bert.hover((3.2, 2.5, 1.2), 0.0)
    nearest = pair.anna.clearance().drone
    assert nearest == pytest.approx(1.2 - (0.517 + 0.4) / 2, abs=0.02)
    before = pair.bert.truth().pose.position[0]
    for _ in pair.wait(4.0):
        pair.anna.set_stick(Stick(forward=0.4, hover=False))
        if pair.anna.contact_log:
            break
    (met,), (also_met,) = pair.anna.contact_log, pair.bert.contact_log
    assert (met.kind, met.name) == (SolidKind.DRONE, "bert")
    assert (also_met.kind, also_met.name) == (SolidKind.DRONE, "anna")
    assert met.motors_turned and also_met.motors_turned
    assert met.speed == pytest.approx(also_met.speed, abs=0.05)
    assert met.own_speed > 0.3 > also_met.own_speed
    assert pair.anna.clearance().drone == 0.0
    for _ in pair.wait(0.5):
        pass
    assert pair.bert.truth().pose.position[0] > before + 0.02


def test_the_sonar_hears_a_drone_that_stands_below(pair: Pair) -> None:
    pair.anna.hover((5.0, 2.5, 1.0), 0.0)
    for _ in pair.wait(0.1):
        pass
    assert pair.anna.onboard().height < 0.97
    alone = pair.anna.onboard().height
    pair.anna.hover((2.0, 2.5, 1.0), 0.0)
    for _ in pair.wait(0.1):
        pass
    assert pair.anna.onboard().height > alone + 0.02


def test_one_flies_as_it_does_beside_one_that_stands(make_room: MakeRoom) -> None:
    def course(other_flies: bool) -> list[float]:
        pair = Pair(SimulatedWorld(PAIR, make_room()))
        pair.anna.request_take_off()
        if other_flies:
            pair.bert.request_take_off()
        return [part for _ in pair.wait(3.0) for part in pair.anna.truth().pose.position]

    assert course(True) == pytest.approx(course(False), abs=1e-6)


def test_a_fault_befalls_the_drone_that_it_names_and_else_the_first(make_room: MakeRoom) -> None:
    site = changed(
        PAIR, faults=({"fault": "bert: wind.x:wrong=1.0"}, {"fault": "battery:wrong=0.3"})
    )
    pair = Pair(SimulatedWorld(site, make_room()))
    for drone in (pair.anna, pair.bert):
        FaultInjector(site.for_drone(drone.name)).act_on(pair.world, drone)
    assert pair.anna.disturbances.charge == 0.3
    assert pair.anna.disturbances.wind == (0.0, 0.0, 0.0)
    assert pair.bert.disturbances.charge is None
    assert pair.bert.disturbances.wind == (1.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("fault", "words"),
    [
        ("berta: mocap:off", "there is no drone called 'berta': did you mean 'bert'"),
        ("bert: laser:off", "laser is the room's, not bert's"),
    ],
)
def test_a_fault_of_nobody_is_refused(fault: str, words: str) -> None:
    site = changed(PAIR, faults=({"fault": fault},))
    with pytest.raises(ConfigError, match=words):
        FaultInjector(site.for_drone("anna"))


def test_who_is_carried_is_named(pair: Pair) -> None:
    pair.world.carry_drone(CarryOrder((6.0, 2.5, 0.5), 0.0, drone="bert"))
    assert pair.bert.is_carried and not pair.anna.is_carried
    with pytest.raises(WireError, match="no drone called 'carl'"):
        pair.world.carry_drone(CarryOrder((6.0, 2.5, 0.5), 0.0, drone="carl"))
