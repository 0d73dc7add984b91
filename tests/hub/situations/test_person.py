"""Each person: there or not, walking, standing, sitting, lying."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.hub.situations.bed import Beds
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.situations.layout import Area, Layout
from housefly.hub.situations.person import People
from housefly.hub.situations.person_tracks import PersonTracks
from housefly.hub.situations.posture import RULES, PersonFeatures, rule_for
from housefly.messages import Observation, RoomEvent

SOFA, BED = Area("sofa seat", (5.0, 1.0), (0.6, 0.6)), Area("mattress", (8.0, 1.0), (2.0, 0.9))
LAYOUT = Layout(seats=(SOFA,), beds={"bed": BED})
PERSON = ("kind", "person")
AREAS = st.none() | st.just(SOFA)
LOOKS = st.builds(
    PersonFeatures, st.floats(0.0, 3.0), st.booleans(), st.none() | st.floats(0.0, 2.2),
    AREAS, st.none() | st.just(BED), st.none() | st.booleans(),
)  # fmt: skip


class Room:
    """Somebody watched four times a second."""

    def __init__(self, layout: Layout = LAYOUT) -> None:
        self.tracks, self.beds = PersonTracks(), Beds(layout.beds)
        self.people = People(self.tracks, self.beds, layout)
        self.told: list[RoomEvent] = []
        self.now = 0.0

    def look(self) -> None:
        self.told += [*self.beds.update(self.now), *self.people.update(self.now)]

    def see(
        self,
        seconds: float,
        x: float,
        y: float,
        vx: float = 0.0,
        head: float | None = None,
        person: str = "ann",
    ) -> None:
        """Let the floor see somebody ten times a second."""
        facts = (PERSON,) if head is None else (PERSON, ("head", head))
        for n in range(round(seconds * 10)):
            place = (x + vx * n / 10, y, 0.0)
            self.tracks.add(Observation(person, "floor", self.now, self.now, place, facts=facts))
            self.tracks.add(Observation("floor", "floor", self.now, self.now))
            self.look()
            self.now += 0.1

    def alone(self, seconds: float, speaks: bool = True, load: float | None = None) -> None:
        """Let nobody be seen."""
        for n in range(round(seconds * 10)):
            if speaks:
                self.tracks.add(Observation("floor", "floor", self.now, self.now))
            if load is not None and n % 20 == 0:
                self.beds.add(
                    Observation("bed", "bed", self.now, self.now, facts=(("load", load),))
                )
            self.look()
            self.now += 0.1

    def kinds(self) -> list[str]:
        return [event.kind for event in self.told]

    def active(self) -> set[str]:
        return {claim.kind for claim in self.people.active()}


@given(LOOKS)
def test_every_look_has_a_rule_and_walking_beats_sitting(looks: PersonFeatures) -> None:
    rule = rule_for(looks)
    assert 0.5 <= rule.confidence <= 1.0
    if looks.moves and looks.head is None:
        assert rule.kind == SituationKind.PERSON_WALKING
    if rule.kind == SituationKind.PERSON_SITTING:
        assert looks.seat is not None or looks.bed is not None


def test_every_rule_is_of_use() -> None:
    assert {rule.kind for rule in RULES} == {
        SituationKind.PERSON_WALKING,
        SituationKind.PERSON_STANDING,
        SituationKind.PERSON_SITTING,
        SituationKind.PERSON_LYING,
    }
    assert RULES[-1].fits(PersonFeatures(0.0, False, None, None, None, None))


@pytest.mark.parametrize(
    ("looks", "kind"),
    [
        (PersonFeatures(0.3, False, None, None, None, None), SituationKind.PERSON_STANDING),
        (PersonFeatures(0.3, True, None, None, None, None), SituationKind.PERSON_WALKING),
        (PersonFeatures(0.0, False, 1.2, SOFA, None, None), SituationKind.PERSON_SITTING),
        (PersonFeatures(0.0, False, 1.6, SOFA, None, None), SituationKind.PERSON_STANDING),
        (PersonFeatures(0.0, False, 0.2, None, None, None), SituationKind.PERSON_LYING),
        (PersonFeatures(0.0, False, 0.6, None, BED, True), SituationKind.PERSON_LYING),
        (PersonFeatures(0.0, False, 1.2, None, BED, True), SituationKind.PERSON_SITTING),
        (PersonFeatures(0.0, False, None, None, BED, None), SituationKind.PERSON_LYING),
        (PersonFeatures(0.0, False, None, None, BED, False), SituationKind.PERSON_STANDING),
        (PersonFeatures(0.0, False, 0.2, None, BED, False), SituationKind.PERSON_LYING),
        (PersonFeatures(0.0, False, 0.6, SOFA, None, None), SituationKind.PERSON_LYING),
        (PersonFeatures(0.0, False, None, None, None, None, 1.5), SituationKind.PERSON_LYING),
        (PersonFeatures(0.0, False, None, SOFA, None, None, 1.5), SituationKind.PERSON_SITTING),
        (PersonFeatures(0.0, False, None, None, None, None, 0.8), SituationKind.PERSON_STANDING),
    ],
)
def test_looks_are_judged_in_order_of_how_sure_they_are(looks: PersonFeatures, kind: str) -> None:
    assert rule_for(looks).kind == kind


def test_somebody_walks_stands_and_sits_down() -> None:
    room = Room()
    room.see(4.0, 0.0, 1.0, vx=0.9)
    assert room.active() == {"person present", SituationKind.PERSON_WALKING}
    room.see(4.0, 3.6, 1.0)
    assert room.active() == {"person present", SituationKind.PERSON_STANDING}
    room.see(5.0, 5.0, 1.0)
    assert room.active() == {"person present", SituationKind.PERSON_SITTING}
    claim = next(
        claim for claim in room.people.active() if claim.kind == SituationKind.PERSON_SITTING
    )
    facts = dict(claim.facts)
    assert (facts["on"], facts["x"], claim.thing) == (
        "sofa seat",
        5.0,
        "ann",
    ) and 8.0 < claim.since < 10.0
    ended = next(event for event in room.told if event.kind == "person walking ended")
    assert dict(ended.facts)["lasted"] == pytest.approx(4.0, abs=1.2)


def test_without_the_seat_the_same_person_stands() -> None:
    room = Room(Layout())
    room.see(6.0, 5.0, 1.0)
    assert room.active() == {"person present", SituationKind.PERSON_STANDING}


def test_one_reflection_is_nobody() -> None:
    room = Room()
    room.see(0.2, 1.0, 1.0)
    room.alone(10.0)
    assert room.told == []


def test_who_leaves_the_sight_of_a_floor_that_speaks_is_gone() -> None:
    room = Room()
    room.see(4.0, 1.0, 1.0)
    room.alone(3.0)
    assert room.active() == set()
    ended = next(event for event in room.told if event.kind == "person present ended")
    assert (
        ended.at == pytest.approx(3.9)
        and dict(ended.facts)["because"] == "floor: sees them no longer"
    )


def test_a_floor_that_falls_silent_says_nothing_of_people() -> None:
    room = Room()
    room.see(4.0, 1.0, 1.0)
    room.alone(2.8, speaks=False)
    presence = next(claim for claim in room.people.active() if claim.kind == "person present")
    assert 0.25 < presence.confidence < 0.95
    room.alone(3.0, speaks=False)
    ended = next(event for event in room.told if event.kind == "person present ended")
    assert room.active() == set() and dict(ended.facts)["because"] == "not known any more"


def lie_down(room: Room) -> None:
    room.alone(5.0, load=0.0)
    room.see(4.0, 8.0, 1.9)
    room.alone(20.0, load=61.0)


def test_who_vanishes_beside_a_bed_that_feels_somebody_lies_in_it_and_is_there() -> None:
    room = Room()
    lie_down(room)
    assert room.active() == {"person present", SituationKind.PERSON_LYING}
    assert "person present ended" not in room.kinds()
    room.alone(1.0, load=0.0)
    room.see(4.0, 8.0, 1.9)
    assert room.active() == {"person present", SituationKind.PERSON_STANDING}
    assert "person present ended" not in room.kinds()
    ended = next(event for event in room.told if event.kind == "person lying ended")
    assert dict(ended.facts)["because"] == "floor: stays where they are"


def test_without_the_load_of_the_bed_they_are_just_gone() -> None:
    room = Room()
    room.alone(5.0, load=0.0)
    room.see(4.0, 8.0, 1.9)
    room.alone(20.0, load=0.0)
    assert room.active() == set() and SituationKind.PERSON_LYING not in room.kinds()


def test_who_vanished_elsewhere_or_earlier_is_not_in_bed() -> None:
    for x, wait in ((2.0, 0.0), (8.0, 8.0)):
        room = Room()
        room.see(4.0, x, 1.9)
        room.alone(wait, load=0.0)
        room.alone(20.0, load=61.0)
        assert SituationKind.PERSON_LYING not in room.kinds()


def test_of_two_people_who_vanish_beside_a_bed_neither_is_named() -> None:
    room = Room()
    for _ in range(40):
        room.see(0.1, 8.0, 1.9)
        room.now -= 0.1
        room.see(0.1, 8.5, 1.9, person="bob")
    room.alone(20.0, load=61.0)
    assert SituationKind.PERSON_LYING not in room.kinds() and "bed occupied" in room.kinds()


def test_a_head_near_the_floor_is_somebody_who_lies_there() -> None:
    room = Room()
    room.see(4.0, 2.0, 2.0, head=1.6)
    room.see(4.0, 2.0, 2.0, head=0.2)
    assert room.active() == {"person present", SituationKind.PERSON_LYING}
