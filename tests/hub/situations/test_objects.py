"""Things: taken, put and missing."""

from __future__ import annotations

from dataclasses import replace

import pytest

from housefly.hub.situations.actor import ARM_REACH
from housefly.hub.situations.contents import ABSENT_AFTER, CONTAINER_HEARTBEAT
from housefly.hub.situations.layout import Layout
from housefly.hub.situations.objects import MISSING_AFTER, Objects
from housefly.hub.situations.person_tracks import PersonTracks
from housefly.hub.situations.resting import LEFT_ALONE
from housefly.messages import Observation, RoomEvent

LAYOUT = Layout(containers={"cabinet": (5.0, 1.0, 0.6)})
WITH_DRONE = replace(LAYOUT, robots=frozenset({"drone"}))
PERSON = (("kind", "person"),)


class Room:
    """A cabinet, a cup and people, watched four times a second; the cabinet says its contents every
    ten seconds.
    """

    def __init__(self, layout: Layout = LAYOUT) -> None:
        self.tracks = PersonTracks()
        self.objects = Objects(self.tracks, layout)
        self.told: list[RoomEvent] = []
        self.now = 0.0
        self.inside = {"cabinet": {"cup", "book"}}
        self.silent: set[str] = set()

    def say(self, container: str = "cabinet") -> None:
        """Let a container say its contents."""
        named = ",".join(sorted(self.inside[container]))
        self.hear(
            Observation(container, container, self.now, self.now, facts=(("contents", named),))
        )

    def report(self, kind: str, thing: str = "cup", container: str = "cabinet") -> None:
        """Let a container report a move."""
        self.hear(RoomEvent(kind, thing, self.now, container, facts=(("weight", 0.2),)))

    def see(self, thing: str, x: float, y: float, z: float = 0.5) -> None:
        """Let the tracking system see a thing."""
        self.hear(Observation(thing, "vicon", self.now, self.now, (x, y, z)))

    def hear(self, item: Observation | RoomEvent) -> None:
        self.tracks.add(item)
        self.objects.add(item)

    def wait(
        self,
        seconds: float,
        *at: tuple[str, float, float],
        things: tuple[tuple[str, float, float], ...] = (),
    ) -> None:
        """Let time pass in which people and things are seen at (id, x, y)."""
        for _ in range(round(seconds * 4)):
            self.now += 0.25
            for person, x, y in at:
                self.hear(
                    Observation(person, "floor", self.now, self.now, (x, y, 0.0), facts=PERSON)
                )
            for thing, x, y in things:
                self.see(thing, x, y)
            for container in set(self.inside) - self.silent:
                if self.now % 10.0 == 0.0:
                    self.say(container)
            self.told += self.objects.update(self.now)

    def kinds(self) -> list[str]:
        return [event.kind for event in self.told]


def room_with_contents(layout: Layout = LAYOUT) -> Room:
    room = Room(layout)
    room.say()
    room.wait(20.0)
    return room


def test_what_a_cabinet_holds_at_first_was_not_put_there() -> None:
    assert room_with_contents().told == []


def test_a_reported_taking_is_told_once_with_who_and_from_where() -> None:
    room = room_with_contents()
    room.wait(5.0, ("ann", 5.4, 1.0), ("bob", 9.0, 1.0))
    room.inside["cabinet"].discard("cup")
    room.report("object taken")
    room.say()
    room.wait(30.0, ("ann", 5.4, 1.0), ("bob", 9.0, 1.0))
    (taken,) = room.told
    assert (taken.kind, taken.thing, taken.at, taken.cause, taken.confidence) == (
        "object taken",
        "cup",
        25.0,
        "ann",
        0.95,
    )
    facts = dict(taken.facts)
    assert (facts["from"], facts["weight"], facts["by_confidence"]) == ("cabinet", 0.2, 1.0)
    assert facts["by_distance"] == pytest.approx(0.4) and facts["evidence"] == "cabinet: reports it"


def test_contents_alone_tell_it_too_with_less_confidence() -> None:
    room = room_with_contents()
    room.wait(5.0, ("ann", 5.4, 1.0))
    room.inside["cabinet"].discard("cup")
    room.say()
    room.wait(2.0, ("ann", 9.0, 1.0))
    (taken,) = room.told
    assert (taken.kind, taken.at, taken.cause, taken.confidence) == (
        "object taken",
        25.0,
        "ann",
        0.85,
    )
    room.inside["cabinet"].add("cup")
    room.say()
    room.wait(1.0)
    assert room.kinds() == ["object taken", "object put"]


