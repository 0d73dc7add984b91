"""Falls are told apart from lying: by where somebody lies, how they came there, and how long."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.hub.situations.bed import Beds
from housefly.hub.situations.fall import FAST_DESCENT, LONG_ON_FLOOR, SLOW_DESCENT, Falls
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.situations.layout import Area, Layout
from housefly.hub.situations.person import People
from housefly.hub.situations.person_tracks import PersonTracks
from housefly.messages import Observation, RoomEvent
from housefly.twin.people import Scene, scene_from_tree

if TYPE_CHECKING:
    from conftest import Watcher

SOFA, BED = Area("sofa seat", (5.0, 1.0), (0.6, 0.6)), Area("mattress", (8.0, 1.0), (2.0, 0.9))
LAYOUT = Layout(seats=(SOFA,), beds={"bed": BED})
FLOOR, ON_SOFA, IN_BED = (2.0, 1.0), (5.0, 1.0), (8.0, 1.0)


class Watched:
    """Somebody seen ten times a second by a source that measures the head, or the feet."""

    def __init__(self) -> None:
        self.tracks, self.beds = PersonTracks(), Beds(LAYOUT.beds)
        self.people = People(self.tracks, self.beds, LAYOUT)
        self.falls = Falls(self.tracks, self.beds, LAYOUT)
        self.told: list[RoomEvent] = []
        self.tick = 0

    @property
    def now(self) -> float:
        return self.tick / 10.0

    def see(self, seconds: float, place: tuple[float, float], **facts: float) -> None:
        for _ in range(round(seconds * 10)):
            told = (("kind", "person"), *facts.items())
            at = (*place, 0.0)
            self.tracks.add(Observation("ann", "camera", self.now, self.now, at, facts=told))
            self.told += [*self.people.update(self.now), *self.falls.update(self.now)]
            self.tick += 1

    def come_down(self, seconds: float, place: tuple[float, float]) -> None:
        """Lower the head from 1.6 m to 0.25 m within a time."""
        steps = max(1, round(seconds * 10))
        for n in range(1, steps + 1):
            self.see(0.1, place, head=1.6 + (0.25 - 1.6) * n / steps)

    def fallen(self) -> float:
        """Return the confidence in a fall, 0 when none is claimed."""
        return max((claim.confidence for claim in self.falls.active()), default=0.0)

    def lies_on(self) -> str:
        claims = [
            claim for claim in self.people.active() if claim.kind == SituationKind.PERSON_LYING
        ]
        return str(dict(claims[0].facts)["on"]) if claims else ""


def test_who_comes_down_fast_and_stays_on_the_floor_has_fallen() -> None:
    room = Watched()
    room.see(3.0, FLOOR, head=1.6)
    room.come_down(0.6, FLOOR)
    room.see(6.0, FLOOR, head=0.25)
    assert room.fallen() == pytest.approx(0.85)
    assert room.lies_on() == "floor"
    (begun,) = [event for event in room.told if event.kind == SituationKind.PERSON_FALLEN]
    assert "down within" in str(dict(begun.facts)["evidence"])
    assert begun.at == pytest.approx(3.5, abs=0.4)


def test_who_lies_down_slowly_on_the_floor_lies_there_and_has_not_fallen() -> None:
    room = Watched()
    room.see(3.0, FLOOR, head=1.6)
    room.come_down(12.0, FLOOR)
    room.see(20.0, FLOOR, head=0.25)
    assert (room.fallen(), room.lies_on()) == (0.0, "floor")
    room.see(LONG_ON_FLOOR, FLOOR, head=0.25)
    assert 0.5 <= room.fallen() < 0.6  # they may need help however they came there


@pytest.mark.parametrize(("place", "on"), [(ON_SOFA, "sofa seat"), (IN_BED, "mattress")])
def test_who_drops_onto_sofa_or_bed_has_not_fallen(place: tuple[float, float], on: str) -> None:
    room = Watched()
    room.see(3.0, place, head=1.6)
    room.come_down(0.6, place)
    room.see(400.0, place, head=0.45)
    assert (room.fallen(), room.lies_on()) == (0.0, on)
    assert SituationKind.PERSON_FALLEN not in {event.kind for event in room.told}


def test_who_lies_on_the_sofa_lies_and_who_sits_there_sits() -> None:
    room = Watched()
    room.see(5.0, ON_SOFA, head=1.2)
    assert {claim.kind for claim in room.people.active()} >= {SituationKind.PERSON_SITTING}
    room.see(5.0, ON_SOFA, head=0.55)
    assert room.lies_on() == "sofa seat"


def test_who_stumbles_and_gets_up_at_once_has_not_fallen() -> None:
    room = Watched()
    room.see(3.0, FLOOR, head=1.6)
    room.come_down(0.6, FLOOR)
    room.see(1.5, FLOOR, head=0.25)
    room.see(10.0, FLOOR, head=1.6)
    assert SituationKind.PERSON_FALLEN not in {event.kind for event in room.told}


def test_who_gets_up_again_ends_it() -> None:
    room = Watched()
    room.see(3.0, FLOOR, extent=0.35)
    room.see(10.0, FLOOR, extent=1.6)
    assert room.fallen() == pytest.approx(0.85)
    room.see(6.0, FLOOR, extent=0.35)
    assert room.fallen() == 0.0
    assert [event.kind for event in room.told if event.source.endswith("falls")] == [
        SituationKind.PERSON_FALLEN,
        SituationKind.PERSON_FALLEN + " ended",
    ]


def test_who_rolls_out_of_an_empty_bed_beside_it_lies_on_the_floor() -> None:
    room = Watched()
    room.beds.add(Observation("bed", "bed", 0.0, 0.0, facts=(("load", 0.0),)))
    room.see(1.0, IN_BED, head=0.6)
    room.see(6.0, (8.0, 1.9), head=0.25)
    assert room.lies_on() == "floor"
    assert room.fallen() == pytest.approx(0.5)  # nobody saw them upright: nobody knows how


def test_a_source_that_knows_no_height_does_not_get_anybody_up() -> None:
    room = Watched()
    room.see(3.0, FLOOR, head=1.6)
    room.come_down(0.6, FLOOR)
    for _ in range(100):
        room.see(0.1, FLOOR, head=0.25)
        near = (("kind", "person"),)
        sharp = (1e-6, 0.0, 0.0, 1e-6, 0.0, 1e-6)
        room.tracks.add(
            Observation(
                "ann", "laser", room.now, room.now, (*FLOOR, 0.0), covariance=sharp, facts=near
            )
        )
    assert room.fallen() == pytest.approx(0.85)


def test_a_flicker_of_the_measurement_is_no_second_fall() -> None:
    room = Watched()
    room.see(3.0, FLOOR, head=1.6)
    room.come_down(0.6, FLOOR)
    for _ in range(20):
        room.see(2.0, FLOOR, head=0.25)
        room.see(0.2, FLOOR, head=0.7)
    assert [event.kind for event in room.told if event.source.endswith("falls")] == [
        SituationKind.PERSON_FALLEN
    ]
    assert room.fallen() >= 0.85


@given(st.floats(0.1, 20.0), st.sampled_from([FLOOR, ON_SOFA, IN_BED]))
def test_only_the_floor_and_a_fast_descent_make_a_fall(
    descent: float, place: tuple[float, float]
) -> None:
    room = Watched()
    room.see(2.0, place, head=1.6)
    room.come_down(descent, place)
    room.see(8.0, place, head=0.25)
    # From 1.0 m (upright) to 0.5 m (on the floor) the head takes 0.37 of the way down.
    took = 0.5 / 1.35 * descent
    if place is not FLOOR or took > SLOW_DESCENT + 0.5:
        assert room.fallen() == 0.0
    elif took < FAST_DESCENT - 0.5:
        assert room.fallen() == pytest.approx(0.85)


def test_a_fall_in_the_simulated_room_is_told_and_going_to_bed_is_not(
    play: Callable[[Scene, float], list[tuple[float, Observation | RoomEvent]]],
    watching: Callable[[], Watcher],
) -> None:
    def scene(where: dict[str, object]) -> Scene:
        return scene_from_tree(
            {
                "name": "somebody lies down",
                "devices": [
                    {"kind": "floor", "id": "floor-1", "noise": 0.02},
                    {"kind": "bed", "id": "bed", "area": [9.3, 2.2, 11.4, 3.2]},
                ],
                "people": [
                    {
                        "name": "person-1",
                        "start": [9.9, 3.75],
                        "steps": [
                            {"do": "wait", "seconds": 6.0},
                            {"do": "lie", "seconds": 30.0, **where},
                        ],
                    }
                ],
            }
        )

    fell, slept = watching(), watching()
    fell.hear(play(scene({"at": [9.9, 4.3], "height": 0.0}), 30.0), 30.0)
    slept.hear(play(scene({"at": [10.35, 2.7], "height": 0.5}), 30.0), 30.0)
    (event,) = fell.named(SituationKind.PERSON_FALLEN)
    assert event.thing == "person-1" and event.confidence >= 0.8
    assert slept.named(SituationKind.PERSON_FALLEN) == []
    assert [e.thing for e in slept.named(SituationKind.PERSON_LYING)] == ["person-1"]
