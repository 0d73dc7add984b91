from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from housefly.lab.safety_case.wired_flight import wired_violations
from housefly.record.truth import ContactRecord, TrueFlight

BOUNDS = (0.0, 0.0, 10.0, 5.0)
TIME = np.arange(0.0, 10.0, 0.02)
HEIGHT = np.interp(TIME, [0.0, 2.0, 7.0, 9.0], [0.05, 1.1, 1.1, 0.05])
FLOWN = TrueFlight(
    time=TIME,
    position=np.stack([np.full_like(TIME, 5.0), np.full_like(TIME, 2.5), HEIGHT], axis=1),
    airborne=(TIME > 0.0) & (TIME < 9.1),
    solid=np.full_like(TIME, 0.5),
    person=np.full_like(TIME, np.nan),
    contacts=(),
)


def judged(**changes: object) -> tuple[str, ...]:
    """Return what is wrong with a flight that went otherwise."""
    flight = replace(FLOWN, **changes)  # type: ignore[arg-type]
    return wired_violations(flight, BOUNDS, 1.0, "when the flight ended")


def moved(axis: int, since: float, value: float) -> np.ndarray:
    """Return the places of a drone of which one coordinate is another from a time on [m]."""
    places = FLOWN.position.copy()
    places[since <= TIME, axis] = value
    return places


def test_a_service_that_ends_on_the_floor_is_safe() -> None:
    assert judged() == ()


TOUCH = ContactRecord(5.0, "solid", "bed", 0.3, 0.5, 0.1, motors_turned=True)
STRUCK = [
    ({"contacts": (TOUCH,)}, "I1: touched solid bed"),
    ({"position": moved(0, 5.0, 12.0)}, "I2: 2.0 m outside the room"),
    ({"airborne": FLOWN.airborne & (TIME < 5.0)}, "I4: the motors stopped at 1.1 m"),
    ({"airborne": FLOWN.airborne | (TIME > 9.5)}, "I8: took off again without an order"),
    ({"position": moved(2, 7.0, 0.05)}, "fall: came down at 6.6 m/s"),
    ({"airborne": TIME > 0.0}, "end: at 0.1 m when the flight ended"),
    ({"position": moved(2, 8.0, 0.6)}, "end: at 0.6 m when the flight ended"),
]


@pytest.mark.parametrize(("changes", "words"), STRUCK, ids=[words for _, words in STRUCK])
def test_each_thing_that_must_not_happen_is_found(changes: dict[str, object], words: str) -> None:
    assert words in judged(**changes)


def test_a_drone_that_nothing_keeps_in_the_air_may_fall_and_no_more() -> None:
    fallen = replace(FLOWN, position=moved(2, 7.0, 0.05))
    ends = (BOUNDS, 1.0, "when the flight ended")
    assert wired_violations(fallen, *ends, cannot_hover=True) == ()
    outside = replace(FLOWN, position=moved(0, 5.0, 12.0))
    assert wired_violations(outside, *ends, cannot_hover=True) == ("I2: 2.0 m outside the room",)


def test_what_is_touched_with_motors_at_rest_and_one_sample_of_a_flight_are_no_harm() -> None:
    one = {name: getattr(FLOWN, name)[:1] for name in ("time", "position", "solid", "person")}
    assert judged(contacts=(replace(TOUCH, motors_turned=False),)) == ()
    assert judged(**one, airborne=np.array([False])) == ()