def test_a_tag_that_blinks_was_not_taken() -> None:
    room = room_with_contents()
    for _ in range(20):
        room.inside["cabinet"].discard("cup")
        room.say()
        room.wait(ABSENT_AFTER - 0.5)
        room.inside["cabinet"].add("cup")
        room.say()
        room.wait(3.0)
    assert room.told == []


def test_contents_that_lag_behind_a_report_are_not_believed() -> None:
    room = room_with_contents()
    room.report("object taken")
    room.wait(1.0)
    room.say()
    room.wait(0.5)
    room.inside["cabinet"].discard("cup")
    room.wait(30.0)
    assert room.kinds() == ["object taken"]


def test_nobody_in_reach_is_nobody_named_and_two_as_near_are_candidates() -> None:
    room = room_with_contents()
    room.wait(5.0, ("ann", 5.0 + ARM_REACH + 0.1, 1.0))
    room.report("object taken")
    room.wait(1.0, ("ann", 5.0 + ARM_REACH + 0.1, 1.0))
    room.wait(5.0, ("ann", 5.4, 1.0), ("bob", 4.5, 1.0))
    room.report("object put")
    room.wait(5.0)
    taken, put = room.told
    assert taken.cause == put.cause == ""
    assert dict(put.facts)["candidates"] == "ann,bob"


def test_who_carries_a_thing_puts_it_down_although_another_is_nearer() -> None:
    room = room_with_contents()
    room.wait(5.0, ("ann", 5.4, 1.0))
    room.report("object taken")
    room.wait(1.0, ("ann", 5.4, 1.0))
    room.wait(5.0, ("ann", 5.8, 1.0), ("bob", 4.5, 1.0))
    room.report("object put")
    room.wait(5.0)
    assert [event.cause for event in room.told] == ["ann", "ann"]


def test_without_the_place_of_the_cabinet_nobody_is_named() -> None:
    room = room_with_contents(Layout())
    room.wait(5.0, ("ann", 5.4, 1.0))
    room.inside["cabinet"].discard("cup")
    room.report("object taken")
    room.wait(5.0)
    assert [event.cause for event in room.told] == [""]


def test_a_cabinet_that_was_silent_meanwhile_tells_no_time_and_no_name() -> None:
    room = room_with_contents()
    room.silent = {"cabinet"}
    room.wait(5 * CONTAINER_HEARTBEAT, ("ann", 5.4, 1.0))
    room.inside["cabinet"].discard("cup")
    room.silent = set()
    room.wait(20.0, ("ann", 5.4, 1.0))
    (taken,) = room.told
    assert (taken.cause, taken.confidence) == ("", 0.6) and "after a silence" in str(
        dict(taken.facts)["evidence"]
    )


def test_a_thing_in_no_container_for_five_minutes_is_missing_until_it_is_put() -> None:
    room = room_with_contents()
    room.wait(5.0, ("ann", 5.4, 1.0))
    room.inside["cabinet"].discard("cup")
    room.report("object taken")
    room.wait(MISSING_AFTER - 1.0)
    assert room.objects.active() == ()
    room.wait(5.0)
    (claim,) = room.objects.active()
    assert (claim.kind, claim.thing, claim.since) == ("object missing", "cup", 25.0 + MISSING_AFTER)
    assert dict(claim.facts)["taken_by"] == "ann"
    room.inside["cabinet"].add("cup")
    room.report("object put")
    room.wait(1.0)
    assert room.kinds() == ["object taken", "object missing", "object put", "object missing ended"]


def test_what_a_source_sees_is_not_missing() -> None:
    room = room_with_contents()
    room.inside["cabinet"].discard("cup")
    room.report("object taken")
    room.wait(2 * MISSING_AFTER, things=(("cup", 8.0, 1.0),))
    assert room.objects.active() == ()


def test_nothing_is_missing_while_a_container_that_may_hold_it_is_silent() -> None:
    for silent_from_the_start in (True, False):
        places = {"cabinet": (5.0, 1.0, 0.6), "fridge": (1.0, 1.0, 0.6)}
        room = Room(Layout(containers=places))
        room.say()
        if not silent_from_the_start:
            room.inside["fridge"] = set()
            room.wait(20.0)
            room.silent = {"fridge"}
        room.inside["cabinet"].discard("cup")
        room.report("object taken")
        room.wait(2 * MISSING_AFTER)
        assert room.kinds() == ["object taken"]


