"""Someone is at the entrance."""

from __future__ import annotations

import pytest

from housefly.hub.situations.confidence import CLAIM_THRESHOLD
from housefly.hub.situations.entrance import (
    BELL_CONFIDENCE,
    BELL_HEARTBEAT,
    MOTION_CONFIDENCE,
    Entrance,
)
from housefly.hub.situations.layout import Area, Layout
from housefly.hub.situations.person_tracks import PersonTracks
from housefly.messages import Observation, RoomEvent

LAYOUT = Layout(
    entrance=Area("entrance", (1.0, 4.0), (1.5, 1.5)),
    bells=frozenset({"bell"}),
    motion=frozenset({"corridor"}),
)


class Door:
    """An entrance watched four times a second."""

    def __init__(self, layout: Layout = LAYOUT) -> None:
        self.tracks = PersonTracks()
        self.entrance = Entrance(self.tracks, layout)
        self.told: list[RoomEvent] = []
        self.now = 0.0

    def wait(
        self,
        seconds: float,
        *at: tuple[str, float, float],
        speaks: bool = False,
        motion: bool = False,
    ) -> None:
        """Let time pass in which people are seen at (id, x, y), and the motion sensor says what it
        sees.
        """
        for _ in range(round(seconds * 4)):
            self.now += 0.25
            for person, x, y in at:
                seen = Observation(
                    person, "laser", self.now, self.now, (x, y, 0.0), facts=(("kind", "person"),)
                )
                self.tracks.add(seen)
            if speaks:
                self.tracks.add(Observation("laser", "laser", self.now, self.now))
            if motion:
                self.entrance.add(
                    Observation(
                        "corridor", "corridor", self.now, self.now, facts=(("motion", True),)
                    )
                )
            self.told += self.entrance.update(self.now)

    def ring(self, source: str = "bell") -> None:
        self.entrance.add(RoomEvent("bell pressed", source, self.now, source))

    def kinds(self) -> list[str]:
        return [event.kind for event in self.told]


SOMEONE, NO_ONE = "someone at the entrance", "someone at the entrance ended"


def test_whoever_rings_is_believed_to_wait_for_a_while() -> None:
    door = Door()
    door.ring()
    door.wait(1.0)
    (begun,) = door.told
    assert (begun.kind, begun.thing, begun.at, begun.confidence) == (
        SOMEONE,
        "entrance",
        0.0,
        BELL_CONFIDENCE,
    )
    assert dict(begun.facts)["evidence"] == "bell: rang"
    door.wait(2 * BELL_HEARTBEAT)
    assert door.entrance.active()[0].confidence < BELL_CONFIDENCE
    door.wait(2 * BELL_HEARTBEAT)
    assert door.kinds() == [SOMEONE, NO_ONE]
    assert dict(door.told[1].facts)["because"] == "not known any more"


def test_the_bell_of_another_door_says_nothing_of_this_one() -> None:
    door = Door()
    door.ring("back-bell")
    door.wait(5.0)
    assert door.told == []


def test_motion_alone_is_never_claimed() -> None:
    door = Door()
    door.wait(100.0, motion=True)
    assert door.told == [] and MOTION_CONFIDENCE < CLAIM_THRESHOLD


def test_motion_makes_the_bell_surer() -> None:
    door = Door()
    door.wait(3.0, motion=True)
    door.ring()
    door.wait(1.0, motion=True)
    assert door.told[0].confidence == pytest.approx(
        1 - (1 - BELL_CONFIDENCE) * (1 - MOTION_CONFIDENCE)
    )


def test_who_stays_before_the_door_is_named_and_who_leaves_ends_it() -> None:
    door = Door()
    door.wait(4.0, ("guest", 1.2, 4.1))
    (begun,) = door.told
    assert (begun.kind, begun.cause) == (SOMEONE, "guest") and begun.at < 1.0
    door.wait(4.0, ("guest", 4.0, 4.1))
    assert door.kinds() == [SOMEONE, NO_ONE]
    assert dict(door.told[1].facts)["because"] == "who stood there is gone"


def test_who_goes_out_of_the_sight_of_a_laser_that_speaks_is_gone() -> None:
    door = Door()
    door.wait(4.0, ("guest", 1.2, 4.1))
    door.wait(8.0, speaks=True)
    assert dict(door.told[1].facts)["because"] == "who stood there is gone"


def test_a_laser_that_falls_silent_does_not_say_that_they_left() -> None:
    door = Door()
    door.wait(4.0, ("guest", 1.2, 4.1))
    door.wait(8.0)
    assert (
        dict(door.told[1].facts)["because"] == "not known any more" and door.entrance.active() == ()
    )


def test_who_passes_by_is_nobody_and_who_stands_elsewhere_neither() -> None:
    door = Door()
    door.wait(1.0, ("guest", 1.0, 4.0))
    door.wait(9.0, ("guest", 3.0, 4.0))
    assert door.told == []


def test_without_a_rectangle_bells_or_sensors_nothing_is_claimed() -> None:
    door = Door(Layout())
    door.ring()
    door.wait(9.0, ("guest", 1.0, 4.0), motion=True)
    assert door.told == []


def test_who_stands_on_the_edge_of_the_rectangle_stays_at_the_entrance() -> None:
    door = Door()
    for _ in range(30):
        door.wait(0.5, ("guest", 1.7, 4.0))
        door.wait(0.5, ("guest", 1.8, 4.0))
    assert door.kinds() == [SOMEONE]
