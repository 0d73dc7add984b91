"""A door stands open too long."""

from __future__ import annotations

from housefly.hub.situations.door import DOOR_HEARTBEAT, OPEN_TOO_LONG, Doors
from housefly.messages import Observation, RoomEvent

Item = Observation | RoomEvent


def state(at: float, is_open: bool, source: str = "door") -> Observation:
    return Observation(source, source, at, at, facts=(("open", is_open),))


def watch(*items: Item, until: float) -> tuple[Doors, list[tuple[str, str, float]]]:
    doors, told, rows = Doors({"fridge": 30.0}), [], list(items)
    for now in (step * 0.25 for step in range(round(until * 4) + 1)):
        while (
            rows
            and (rows[0].captured_at if isinstance(rows[0], Observation) else rows[0].at) <= now
        ):
            doors.add(rows.pop(0))
        told += [(event.kind, event.thing, event.at) for event in doors.update(now)]
    return doors, told


def test_a_door_that_stays_open_is_told_once_and_its_closing_too() -> None:
    rows = (
        state(0, False),
        state(5, True),
        *(state(at, True) for at in range(25, 100, 20)),
        state(101, False),
    )
    _, told = watch(*rows, until=120)
    assert told == [
        ("door open too long", "door", 5.0 + OPEN_TOO_LONG),
        ("door open too long ended", "door", 101.0),
    ]


def test_a_door_that_is_closed_in_time_is_nothing() -> None:
    assert (
        watch(state(0, True), state(50, False), state(51, True), state(100, False), until=200)[1]
        == []
    )


def test_events_count_as_states_do() -> None:
    _, told = watch(
        RoomEvent("door opened", "door", 5.0, "door"),
        RoomEvent("door closed", "door", 80.0, "door"),
        until=90,
    )
    assert [kind for kind, _, _ in told] == ["door open too long", "door open too long ended"]


def test_a_refrigerator_has_a_limit_of_its_own() -> None:
    assert watch(state(0, True, "fridge"), until=40)[1] == [("door open too long", "fridge", 30.0)]


def test_a_silent_contact_is_not_believed_for_ever() -> None:
    doors, told = watch(state(0, True), until=3 * DOOR_HEARTBEAT)
    (claim,) = doors.active()
    assert 0.25 < claim.confidence < 0.5 and dict(claim.facts)["open_since"] == 0.0
    doors, told = watch(state(0, True), until=5 * DOOR_HEARTBEAT)
    assert [kind for kind, _, _ in told] == [
        "door open too long",
        "door open too long ended",
    ] and doors.active() == ()


def test_a_bouncing_contact_ends_nothing() -> None:
    rows = (state(0, True), state(70, False), state(70.2, True))
    assert len(watch(*rows, until=71)[1]) == 1


def test_what_others_say_of_a_door_and_invalid_words_do_not_count() -> None:
    other = Observation("door", "camera", 0.0, 0.0, facts=(("open", True),))
    broken = Observation("door", "door", 0.0, 0.0, valid=False, facts=(("open", True),))
    assert watch(other, broken, until=100)[1] == []


def test_a_window_with_a_contact_may_stand_open_all_day() -> None:
    contact = (("open", True), ("kind", "contact"))
    rows = (Observation("window", "window", at, at, facts=contact) for at in range(0, 300, 30))
    assert watch(*rows, until=300)[1] == []
