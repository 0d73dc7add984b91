"""A drone that cannot see people says so: before its take-off, in its flight, and on the wires."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import inf, nan

import pytest
from hypothesis import given
from hypothesis import strategies as st
from quick_flights import QUICK

from housefly.app.people_sight import PeopleSight
from housefly.clock import SteppedClock
from housefly.config.site import Site, changed
from housefly.lab.lockstep.simulation import SETTLING_TIME, Simulation
from housefly.messages import Order, OrderKind, Phase, PilotStep, SafetyMode, SightNews
from housefly.pilot.behavior.mission import PEOPLE_SILENCE_MAX, longest_silence
from housefly.sites.loaded_site import open_site, read_site

LASERS = (
    {"name": "laser-1", "x": 5.5, "y": 0.85, "z": 1.1, "yaw": 1.2},
    {"name": "laser-2", "address": "127.0.0.2", "x": 13.9, "y": 3.3, "z": 1.1, "yaw": -2.6},
)
CAMERA = {"name": "depth-1", "x": 10.5, "y": 1.25, "z": 1.6, "yaw": 2.75, "rate_hz": 5.0}
SEEING = {"lasers": list(LASERS), "depth_cameras": [CAMERA]}
OFF_AT, BACK_AFTER = 12.0, 5.0


def site_with(*faults: str, **sensors: object) -> Site:
    written = [{"fault": fault} for fault in faults]
    return changed(
        read_site("bsen"), twin__visitor_present=False, faults=written, **QUICK, **sensors
    )


@dataclass
class Told:
    """What the pilot said in a flight to the entrance, ordered at a time [s]."""

    steps: list[PilotStep] = field(default_factory=list)

    def fly(self, site: Site, until: float, ordered_at: float = 2.0 * SETTLING_TIME) -> Told:
        loop, given = Simulation(open_site(site)), False
        while loop.now < until:
            loop.advance()
            orders: tuple[Order, ...] = ()
            if not given and loop.now >= ordered_at:
                given, orders = True, (Order(OrderKind.GO, "entrance", issued_at=loop.now),)
            self.steps.append(loop.step(loop.inputs(*orders)))
        return self

    def texts(self, code: str) -> list[str]:
        return [e.text for step in self.steps for e in step.outputs.events if e.code == code]

    def unseen(self) -> list[PilotStep]:
        return [
            step
            for step in self.steps
            if any("people may be unseen" in words for words in step.outputs.warnings)
        ]

    def fastest(self, begin: float, end: float) -> float:
        return max(
            sum(v * v for v in step.outputs.estimate.velocity[:2]) ** 0.5
            for step in self.steps
            if begin <= step.now < end and step.outputs.estimate is not None
        )


@pytest.mark.slow
@pytest.mark.parametrize(
    ("fault", "words"),
    [
        ("laser:off@0s", "not heard yet"),
        ("depth:off@0s", "not heard yet"),
        ("laser:off@1s", "nothing usable for"),
        ("laser:stuck@1s", "nothing usable for"),
        ("laser:wrong@0s=0.5", "not heard yet"),
    ],
)
def test_where_a_sensor_for_people_is_silent_no_take_off_in_words(fault: str, words: str) -> None:
    told = Told().fly(site_with(fault, **SEEING), 3.5, ordered_at=3.0)
    (refused,) = told.texts("order_refused")
    assert refused.startswith("go entrance refused: people without markers are unseen")
    assert words in refused and "housefly sensors" in refused
    assert {step.outputs.phase for step in told.steps} == {Phase.IDLE}


@pytest.mark.slow
def test_scanners_that_fall_silent_in_flight_are_told_within_a_moment_and_it_flies_slowly() -> None:
    until = OFF_AT + BACK_AFTER + 2.0
    fine = Told().fly(site_with(**SEEING), until)
    told = Told().fly(site_with(f"laser:off@{OFF_AT:g}s+{BACK_AFTER:g}s", **SEEING), until)
    assert fine.texts("order_refused") == told.texts("order_refused") == []
    assert fine.unseen() == []
    unseen = told.unseen()
    assert PEOPLE_SILENCE_MAX - 0.1 < unseen[0].now - OFF_AT < 1.5
    assert {step.outputs.safety for step in unseen} == {SafetyMode.SLOW}
    assert "nothing usable for 1 s (limit 1 s): slowly" in unseen[0].outputs.reason
    assert 0.0 <= unseen[-1].now - (OFF_AT + BACK_AFTER) < 0.2
    assert told.steps[-1].outputs.safety is SafetyMode.NOMINAL
    begin, end = OFF_AT + 3.0, OFF_AT + BACK_AFTER
    assert told.fastest(begin, end) < 0.7 * fine.fastest(begin, end)
    before = [
        [step for step in flight.steps if step.now < unseen[0].now] for flight in (fine, told)
    ]
    assert [s.outputs for s in before[0]] == [s.outputs for s in before[1]]


@pytest.mark.slow
def test_without_sensors_it_takes_off_as_before_and_nothing_is_told_of_their_silence() -> None:
    told = Told().fly(site_with("laser:off@0s"), 8.0)
    assert told.texts("order_refused") == [] and told.unseen() == []
    assert {step.inputs.people_seen_at for step in told.steps} == {inf}
    assert told.steps[-1].outputs.phase is not Phase.IDLE


def test_a_slow_camera_may_take_its_time() -> None:
    assert longest_silence(inf) == longest_silence(10.0) == PEOPLE_SILENCE_MAX
    assert longest_silence(0.5) == 5.0


def sight(*, sees: bool = True) -> tuple[PeopleSight, SteppedClock]:
    clock = SteppedClock(10.0)
    return PeopleSight(site_with(**SEEING) if sees else site_with(), clock), clock


def test_the_shell_believes_the_newest_news_of_the_past_only() -> None:
    seen, clock = sight()
    assert seen.seen_at == -inf
    for news, known in ((-inf, -inf), (9.0, 9.0), (8.0, 9.0), (nan, 9.0), (inf, 9.0), (10.5, 9.0)):
        seen.heard(SightNews(news))
        assert seen.seen_at == known
    clock.advance(1.0)
    seen.heard(SightNews(10.5))
    assert seen.seen_at == 10.5


@given(st.lists(st.floats(), max_size=20))
def test_where_there_is_no_sensor_no_news_changes_that_and_none_comes_from_the_future(
    news: list[float],
) -> None:
    (blind, _), (seeing, _) = sight(sees=False), sight()
    for each in news:
        blind.heard(SightNews(each))
        seeing.heard(SightNews(each))
    assert blind.seen_at == inf and seeing.seen_at <= 10.05
