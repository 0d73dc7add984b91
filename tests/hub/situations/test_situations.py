"""All detectors over whole streams: the afternoon in B-sen, played in lock step, and streams that
nobody planned.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.hub.nights import night_of, stays_of
from housefly.hub.situations import Layout, Situations
from housefly.hub.situations.kinds import BEGUN_BY, SituationKind
from housefly.hub.situations.reorder_buffer import REORDER_DELAY
from housefly.hub.situations.situation import SOURCE_PREFIX
from housefly.hub.state_handler import in_order
from housefly.messages import Observation, RoomEvent
from housefly.twin.people import Act, Posture, Scene, load_scene, scene_from_tree

if TYPE_CHECKING:
    from conftest import Watcher

UNIX = 1_800_000_000.0
Item = Observation | RoomEvent
Heard = Sequence[tuple[float, Item]]
Play = Callable[[Scene, float], list[tuple[float, Item]]]
BSEN = load_scene("bsen")
ROUNDS = 2.0


@pytest.fixture(scope="module")
def afternoon(play: Play, watching: Callable[[], Watcher]) -> Watcher:
    """Return what was told and held over two rounds of the shipped scene."""
    watcher = watching()
    watcher.hear(play(BSEN, ROUNDS * BSEN.length), ROUNDS * BSEN.length)
    return watcher


def acts(act: Act, what: str = "", seconds: float = ROUNDS * BSEN.length) -> list[float]:
    return [
        told.at
        for told in BSEN.between(-1.0, seconds - 2.0)
        if told.act is act and what in ("", told.what)
    ]


def times(told: Iterable[RoomEvent]) -> list[float]:
    return [event.at - UNIX for event in told]


def test_the_cup_is_taken_from_the_cabinet_and_put_back_by_person_1(afternoon: Watcher) -> None:
    taken = [told for told in afternoon.named("object taken") if told.thing == "cup"]
    put = [told for told in afternoon.named("object put") if told.thing == "cup"]
    assert {(told.cause, dict(told.facts)["from"]) for told in taken} == {("person-1", "cabinet")}
    assert {(told.cause, dict(told.facts)["into"]) for told in put} == {("person-1", "cabinet")}
    assert times(taken) == pytest.approx(acts(Act.TAKE, "cup")[::2], abs=0.1)
    assert times(put) == pytest.approx(acts(Act.PUT, "cup")[1::2], abs=0.1)


def test_tea_is_taken_from_the_refrigerator_which_is_not_open_too_long(afternoon: Watcher) -> None:
    taken = [told for told in afternoon.named("object taken") if told.thing == "tea-bottle"]
    assert {(told.cause, dict(told.facts)["from"]) for told in taken} == {
        ("person-1", "refrigerator")
    }
    assert times(taken) == pytest.approx(acts(Act.TAKE, "tea-bottle"), abs=0.1)
    assert afternoon.held("door open too long") == [] and afternoon.held("object missing") == []


def test_someone_is_at_the_entrance_from_the_bell_on_within_a_second(afternoon: Watcher) -> None:
    told = afternoon.named("someone at the entrance")
    assert len(told) == 2 and all(event.confidence >= 0.9 for event in told)
    for rung, event in zip(acts(Act.PRESS), told, strict=True):
        assert event.at - UNIX == pytest.approx(rung, abs=0.3)
        assert float(dict(event.facts)["noticed_at"]) - UNIX + REORDER_DELAY <= rung + 1.0
    before = [
        second
        for second in afternoon.held("someone at the entrance")
        if second < acts(Act.PRESS)[0]
    ]
    assert before == []


def test_the_bed_is_occupied_while_somebody_lies_in_it_and_the_second_time_it_is_known_who(
    afternoon: Watcher,
) -> None:
    begun = times(afternoon.named("bed occupied"))
    assert begun == pytest.approx([0.0, BSEN.length], abs=0.2)
    (lying,) = afternoon.named("person lying")
    assert lying.thing == "person-1" and lying.at - UNIX == pytest.approx(BSEN.length, abs=0.2)
    assert dict(lying.facts)["on"] == "bed"


def test_who_sits_is_known_and_on_what(afternoon: Watcher) -> None:
    seats = {(told.thing, dict(told.facts)["on"]) for told in afternoon.named("person sitting")}
    assert seats == {("person-1", "sofa seat 0"), ("person-2", "meeting chair north seat")}


def test_what_is_claimed_of_people_is_what_they_do(afternoon: Watcher) -> None:
    words = {
        Posture.STANDING: "person standing",
        Posture.WALKING: "person walking",
        Posture.SITTING: "person sitting",
    }
    looks = 0
    for tenth in range(40, round(ROUNDS * BSEN.length * 10), 2):
        claims = {
            claim.thing: claim.kind
            for claim in afternoon.holds[tenth]
            if claim.kind in words.values()
        }
        past = [BSEN.at(tenth / 10 - back / 10) for back in range(0, 36, 2)]
        for number, person in enumerate(past[0].people):
            postures = {state.people[number].posture for state in past}
            seen = all(state.people[number].position[0] > 5.0 for state in past)
            if seen and len(postures) == 1 and person.posture in words:
                looks += 1
                assert claims.get(person.name) == words[person.posture], (tenth / 10, person)
    assert looks > 1000


def test_nobody_else_is_claimed_and_nothing_was_refused(afternoon: Watcher) -> None:
    assert {told.thing for told in afternoon.told if told.kind.startswith("person")} == {
        "person-1",
        "person-2",
    }
    assert afternoon.situations.counts == {}


def check(told: Sequence[RoomEvent]) -> None:
    """Assert the invariants: ends follow beginnings, confidences are valid, sources are ours."""
    open_: set[tuple[str, str]] = set()
    for event in told:
        assert 0.0 <= event.confidence <= 1.0 and event.source.startswith(SOURCE_PREFIX)
        key = BEGUN_BY.get(event.kind, event.kind), event.thing
        if event.kind in BEGUN_BY:
            assert key in open_
            open_.discard(key)
        elif not event.kind.startswith(("object taken", "object put")):
            assert key not in open_
            open_.add(key)


def test_every_beginning_has_at_most_one_end(afternoon: Watcher) -> None:
    check(afternoon.told)


@pytest.mark.parametrize(
    ("without", "kinds"),
    [
        (
            "floor-1",
            (
                "person present",
                "person walking",
                "person sitting",
                "person standing",
                "person lying",
            ),
        ),
        ("doorbell", ("someone at the entrance",)),
        ("bed", ("bed occupied", "person lying")),
        ("cabinet", ()),
    ],
)
def test_without_its_source_a_situation_is_never_claimed(
    without: str, kinds: tuple[str, ...], play: Play, watcher: Watcher, afternoon: Watcher
) -> None:
    watcher.hear([row for row in play(BSEN, 150.0) if row[1].source != without], 150.0)
    for kind in kinds:
        assert afternoon.named(kind) and not watcher.named(kind)
    check(watcher.told)
    if without == "cabinet":
        assert {told.thing for told in watcher.told if told.kind.startswith("object")} == {
            "tea-bottle"
        }


def test_without_the_floor_a_taking_names_nobody(play: Play, watcher: Watcher) -> None:
    watcher.hear([row for row in play(BSEN, 40.0) if row[1].source != "floor-1"], 40.0)
    assert [told.cause for told in watcher.named("object taken")] == ["", ""]


QUIET: dict[str, Any] = {
    "name": "quiet",
    "people": [
        {
            "name": "ann",
            "start": [5.7, 3.0],
            "steps": [{"do": "sit", "at": [5.70, 2.28], "seat": 0.45, "seconds": 3600}],
        },
        {"name": "bob", "start": [8.0, 3.0], "steps": [{"do": "wait", "seconds": 3600}]},
    ],
    "things": [{"name": "cup", "tag": "t1", "inside": "cabinet"}],
    "devices": [
        {"kind": "floor", "id": "floor-1", "noise": 0.03},
        {"kind": "bed", "id": "bed", "area": [9.3, 2.2, 11.4, 3.2], "noise": 0.5},
        *({"kind": kind, "id": kind} for kind in ("cabinet", "refrigerator", "door", "doorbell")),
        {"kind": "motion", "id": "corridor-motion", "area": [0.1, 3.3, 4.8, 5.1]},
    ],
}


@pytest.mark.parametrize("minutes", [5, pytest.param(60, marks=pytest.mark.safety)])
def test_an_hour_in_which_nothing_happens_gives_no_false_alarm(
    play: Play, watcher: Watcher, minutes: int
) -> None:
    watcher.hear(play(scene_from_tree(QUIET), 60.0 * minutes), 60.0 * minutes)
    said = sorted((told.kind, told.thing) for told in watcher.told)
    assert said == [
        ("person present", "ann"),
        ("person present", "bob"),
        ("person sitting", "ann"),
        ("person standing", "bob"),
    ]


def test_a_refrigerator_that_stays_open_is_told(play: Play, watcher: Watcher) -> None:
    wait, handle = {"do": "wait", "seconds": 5}, {"what": "refrigerator"}
    steps = [wait, {"do": "open", **handle}, {**wait, "seconds": 60}, {"do": "close", **handle}]
    forgetful = {"name": "ann", "start": [7.2, 4.9], "steps": steps}
    watcher.hear(play(scene_from_tree({**QUIET, "people": [forgetful]}), 80.0), 80.0)
    kind = SituationKind.DOOR_OPEN_LONG
    begun, ended = watcher.named(kind), watcher.named(kind.ended)
    assert times(begun) == pytest.approx([35.4], abs=0.1) and times(ended) == pytest.approx(
        [65.8], abs=0.1
    )


PEOPLE, PLACES = (
    ("ann", "bob"),
    st.tuples(st.floats(4.0, 14.0), st.floats(0.0, 6.0), st.floats(0.0, 2.0)),
)
CHOICES = st.one_of(
    st.builds(
        lambda who, at: ("floor-1", who, at, (("kind", "person"),)),
        st.sampled_from(PEOPLE), PLACES,
    ),
    st.builds(
        lambda who, at: ("laser", who, at, (("kind", "person"), ("head", at[2]))),
        st.sampled_from(PEOPLE), PLACES,
    ),
    st.builds(lambda at: ("vicon", "cup", at, ()), PLACES),
    st.builds(lambda load: ("bed", "bed", None, (("load", load),)), st.floats(-5.0, 200.0)),
    st.builds(lambda on: ("refrigerator", "refrigerator", None, (("open", on),)), st.booleans()),
    st.builds(
        lambda named: ("cabinet", "cabinet", None, (("contents", named),)),
        st.sampled_from(["", "cup", "book,cup"]),
    ),
    st.builds(
        lambda on: ("corridor-motion", "corridor-motion", None, (("motion", on),)),
        st.booleans(),
    ),
    st.builds(
        lambda kind, thing, source: (kind, thing, source),
        st.sampled_from(["object taken", "object put", "bell pressed", "door opened", "nonsense"]),
        st.sampled_from(["cup", "doorbell"]),
        st.sampled_from(["cabinet", "doorbell", "refrigerator"]),
    ),
)  # fmt: skip


def item_of(choice: tuple[Any, ...], at: float) -> Item:
    if len(choice) == 3:
        return RoomEvent(choice[0], choice[1], at, choice[2])
    source, thing, place, facts = choice
    return Observation(thing, source, at, at, place, facts=facts)


STREAMS = st.lists(
    st.tuples(st.integers(0, 600).map(lambda n: n / 10), CHOICES), min_size=20, max_size=120
).map(
    lambda rows: [
        (at, item_of(choice, UNIX + at)) for at, choice in sorted(rows, key=lambda row: row[0])
    ]
)


def heard(layout: Layout, rows: Heard, period: float, until: float = 62.0) -> list[RoomEvent]:
    """Return what is told of a stream whose items come at (time, item), by calls of this period
    [s].
    """
    situations, index = Situations(layout), 0
    told: list[RoomEvent] = []
    rows = sorted(rows, key=lambda row: row[0])
    for now in (n * period for n in range(round(until / period) + 1)):
        due = index
        while due < len(rows) and rows[due][0] <= now:
            due += 1
        told += situations.update([item for _, item in rows[index:due]], UNIX + now)
        index = due
        assert all(0.0 <= claim.confidence <= 1.0 for claim in situations.active())
    return told


@settings(max_examples=30)
@given(rows=STREAMS)
def test_whatever_comes_ends_follow_beginnings_and_a_replay_says_the_same(
    layout: Layout, rows: Heard
) -> None:
    told = heard(layout, rows, 0.1)
    check(told)
    assert heard(layout, rows, 0.1) == told


@settings(max_examples=20)
@given(rows=STREAMS, chance=st.randoms())
def test_neither_delay_within_patience_nor_order_nor_doubles_nor_the_rate_of_calls_matter(
    layout: Layout, rows: Heard, chance: random.Random
) -> None:
    told = heard(layout, rows, 0.1)
    messy = [
        (at + chance.uniform(0.0, REORDER_DELAY - 0.1), item)
        for at, item in rows
        for _ in range(chance.choice((1, 2)))
    ]
    chance.shuffle(messy)
    assert heard(layout, messy, 0.1) == told
    assert heard(layout, rows, 0.4) == told


def test_the_afternoon_heard_late_doubled_and_out_of_order_is_the_same_afternoon(
    layout: Layout, play: Play
) -> None:
    chance, rows = random.Random(5), play(BSEN, 130.0)
    messy = [
        (at + chance.uniform(0.0, REORDER_DELAY - 0.1), item)
        for at, item in rows
        for _ in range(chance.choice((1, 2)))
    ]
    told = heard(layout, rows, 0.1, 131.0)
    assert heard(layout, messy, 0.1, 131.0) == heard(layout, rows, 0.35, 131.0)[: len(told)] == told
    assert len(told) > 20


@given(st.lists(st.floats(0.0, 100.0), max_size=20))
def test_nothing_happens_out_of_nothing(waits: list[float]) -> None:
    situations, now = (
        Situations(Layout(bells=frozenset({"doorbell"}), beds={}, entrance=None)),
        UNIX,
    )
    for wait in waits:
        now += wait
        assert situations.update((), now) == () and situations.active() == ()


@given(
    st.lists(
        st.tuples(st.sampled_from(["oven", "lamp", "cup"]), st.floats(0.0, 50.0), st.booleans()),
        max_size=40,
    )
)
def test_what_no_detector_knows_is_nothing(rows: list[tuple[str, float, bool]]) -> None:
    stream = [
        (at, Observation(thing, "hall", UNIX + at, UNIX + at, facts=(("on", flag), ("load", at))))
        for thing, at, flag in rows
    ]
    assert heard(Layout(), stream, 0.5) == []


def test_our_own_events_are_not_heard_again(layout: Layout) -> None:
    taken = RoomEvent("object taken", "cup", UNIX + 1.0, "cabinet")
    assert len(heard(layout, [(1.0, taken)], 0.5)) == 1
    assert heard(layout, [(1.0, replace(taken, source=SOURCE_PREFIX + "objects"))], 0.5) == []


def test_a_clock_that_runs_backwards_or_leaps_a_week_does_no_harm(layout: Layout) -> None:
    situations = Situations(layout)
    situations.update((), UNIX)
    assert situations.update((), UNIX - 50.0) == ()
    rung = RoomEvent("bell pressed", "doorbell", UNIX + 2.0, "doorbell")
    (begun,) = situations.update([rung], UNIX + 3.0)
    assert begun.kind == "someone at the entrance"
    (ended,) = situations.update((), UNIX + 7 * 86_400.0)
    assert ended.kind == "someone at the entrance ended" and situations.active() == ()


def test_what_is_on_and_open_is_told_from_when_it_is_so(afternoon: Watcher) -> None:
    begun, ended = afternoon.named("appliance on"), afternoon.named("appliance on ended")
    assert {told.thing for told in begun} == {"stove"}
    assert times(begun) == pytest.approx(acts(Act.ON), abs=0.3)
    assert times(ended) == pytest.approx(acts(Act.OFF), abs=0.3)
    assert afternoon.named("contact open") == [] and afternoon.named("person fallen") == []


def test_who_got_up_once_at_night_was_up_once(play: Play, watching: Callable[[], Watcher]) -> None:
    lie = {"do": "lie", "at": [10.35, 2.70], "height": 0.5, "seconds": 40.0}
    tree = {
        "name": "a short night",
        "devices": [
            {"kind": "floor", "id": "floor-1", "noise": 0.02},
            {"kind": "bed", "id": "bed", "area": [9.3, 2.2, 11.4, 3.2], "noise": 0.2},
        ],
        "people": [
            {
                "name": "person-1",
                "start": [9.9, 3.75],
                "steps": [
                    {"do": "wait", "seconds": 5.0}, lie, {"do": "wait", "seconds": 50.0}, lie,
                    {"do": "wait", "seconds": 20.0},
                ],
            }
        ],
    }  # fmt: skip
    watcher = watching()
    watcher.hear(play(scene_from_tree(tree), 155.0), 155.0)
    for thing in ("bed", "person-1"):
        stays = stays_of(thing, in_order(watcher.told), UNIX + 155.0)
        night = night_of(thing, (UNIX, UNIX + 155.0), stays, UNIX + 155.0)
        (up,) = night.times_up
        assert (up.left - UNIX, (up.back or 0.0) - UNIX) == pytest.approx((45.0, 95.0), abs=1.0)
        assert night.rose == pytest.approx(UNIX + 135.0, abs=1.0)
        assert night.in_bed == pytest.approx(80.0, abs=3.0)
