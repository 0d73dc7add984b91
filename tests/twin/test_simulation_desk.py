"""What a person does to the simulated room: put back, charge, let somebody walk, break, mend."""

from __future__ import annotations

from math import inf, pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.bus.simulated_room import (
    SimulatedAct,
    SimulatedDeed,
    act_from_json,
    act_to_json,
    outcome_from_json,
    outcome_to_json,
)
from housefly.errors import WireError
from housefly.geometry import quaternion_from_euler
from housefly.sites.loaded_site import load_site
from housefly.twin.contracts import FlightState
from housefly.twin.faults.catalogue import row_of
from housefly.twin.faults.fault import FaultSchedule
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.told_rows import STOPPED_MOTOR, TOLD_ROWS, told_fault
from housefly.twin.faults.vocabulary import Injection
from housefly.twin.simulation_desk import SimulationDesk
from housefly.twin.world import SimulatedWorld

FALL = 2.0
"""Until a drone whose motors are cut lies still [s]."""


class Room:
    """A simulated room, the faults in it, and who changes it."""

    def __init__(self) -> None:
        site = load_site("bsen")
        self.faults = FaultInjector(site.site, Injection.WIRES, intruders=True)
        self.world = SimulatedWorld(
            site.site, site.room, movables=self.faults.movables, people=self.faults.people
        )
        self.drone = next(iter(self.world.drones))
        self.desk = SimulationDesk(self.world, {self.drone: self.faults})

    def do(self, deed: SimulatedDeed, fault: str = "", seconds: float = 10.0) -> tuple[bool, str]:
        outcome = self.desk.do(SimulatedAct(deed, "", fault, seconds))
        return outcome.done, outcome.words

    def run(self, seconds: float) -> None:
        for _ in range(round(seconds / 0.05)):
            self.world.keep_alive()
            self.world.advance(0.05)
            self.faults.act_on(self.world, self.world.first)

    def take_off(self) -> None:
        self.world.request_land()
        self.run(0.1)
        self.world.request_take_off()
        self.run(5.0)
        assert self.world.onboard().flight.airborne

    @property
    def place(self) -> tuple[float, float]:
        return self.world.truth().pose.position[:2]


def test_a_drone_that_fell_is_put_back_upright_and_flies_again() -> None:
    room = Room()
    pad, yaw = room.place, room.world.truth().pose.yaw
    room.take_off()
    assert (
        room.do(SimulatedDeed.PUT_BACK)[1] == "nobody takes hold of a drone whose propellers turn"
    )
    assert not room.do(SimulatedDeed.CHARGE)[0]
    room.world.toggle_emergency()
    room.run(FALL)
    lying = quaternion_from_euler(0.5 * pi, 0.0, 0.0)
    room.world.first._rigid.place((pad[0] - 2.0, pad[1], 0.3), lying)
    room.run(FALL)
    assert room.world.onboard().angles_out_of_range, "it tipped over"
    room.world.first.battery.charge = 0.1
    assert room.do(SimulatedDeed.PUT_BACK)[0] and room.world.is_carried
    assert room.do(SimulatedDeed.CHARGE)[0]
    room.run(12.0)
    assert not room.world.is_carried and room.place == pytest.approx(pad, abs=0.02)
    assert room.world.truth().pose.yaw == pytest.approx(yaw, abs=0.02)
    assert not room.world.onboard().angles_out_of_range and room.world.onboard().battery > 0.99
    assert room.world.onboard().flight is FlightState.EMERGENCY, "who flies resets it, as always"
    room.world.toggle_emergency()
    room.take_off()


def test_a_fault_is_over_when_its_time_is_or_when_somebody_mends_it() -> None:
    room = Room()
    room.do(SimulatedDeed.FAULT, "F47", 2.0)
    room.run(0.2)
    assert room.desk.do(SimulatedAct(SimulatedDeed.LOOK)).failing == 1
    assert room.faults.schedule.active(room.world.now)
    room.run(2.0)
    assert room.desk.do(SimulatedAct(SimulatedDeed.LOOK)).failing == 0
    assert not room.faults.schedule.active(room.world.now)
    room.do(SimulatedDeed.FAULT, "F14", 200.0)
    room.run(0.2)
    assert room.do(SimulatedDeed.MEND)[0] and not room.faults.schedule.active(room.world.now)


def test_somebody_walks_and_is_gone_again() -> None:
    room = Room()
    assert room.do(SimulatedDeed.WALK)[0]
    room.run(0.5)
    assert any(pose.position[2] > -1.0 for pose in room.world.people())
    room.run(31.0)
    assert all(pose.position[2] < -1.0 for pose in room.world.people())


@pytest.mark.parametrize(
    ("act", "words"),
    [
        (SimulatedAct(SimulatedDeed.PUT_BACK, "nobody"), "no drone called nobody"),
        (SimulatedAct(SimulatedDeed.FAULT, "", "F99"), "'F99' cannot be made here; there are F03"),
    ],
)
def test_what_is_not_there_is_refused_in_words(act: SimulatedAct, words: str) -> None:
    outcome = Room().desk.do(act)
    assert not outcome.done and words in outcome.words


def test_every_fault_that_can_be_made_is_a_row_of_the_catalogue_in_its_words() -> None:
    for row, words in TOLD_ROWS.items():
        known = row_of(row.partition("/")[0])
        assert row == STOPPED_MOTOR or words == known.title
        assert Injection.WIRES in known.where


@given(st.sampled_from(sorted(TOLD_ROWS)), st.floats(0.0, 1e4), st.floats(1.0, 300.0))
def test_no_fault_lasts_longer_than_its_maker_said(row: str, now: float, seconds: float) -> None:
    faults = told_fault(row, "", now, seconds)
    assert faults
    for fault in faults:
        assert now <= fault.start < fault.end <= now + seconds + 1e-6 < inf
    ended = FaultSchedule().with_faults(faults).without(faults, now + 0.5)
    assert not ended.active(now + 0.5)


@given(
    st.builds(
        SimulatedAct,
        st.sampled_from(SimulatedDeed),
        st.text(max_size=64),
        st.text(max_size=64),
        st.floats(1.0, 300.0),
    )
)
def test_an_act_survives_the_wire(act: SimulatedAct) -> None:
    assert act_from_json(act_to_json(act)) == act


@given(st.text() | st.just('{"deed": "look", "seconds": 0}') | st.just('{"deed": 1}'))
def test_what_is_no_act_and_no_outcome_is_refused_in_words(text: str) -> None:
    for read in (act_from_json, outcome_from_json):
        with pytest.raises(WireError):
            read(text)


def test_an_outcome_survives_the_wire() -> None:
    outcome = Room().desk.do(SimulatedAct(SimulatedDeed.LOOK))
    assert outcome_from_json(outcome_to_json(outcome)) == outcome and len(outcome.faults) > 15