def test_what_moves_from_one_container_to_another_is_not_missing() -> None:
    room = room_with_contents()
    room.inside["fridge"] = set()
    room.say("fridge")
    room.inside["cabinet"].discard("cup")
    room.say()
    room.wait(1.0)
    room.inside["fridge"].add("cup")
    room.report("object put", container="fridge")
    room.wait(2 * MISSING_AFTER)
    assert sorted(room.kinds()) == ["object put", "object taken"]


def test_a_thing_seen_on_a_table_is_taken_carried_and_left_elsewhere() -> None:
    room = Room(Layout())
    room.inside = {}
    room.wait(5.0, things=(("cup", 2.0, 1.0),))
    assert room.told == []
    room.wait(3.0, ("ann", 2.3, 1.0), things=(("cup", 2.0, 1.0),))
    for step in range(12):
        room.wait(0.25, ("ann", 2.3 + step / 4, 1.0), things=(("cup", 2.0 + step / 4, 1.0),))
    room.wait(9.0, ("ann", 5.2, 1.0), things=(("cup", 4.75, 1.0),))
    assert room.kinds() == ["object taken"]
    room.wait(4.0, ("ann", 7.0, 1.0), things=(("cup", 4.75, 1.0),))
    taken, put = room.told
    assert (taken.kind, taken.cause, dict(taken.facts)["x"]) == ("object taken", "ann", 2.0)
    assert (put.kind, put.cause, dict(put.facts)["x"]) == ("object put", "ann", 4.75)


def test_a_drone_that_flies_and_lands_was_neither_taken_nor_put() -> None:
    for layout, kinds in ((LAYOUT, ["object taken", "object put"]), (WITH_DRONE, [])):
        room = room_with_contents(layout)
        for x in (2.0, 4.0, 6.0):
            room.wait(10.0, things=(("drone", x, 1.0),))
        assert room.kinds()[:2] == kinds


def test_one_wrong_position_is_no_move() -> None:
    room = Room(Layout())
    room.inside = {}
    for _ in range(20):
        room.wait(5.0, things=(("cup", 2.0, 1.0),))
        room.wait(0.25, things=(("cup", 6.0, 1.0),))
    assert room.told == []


def test_a_thing_taken_from_a_cabinet_and_left_in_sight_is_put_there() -> None:
    room = room_with_contents()
    room.wait(5.0, ("ann", 5.4, 1.0))
    room.inside["cabinet"].discard("cup")
    room.report("object taken")
    room.wait(9.0, ("ann", 9.4, 1.0), things=(("cup", 7.0, 1.0),))
    taken, put = room.told
    assert (taken.kind, put.kind, dict(put.facts)["x"]) == ("object taken", "object put", 7.0)


def carried_off() -> Room:
    """Return a room in which Ann carried a cup from its place, out of sight."""
    room = Room(Layout())
    room.inside = {}
    room.wait(5.0, ("ann", 2.3, 1.0), things=(("cup", 2.0, 1.0),))
    room.wait(30.0, ("ann", 2.3, 1.0), things=(("cup", 2.0, 1.0),))
    room.wait(2.0, ("ann", 4.3, 1.0), things=(("cup", 4.0, 1.0),))
    return room


def test_what_vanishes_from_a_live_source_is_missing_and_from_a_silent_one_unknown() -> None:
    room = carried_off()
    room.wait(MISSING_AFTER + 5.0, things=(("book", 9.0, 1.0),))
    assert room.kinds() == ["object taken", "object missing"]
    room = carried_off()
    room.wait(MISSING_AFTER + 5.0)
    assert room.kinds() == ["object taken"]


def test_a_thing_that_rests_beside_somebody_for_long_is_not_in_their_hand() -> None:
    room = carried_off()
    room.wait(LEFT_ALONE - 2.0, ("ann", 4.3, 1.0), things=(("cup", 4.0, 1.0),))
    assert room.kinds() == ["object taken"]
    room.wait(5.0, ("ann", 4.3, 1.0), things=(("cup", 4.0, 1.0),))
    assert room.kinds() == ["object taken", "object put"]


def test_positions_of_a_thing_inside_a_container_are_not_believed() -> None:
    room = room_with_contents()
    for step in range(20):
        room.wait(5.0, things=(("cup", 5.0 + step, 1.0),))
    assert room.told == []


def test_the_farther_a_second_person_the_surer_the_first() -> None:
    shares = []
    for second in (5.8, 6.1):
        room = room_with_contents()
        room.wait(5.0, ("ann", 4.7, 1.0), ("bob", second, 1.0))
        room.report("object taken")
        room.wait(1.0)
        assert room.told[0].cause == "ann"
        shares.append(dict(room.told[0].facts)["by_confidence"])
    assert shares == pytest.approx([0.8 / 1.1, 1.1 / 1.4])
